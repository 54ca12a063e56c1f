// Renders a scene on a device: once by render(), or many times with other settings by a Session.
#pragma once

#include "ajar/device.hpp"
#include "ajar/scene_file.hpp"
#include "base/events.hpp"
#include "image/image.hpp"
#include "radiosity/settings.hpp"
#include "render/settings.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace ajar {

struct RenderResult {
    // Layers: "" (R, G, B, A: linear Rec. 709 radiance, premultiplied) and "variance" (of the pixel's mean);
    // with settings.aovs also "albedo" "normal" "position" "depth" "emission" "object_id" "material_id"
    // "samples". Its metadata holds what reproduces it, and no clock.
    Image image;
    std::uint32_t samples = 0;  // per pixel, done
    bool interrupted = false;   // the progress callback said stop
    bool out_of_time = false;   // settings.time_limit was reached
    double prepare_seconds = 0; // building the hierarchy and uploading
    double render_seconds = 0;
    double learning_seconds = 0; // part of those: what light sampler visibility learns, once for a session
    std::uint64_t rays = 0;      // traced, shadow rays included
    std::uint64_t shadow_rays = 0;
    std::uint64_t shadow_rays_open = 0; // that reached their light
    // What should not happen; 0 in a good render.
    std::uint64_t invalid_samples = 0;   // NaN, infinite or negative: counted as black
    std::uint32_t first_invalid[3] = {}; // pixel's x and y, and the sample, of the first that was met
    std::uint64_t saturated_samples = 0; // brighter than 2^24: cut there
    std::uint64_t exhausted_loops = 0;   // rays whose search for a hit was given up
    // A JSON document: every setting, the hashes of scene and shaders, device, driver, versions, time per
    // kernel, rays.
    std::string manifest;
};

struct RadiosityResult {
    RadiosityStats stats;
    std::vector<RadiosityIteration> history;
};

// A scene that has been uploaded to a device.
class Session {
  public:
    // Builds the hierarchy and uploads; scene and device must outlive the session. Throws Error when the
    // scene does not fit.
    Session(const SceneFile& scene, const Device& device, const WarningSink& warn = {});
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    // progress: stage "render", in samples per pixel; return false to stop and keep what is done.
    // Integrator "radiosity" shows the last solution, or first solves by RadiositySettings' defaults.
    RenderResult render(const RenderSettings& settings, const ProgressSink& progress = {});

    // Solves for the light of all surfaces by finite elements, every material taken for diffuse.
    // progress: stages "materials", "form factors", "direct light" and "solve"; return false to stop: what is
    // known by then is the solution.
    RadiosityResult solve(const RadiositySettings& settings, const ProgressSink& progress = {});

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// A session for one image.
RenderResult render(const SceneFile& scene, const Device& device, const RenderSettings& settings = {},
                    const ProgressSink& progress = {});

} // namespace ajar
