// Runs a function of shaders/lights over many items (shaders/light_functions.comp), on tables as the renderer
// builds them.
#pragma once

#include "bvh/bvh.hpp"
#include "render/choices.hpp"
#include "render/environment_table.hpp"
#include "render/light_table.hpp"
#include "render/material_table.hpp"
#include "render/render.hpp"
#include "shaders/light_functions.glsl.h"
#include "shaders/shared/bindings.glsl.h"
#include "shaders/shared/frame.glsl.h"
#include "shaders/shared/path.glsl.h"
#include "shaders/shared/specialization.glsl.h"
#include "support/gpu_test.hpp"

#include <random>
#include <test_kernels.hpp>
#include <vector>

namespace ajar::test {

using shared::LightItem;

// Its front is where its corners run counter-clockwise.
inline EmissiveTriangle triangle(glm::vec3 p0, glm::vec3 p1, glm::vec3 p2, float emission = 1) {
    EmissiveTriangle t;
    t.p0 = p0;
    t.p1 = p1;
    t.p2 = p2;
    t.area = 0.5f * glm::length(glm::cross(p1 - p0, p2 - p0));
    t.emission = glm::vec3(emission);
    t.triangle = 17;
    return t;
}

struct Lighting {
    Scene scene; // lights, environment, and what textured emission needs
    std::vector<EmissiveTriangle> triangles;
    std::vector<shared::SurfaceRecord> surfaces;
    float scene_radius = 1;
    std::uint32_t sampler = shared::LIGHT_SAMPLER_POWER;
    std::uint32_t features = 0; // besides those of the kinds of light; FEATURE_WIDE_TRIANGLES only from here
    std::vector<EmissiveSphere> spheres;
    EnvironmentDensity environment_density = EnvironmentDensity::radiance;
    LightTable table() const { return build_light_table(scene, triangles, scene_radius, spheres); }
};

// Every row of the table that --light-sampler accepts.
inline std::vector<std::uint32_t> all_light_samplers() {
    std::vector<std::uint32_t> constants;
    for (const Choice& row : light_samplers()) constants.push_back(find_light_sampler(row.name));
    return constants;
}

class LightFunctions : public GpuTest {
  protected:
    static std::vector<LightItem> run(std::uint32_t function, const Lighting& lighting,
                                      std::vector<LightItem> items) {
        const LightTable table = lighting.table();
        shared::FrameRecord frame{};
        table.describe(frame);
        frame.environment_cos = 1;
        frame.scene_radius = lighting.scene_radius;
        frame.soft_first = table.soft_first;
        frame.soft_count = table.soft_count;
        const std::uint32_t features = (table.features & ~shared::FEATURE_WIDE_TRIANGLES) | lighting.features;
        EnvironmentTable environment;
        if (lighting.scene.environment) {
            const Environment& e = *lighting.scene.environment;
            environment = build_environment_table(e, lighting.environment_density);
            frame.environment_width = environment.width;
            frame.environment_height = environment.height;
            frame.environment_scale = e.scale;
            frame.environment_cos = std::cos(e.rotation);
            frame.environment_sin = std::sin(e.rotation);
            if (environment.width == 0) frame.background = e.scale;
        }
        const MaterialTable materials = build_material_table(lighting.scene);
        frame.textures_first =
            static_cast<std::uint32_t>(materials.materials.size()) * shared::MATERIAL_TEXELS;
        std::vector<glm::uvec4> material_words = words(materials.materials);
        const std::vector<glm::uvec4> textures = words(materials.textures);
        material_words.insert(material_words.end(), textures.begin(), textures.end());

        gpu::Bindings bindings(device());
        std::vector<gpu::Buffer> buffers;
        buffers.reserve(8);
        const auto upload = [&](std::uint32_t binding, const auto& values) {
            if (values.empty()) return;
            gpu::Buffer& buffer = buffers.emplace_back(device(), values.size() * sizeof(values[0]), "table");
            buffer.write(std::span(values.data(), values.size()));
            bindings.table(binding, buffer);
        };
        upload(shared::BIND_LIGHTS, table.words());
        upload(shared::BIND_ENVIRONMENT, environment.words);
        upload(shared::BIND_MATERIALS, material_words);
        upload(shared::BIND_TEXELS, materials.texels);
        upload(shared::BIND_SURFACES, lighting.surfaces);
        // What was learned may be anything: no probability may depend on its being right.
        std::vector<glm::uvec4> learned;
        if (lighting.sampler == shared::LIGHT_SAMPLER_VISIBILITY) {
            std::mt19937 random(41);
            learned.resize(shared::VISIBILITY_CELLS * shared::VISIBILITY_CELL_TEXELS);
            for (glm::uvec4& texel : learned) texel = {random(), random(), random(), random()};
        }
        upload(shared::BIND_VISIBILITY, learned);
        std::vector<shared::TriangleRecord> triangles; // as if all triangles of the scene were lights
        for (const EmissiveTriangle& t : lighting.triangles)
            triangles.push_back(bvh::make_record({t.p0, t.p1, t.p2}, 0, 0, 0));
        upload(shared::BIND_TRIANGLES, triangles);
        gpu::Buffer frame_buffer(device(), sizeof frame, "frame");
        frame_buffer.write(std::span<const shared::FrameRecord>(&frame, 1));
        bindings.uniform(frame_buffer);

        const gpu::Kernel<shared::LightFunctionsArgs> kernel(
            device(), gpu::test_kernels(), "light_functions",
            {{shared::SPEC_WORKGROUP_SIZE, WORKGROUP_SIZE},
             {shared::SPEC_OPTION, function},
             {shared::SPEC_LIGHT_SAMPLER, lighting.sampler},
             {shared::SPEC_FEATURES, features | materials.features}});
        gpu::Buffer in_out(device(), items.size() * sizeof(LightItem), "items");
        in_out.write(std::span<const LightItem>(items));
        gpu::Commands commands(device());
        commands.bind(bindings);
        const auto count = static_cast<std::uint32_t>(items.size());
        kernel.dispatch(commands, {{in_out.address()}, count, 0}, groups_of(items.size()));
        commands.submit();
        return in_out.read<LightItem>(0, items.size());
    }

    // `count` samples of one light as seen from a point.
    static std::vector<LightItem> sample(const Lighting& lighting, std::uint32_t light, glm::vec3 point,
                                         std::size_t count, std::uint32_t seed) {
        std::mt19937 random(seed);
        std::vector<LightItem> items(count);
        for (LightItem& item : items) {
            item.point = point;
            item.light = light;
            item.uv.x = uniform(random);
            item.uv.y = uniform(random);
        }
        return run(shared::LIGHTS_SAMPLE, lighting, std::move(items));
    }

    // [0, 1) in steps of 2^-24, as kernels draw it.
    static float uniform(std::mt19937& random) { return static_cast<float>(random() >> 8) * 0x1p-24f; }

    template <class T> static std::vector<glm::uvec4> words(const std::vector<T>& records) {
        static_assert(sizeof(T) % sizeof(glm::uvec4) == 0);
        std::vector<glm::uvec4> result(records.size() * sizeof(T) / sizeof(glm::uvec4));
        if (!records.empty()) std::memcpy(result.data(), records.data(), records.size() * sizeof(T));
        return result;
    }
};

} // namespace ajar::test
