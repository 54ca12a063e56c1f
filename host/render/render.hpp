// Renders a scene: uploads it once, then traces samples until they are done, interrupted or out of time.
#pragma once

#include "base/events.hpp"
#include "gpu/commands.hpp"
#include "image/image.hpp"
#include "render/settings.hpp"
#include "render/surface_index.hpp"
#include "scene/scene.hpp"
#include "shaders/shared/patch.glsl.h"

#include <memory>
#include <span>
#include <vector>

namespace ajar {

// A row of a table that --help prints; the renderer accepts exactly the names in it.
struct Choice {
    const char* name;
    const char* help;
};
std::span<const Choice> integrators();
std::span<const Choice> strategies();
std::span<const Choice> heuristics();
std::span<const Choice> light_samplers();
std::span<const Choice> light_sampler_options(); // those, and one that chooses among them
std::span<const Choice> light_ray_choices();
std::span<const Choice> samplers();
std::span<const Choice> naive_samplings();
std::span<const Choice> triangle_samplings();
std::span<const Choice> shadings();
std::span<const Choice> environment_samplings();
std::span<const Choice> pixel_filters();

// Throws Error for settings with which no scene can be rendered: unknown names, numbers out of range, choices
// that exclude each other.
void check_settings(const RenderSettings& settings);

struct RenderStats {
    RenderSettings settings;   // as used: what was left to a default has its value
    std::uint32_t samples = 0; // per pixel, done
    bool interrupted = false;  // the progress callback said stop
    bool out_of_time = false;
    double prepare_seconds = 0; // hierarchy and upload
    double render_seconds = 0;
    double bvh_seconds = 0;
    double light_tree_seconds = 0;
    double learning_seconds = 0; // part of render_seconds: light sampler visibility
    std::uint64_t triangles = 0;
    std::uint64_t lights = 0;
    std::uint64_t device_bytes = 0;
    std::uint64_t camera_rays = 0;
    std::uint64_t extension_rays = 0; // camera rays included
    std::uint64_t shadow_rays = 0;
    std::uint64_t shadow_rays_open = 0; // that reached their light
    std::uint64_t invalid_samples = 0;  // NaN, Inf or negative: dropped
    std::uint32_t invalid_pixel = 0;    // of the first: x | y << 16
    std::uint32_t invalid_sample = 0;
    std::uint64_t saturated_samples = 0;
    std::uint64_t exhausted_loops = 0;
    gpu::Profile profile; // device time per kernel
};

// The image has layers "" (R, G, B, A) and "variance"; with aovs also "albedo" "normal" "position" "depth"
// "emission" "object_id" "material_id" "samples".
struct RenderOutput {
    Image image;
    RenderStats stats;
};

// By element. With integrator ao `irradiance` is the share of directions, by the cosine around the shading
// normal, that are open.
struct ElementRadiance {
    std::vector<glm::vec3> irradiance; // W/m^2: of light from the side of the element, on its shading normal
    std::vector<glm::vec3> variance;   // of that mean
    RenderStats stats;
};

// Means over elements, by element, where their material is there at all.
struct ElementMaterials {
    std::vector<glm::vec3> emission;    // W/(m^2 sr), along the normal; of unlit materials what they show
    std::vector<glm::vec3> reflectance; // share of diffuse light from all around that is reflected, 0 to 1
};

// The scene's surfaces as patches and what they look like, for integrator radiosity (shared/patch.glsl.h).
struct PatchPicture {
    std::vector<TriangleSource> divided;  // the triangles that have patches, by instance and triangle
    std::vector<shared::PatchNode> nodes; // the roots of their trees first, in that order
    std::vector<shared::PatchSide> sides; // two for each patch
};

// A scene on a device, ready to be rendered with any settings.
class Renderer {
  public:
    // Builds the hierarchy and uploads. Throws Error when the scene is invalid or does not fit.
    Renderer(const gpu::Device& device, const Scene& scene, const WarningSink& warn);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    // progress: stage "render", in samples per pixel; return false to stop. Throws Error (unknown names,
    // device lost).
    RenderOutput render(const RenderSettings& settings, const ProgressSink& progress = {});

    // What integrator radiosity shows from now on.
    void show(PatchPicture patches);
    // The mean over each element of the light that arrives there, by paths that begin on them: with
    // max_bounces 0 straight from luminaires, else after up to so many bounces. What elements themselves
    // emit, absorb or are made of does not count. Meshes are baked; what settings say of the picture and its
    // camera is not looked at. Integrators path, direct and ao; Error for others. Elements must be of the
    // scene's triangles.
    ElementRadiance irradiance(std::span<const SceneElement> elements, const RenderSettings& settings,
                               const ProgressSink& progress = {});

    // What the same elements are made of.
    ElementMaterials materials(std::span<const SceneElement> elements, const RenderSettings& settings);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace ajar
