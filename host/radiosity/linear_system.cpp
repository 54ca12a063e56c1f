#include "radiosity/linear_system.hpp"

#include "shaders/shared/radiosity.glsl.h"

#include <algorithm>

namespace ajar {

using namespace shared;

LinearSystem::LinearSystem(RadiosityRig& rig, FormFactors& factors, const PatchMaterials& materials)
    : rig_(rig), factors_(factors), materials_(materials), source_(make_vector("source of radiosity")),
      solution_(make_vector("radiosity")), rest_(make_vector("rest of radiosity")),
      received_(make_vector("received radiosity")), shot_(make_vector("shot radiosity")),
      shooters_(rig.device, sizeof(SideIndex), "shooters"),
      measures_(rig.device, (factors.row_count() / MEASURE_ROWS + 1) * sizeof(RowsMeasure), "measures"),
      update_gather_(rig.device, "update", rig.plain(UPDATE_GATHER)),
      update_shoot_(rig.device, "update", rig.plain(UPDATE_SHOOT)), shoot_(rig.device, "shoot", rig.plain()),
      measure_(rig.device, "measure", rig.plain()) {}

gpu::Buffer LinearSystem::make_vector(const char* label) const {
    return gpu::Buffer(rig_.device, std::uint64_t{rig_.side_count() + SIDES_BESIDE} * sizeof(SideValue),
                       label);
}

std::vector<glm::vec3> LinearSystem::read(const gpu::Buffer& vector) const {
    std::vector<glm::vec3> values;
    values.reserve(rig_.side_count());
    for (const SideValue& value : vector.read<SideValue>(0, rig_.side_count())) values.push_back(value.rgb);
    return values;
}

void LinearSystem::begin(std::span<const glm::vec3> source) {
    std::vector<SideValue> values;
    values.reserve(source.size() + SIDES_BESIDE);
    for (const glm::vec3& value : source) values.push_back({value, 0});
    for (std::uint32_t k = 0; k < SIDES_BESIDE; ++k) values.push_back({glm::vec3(0), 0});
    source_.write(std::span<const SideValue>(values));
    rest_.write(std::span<const SideValue>(values));
    // A product's scalar then counts the rays that met no patch.
    for (std::uint32_t k = 0; k < SIDES_BESIDE; ++k) values[source.size() + k].scalar = 1;
    solution_.write(std::span<const SideValue>(values));
}

void LinearSystem::update(const gpu::Kernel<UpdateArgs>& kernel, std::uint32_t first, std::uint32_t count) {
    const UpdateArgs args{{factors_.row_side_buffer().address()},
                          {received_.address()},
                          {source_.address()},
                          {materials_.reflectance.address()},
                          {solution_.address()},
                          {rest_.address()},
                          first,
                          count};
    kernel.dispatch(rig_.commands, args, rig_.groups(count));
}

bool LinearSystem::gather(std::uint32_t blocks, const FormFactors::KeepGoing& keep_going) {
    rig_.bind_values(solution_);
    const std::uint64_t rows = factors_.row_count();
    for (std::uint64_t block = 0; block < blocks; ++block) {
        const auto first = static_cast<std::uint32_t>(rows * block / blocks);
        const auto count = static_cast<std::uint32_t>(rows * (block + 1) / blocks) - first;
        if (count == 0) continue;
        if (!factors_.receive(solution_, received_, first, count, keep_going)) return false;
        update(update_gather_, first, count);
    }
    rig_.commands.submit();
    return true;
}

std::uint32_t LinearSystem::shoot(double max_rest_power, const FormFactors::KeepGoing& keep_going) {
    if (!(max_rest_power > 0)) return 0;
    const std::uint32_t rows = factors_.row_count();
    rig_.bind_values(shot_);
    shooters_.clear();
    const ShootArgs args{{factors_.row_side_buffer().address()},
                         {materials_.reflectance.address()},
                         {rest_.address()},
                         {shot_.address()},
                         {shooters_.address()},
                         static_cast<float>(0.5 * max_rest_power),
                         rows};
    shoot_.dispatch(rig_.commands, args, rig_.groups(rows));
    if (!factors_.receive(shot_, received_, 0, rows, keep_going)) return 0;
    update(update_shoot_, 0, rows);
    rig_.commands.submit();
    return shooters_.read<std::uint32_t>(0, 1).front();
}

SystemMeasure LinearSystem::measure() {
    const std::uint32_t rows = factors_.row_count();
    const std::uint32_t threads = (rows + MEASURE_ROWS - 1) / MEASURE_ROWS;
    const MeasureArgs args{{factors_.row_side_buffer().address()},
                           {materials_.reflectance.address()},
                           {solution_.address()},
                           {rest_.address()},
                           {measures_.address()},
                           rows,
                           0};
    measure_.dispatch(rig_.commands, args, rig_.groups(threads));
    rig_.commands.submit();
    SystemMeasure sum;
    for (const RowsMeasure& m : measures_.read<RowsMeasure>(0, threads)) {
        sum.max_rest = std::max<double>(sum.max_rest, m.max_rest);
        sum.max_value = std::max<double>(sum.max_value, m.max_value);
        sum.rest_power += m.rest_power;
        sum.power += m.power;
        sum.max_rest_power = std::max<double>(sum.max_rest_power, m.max_rest_power);
    }
    return sum;
}

bool LinearSystem::receive_solution(std::vector<glm::vec3>& received, std::vector<float>& lost,
                                    const FormFactors::KeepGoing& keep_going) {
    rig_.bind_values(solution_);
    if (!factors_.receive(solution_, received_, 0, factors_.row_count(), keep_going)) return false;
    rig_.commands.submit();
    received.assign(rig_.side_count(), glm::vec3(0));
    lost.assign(rig_.side_count(), 0);
    const std::vector<SideValue> values = received_.read<SideValue>(0, rig_.side_count());
    for (const std::uint32_t side : factors_.row_sides()) {
        received[side] = values[side].rgb;
        lost[side] = values[side].scalar;
    }
    return true;
}

std::uint64_t LinearSystem::device_bytes() const {
    return 5 * solution_.size_bytes() + measures_.size_bytes();
}

} // namespace ajar
