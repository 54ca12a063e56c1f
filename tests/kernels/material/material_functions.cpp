#include "material_functions.hpp"

#include <cstring>
#include <test_kernels.hpp>

namespace ajar::test {

namespace {

template <class T> void append(std::vector<glm::uvec4>& words, const T& record) {
    static_assert(sizeof(T) % sizeof(glm::uvec4) == 0);
    const std::size_t first = words.size();
    words.resize(first + sizeof(T) / sizeof(glm::uvec4));
    std::memcpy(words.data() + first, &record, sizeof(T));
}

template <class T>
gpu::Buffer upload(const gpu::Device& device, const std::vector<T>& values, const char* label) {
    gpu::Buffer buffer(device, values.size() * sizeof(T), label);
    buffer.write(std::span<const T>(values));
    return buffer;
}

} // namespace

std::vector<glm::vec4> MaterialFunctions::run(std::uint32_t function, const TestMaterials& scene,
                                              std::uint32_t index, const std::vector<glm::vec4>& uv,
                                              const glm::vec4& vertex_color, std::uint32_t features) {
    std::vector<glm::uvec4> words;
    for (const shared::MaterialRecord& material : scene.materials) append(words, material);
    shared::FrameRecord frame{};
    frame.textures_first = static_cast<std::uint32_t>(words.size());
    std::vector<Texel> texels(1); // in front, so that first_texel matters
    for (const TestTexture& texture : scene.textures) {
        append(words,
               shared::TextureRecord{static_cast<std::uint32_t>(texels.size()), texture.width, texture.height,
                                     texture.flags, texture.row_u, 0, texture.row_v, 0});
        texels.insert(texels.end(), texture.texels.begin(), texture.texels.end());
    }
    const gpu::Buffer materials = upload(device(), words, "materials");
    const gpu::Buffer texel_buffer = upload(device(), texels, "texels");
    frame.materials.address = materials.address();
    frame.texels.address = texel_buffer.address();
    const gpu::Buffer frame_buffer = upload(device(), std::vector{frame}, "frame");
    const gpu::Buffer in = upload(device(), uv, "items in");

    gpu::Bindings bindings(device());
    bindings.uniform(frame_buffer);
    bindings.table(shared::BIND_MATERIALS, materials);
    bindings.table(shared::BIND_TEXELS, texel_buffer);
    std::vector<glm::vec4> results[2];
    for (const std::uint32_t texel_buffers : {0u, 1u}) {
        const auto& kernel =
            kernels_
                .try_emplace({function, features, texel_buffers}, device(), gpu::test_kernels(),
                             "material_functions",
                             gpu::Specialization{{shared::SPEC_WORKGROUP_SIZE, WORKGROUP_SIZE},
                                                 {shared::SPEC_TEXEL_BUFFERS, texel_buffers},
                                                 {shared::SPEC_FEATURES, features},
                                                 {shared::SPEC_OPTION, function}})
                .first->second;
        const std::uint64_t words_out = uv.size() * shared::MATERIAL_WORDS;
        const gpu::Buffer out(device(), words_out * sizeof(glm::vec4), "items out");
        gpu::Commands commands(device());
        commands.bind(bindings);
        const auto count = static_cast<std::uint32_t>(uv.size());
        kernel.dispatch(commands, {{in.address()}, {out.address()}, vertex_color, count, index},
                        groups_of(count));
        commands.submit();
        results[texel_buffers] = out.read<glm::vec4>(0, words_out);
    }
    // The driver may convert 8 bits to float in two ways, one rounding apart.
    for (std::size_t k = 0; k < results[0].size(); ++k) {
        for (int channel = 0; channel < 4; ++channel) {
            const float a = results[0][k][channel];
            EXPECT_NEAR(a, results[1][k][channel], 1e-6f * (1 + std::abs(a)));
        }
    }
    return results[1];
}

std::vector<glm::vec4> MaterialFunctions::sample(const TestTexture& texture,
                                                 const std::vector<glm::vec4>& uv) {
    TestMaterials scene;
    scene.textures = {texture};
    const auto words = run(shared::MATERIAL_TEXTURE, scene, 0, uv);
    std::vector<glm::vec4> samples;
    for (std::size_t k = 0; k < words.size(); k += shared::MATERIAL_WORDS) samples.push_back(words[k]);
    return samples;
}

} // namespace ajar::test
