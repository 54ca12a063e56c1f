// Materials and textures on the device as a test wants them, read both ways (texel buffers and pointers), and
// the functions of shaders/material over many texture coordinates (shaders/material_functions.comp).
#pragma once

#include "shaders/material_functions.glsl.h"
#include "shaders/shared/bindings.glsl.h"
#include "shaders/shared/material.glsl.h"
#include "shaders/shared/specialization.glsl.h"
#include "support/gpu_test.hpp"

#include <array>
#include <map>
#include <vector>

namespace ajar::test {

using Texel = glm::u8vec4;

struct TestTexture {
    std::uint32_t width = 1;
    std::uint32_t height = 1;
    std::vector<Texel> texels;
    std::uint32_t flags = 0; // of TextureRecord
    glm::vec3 row_u{1, 0, 0};
    glm::vec3 row_v{0, 1, 0};
};

struct TestMaterials {
    std::vector<shared::MaterialRecord> materials{{}}; // at least one, as in every scene
    std::vector<TestTexture> textures;
};

inline constexpr std::uint32_t ALL_FEATURES = shared::FEATURE_TEXTURES | shared::FEATURE_NORMAL_MAPS |
                                              shared::FEATURE_EMISSION_TEXTURES | shared::FEATURE_SPECULAR;

class MaterialFunctions : public GpuTest {
  public:
    static void TearDownTestSuite() {
        kernels_.clear();
        GpuTest::TearDownTestSuite();
    }

  protected:
    // MATERIAL_WORDS words per item. Fails the test where the two ways of reading tables differ.
    static std::vector<glm::vec4> run(std::uint32_t function, const TestMaterials& scene, std::uint32_t index,
                                      const std::vector<glm::vec4>& uv,
                                      const glm::vec4& vertex_color = glm::vec4(1),
                                      std::uint32_t features = ALL_FEATURES);
    // texture_sample of texture 0 at uv0.
    static std::vector<glm::vec4> sample(const TestTexture& texture, const std::vector<glm::vec4>& uv);

  private:
    // Compiled once: a driver takes longer over that than over most runs.
    inline static std::map<std::array<std::uint32_t, 3>, gpu::Kernel<shared::MaterialFunctionsArgs>> kernels_;
};

} // namespace ajar::test
