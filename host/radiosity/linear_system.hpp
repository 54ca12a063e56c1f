// The system x = b + rho F x on the device, and the steps of its solvers. Every product is of the same rows
// in the same order, so solvers differ in their way alone.
#pragma once

#include "radiosity/form_factors.hpp"
#include "radiosity/patch_materials.hpp"
#include "shaders/kernels/measure.glsl.h"
#include "shaders/kernels/shoot.glsl.h"
#include "shaders/kernels/update.glsl.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ajar {

// Of all rows.
struct SystemMeasure {
    double max_rest = 0; // as RowsMeasure
    double max_value = 0;
    double rest_power = 0;
    double power = 0;
    double max_rest_power = 0;
};

class LinearSystem {
  public:
    LinearSystem(RadiosityRig& rig, FormFactors& factors, const PatchMaterials& materials);

    // x = rest = b.
    void begin(std::span<const glm::vec3> source);

    // Gauss-Seidel by blocks of consecutive rows: each sees what those before it found; one block: Jacobi.
    // False: stopped, with some blocks done.
    bool gather(std::uint32_t blocks, const FormFactors::KeepGoing& keep_going);

    // Progressive refinement: sides with at least half of the greatest unshot power shoot what they have.
    // Returns how many; none: nothing is left, or it was stopped.
    std::uint32_t shoot(double max_rest_power, const FormFactors::KeepGoing& keep_going);

    SystemMeasure measure();
    std::vector<glm::vec3> solution() const { return read(solution_); }
    std::vector<glm::vec3> rest() const { return read(rest_); }

    // F x, and the share of each row's rays that met no patch. False: stopped.
    bool receive_solution(std::vector<glm::vec3>& received, std::vector<float>& lost,
                          const FormFactors::KeepGoing& keep_going);

    std::uint64_t device_bytes() const;

  private:
    gpu::Buffer make_vector(const char* label) const;
    void update(const gpu::Kernel<shared::UpdateArgs>& kernel, std::uint32_t first, std::uint32_t count);
    std::vector<glm::vec3> read(const gpu::Buffer& vector) const;

    RadiosityRig& rig_;
    FormFactors& factors_;
    const PatchMaterials& materials_;
    gpu::Buffer source_;
    gpu::Buffer solution_;
    gpu::Buffer rest_;
    gpu::Buffer received_;
    gpu::Buffer shot_;
    gpu::Buffer shooters_;
    gpu::Buffer measures_;
    gpu::Kernel<shared::UpdateArgs> update_gather_;
    gpu::Kernel<shared::UpdateArgs> update_shoot_;
    gpu::Kernel<shared::ShootArgs> shoot_;
    gpu::Kernel<shared::MeasureArgs> measure_;
};

} // namespace ajar
