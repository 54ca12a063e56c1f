// A scene on the device: its tables, and the part of the FrameRecord that describes it.
#pragma once

#include "gpu/bindings.hpp"
#include "render/environment_table.hpp"
#include "render/surface_index.hpp"
#include "scene/scene.hpp"
#include "shaders/shared/bindings.glsl.h"
#include "shaders/shared/frame.glsl.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace ajar {

struct GpuSceneOptions {
    bool cull_backfaces = false;
    glm::vec3 background{0, 0, 0}; // a constant environment where the scene has none; radiance
    std::uint64_t bake_below_triangles = 1u << 20;                         // see GeometryOptions
    EnvironmentDensity environment_density = EnvironmentDensity::radiance; // of a map
    bool dark_triangles = false;                   // no triangle emits; other lights, spheres among them, do
    bool operator==(const GpuSceneOptions&) const = default;
};

class GpuScene {
  public:
    // Builds the hierarchy, the lights' distributions and the tables, and uploads them. Throws Error.
    GpuScene(const gpu::Device& device, const Scene& scene, const GpuSceneOptions& options);

    // FEATURE_* bits of everything in the scene.
    std::uint32_t features() const { return features_; }
    std::uint64_t unsure_triangles() const { return unsure_triangles_; } // of alpha or culled from behind
    std::uint32_t stack_registers() const { return stack_registers_; }
    bool suits_shadow_packets() const { return suits_shadow_packets_; }
    // 1: tables are read through texel buffers; 0: one does not fit the device's, so all go through pointers.
    std::uint32_t texel_buffers() const { return texel_buffers_; }
    void bind(gpu::Bindings& bindings) const;
    // The fields that concern the scene; those of camera, film and settings are zero.
    const shared::FrameRecord& frame() const { return frame_; }

    std::uint64_t triangle_count() const { return triangle_sources_.size(); }
    // In leaf order.
    const std::vector<TriangleSource>& triangle_sources() const { return triangle_sources_; }
    std::uint64_t device_bytes() const;
    // Meshes marked as spheres that emit by their triangles all the same, since there are too many.
    std::uint32_t spheres_left_out() const { return spheres_left_out_; }
    double bvh_seconds() const { return bvh_seconds_; }
    double light_tree_seconds() const { return light_tree_seconds_; }

  private:
    struct Host; // the tables before they are uploaded
    void build_geometry(const Scene& scene, const GpuSceneOptions& options, Host& host);
    void place_environment(const std::optional<Environment>& environment, EnvironmentDensity density,
                           Host& host);
    void build_lights(const Scene& scene, const std::optional<Environment>& environment, Host& host,
                      bool dark_triangles);
    void upload(const gpu::Device& device, const Host& host);

    std::array<gpu::Buffer, shared::TABLE_COUNT> tables_; // by binding - BIND_TABLE_FIRST
    shared::FrameRecord frame_{};
    std::uint32_t features_ = 0;
    std::uint64_t unsure_triangles_ = 0;
    std::uint32_t stack_registers_ = 0;
    bool suits_shadow_packets_ = false;
    std::uint32_t texel_buffers_ = 1;
    std::vector<TriangleSource> triangle_sources_;
    std::uint32_t spheres_left_out_ = 0;
    double bvh_seconds_ = 0;
    double light_tree_seconds_ = 0;
};

} // namespace ajar
