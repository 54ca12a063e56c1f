// Everything that decides an image, and the few knobs that decide only how fast it comes.
#pragma once

#include <cstdint>
#include <string>

namespace ajar {

enum class PixelFilter : std::uint32_t { box = 0, gaussian = 1, blackman_harris = 2 };

struct RenderSettings {
    std::uint32_t width = 960; // pixels
    std::uint32_t height = 540;
    std::uint32_t samples = 64;     // per pixel
    std::uint32_t first_sample = 0; // renders samples [first_sample, first_sample + samples)
    std::uint32_t seed = 0;
    std::uint32_t max_bounces = 12;      // indirect bounces; 0: emission and direct light
    std::uint32_t rr_depth = 3;          // bounces before Russian roulette begins
    std::string integrator = "path";     // a row of integrators()
    std::string strategy = "mis";        // a row of strategies()
    std::string heuristic = "power";     // a row of heuristics(); strategy mis
    std::string light_sampler = "auto";  // a row of light_sampler_options()
    std::string light_rays = "one";      // a row of light_ray_choices()
    std::string sampler = "sobol";       // a row of samplers()
    // Sampler blue-noise: samples per pixel of all runs that are to be one picture, rounded up to a power of
    // two; 0: of this run alone, first_sample + samples. Others do not look at it.
    std::uint32_t sequence_samples = 0;
    std::string naive_sampling = "bsdf";       // a row of naive_samplings(); integrator naive
    std::string triangle_sampling = "auto";    // a row of triangle_samplings()
    std::string environment_sampling = "auto"; // a row of environment_samplings()
    std::string shading = "smooth";            // a row of shadings(); integrator radiosity
    std::string camera;                        // name or index; empty: the scene's
    PixelFilter filter = PixelFilter::box;
    float filter_radius = 0;         // pixels; 0: the filter's own default
    float background[3] = {0, 0, 0}; // radiance where there is no environment
    float clamp = 0;                 // samples' channels above it are cut there: biased; 0: none
    float ao_distance = 0;           // metres; 0: a tenth of the scene's diagonal (integrator ao)
    bool cull_backfaces = false;     // single-sided surfaces are not there from behind
    bool aovs = false;               // albedo, normal, position, depth, emission, object and material id

    // These never change the image.
    std::uint64_t bake_below_triangles = 1u
                                         << 20; // scenes with fewer triangles are traced without instancing
    double time_limit = 0; // seconds; 0: none. Stops after the sample under way (then fewer samples are done)
    std::uint32_t pool_paths = 0;    // paths in flight; 0: chosen by device
    std::uint32_t segment_paths = 0; // paths per segment; 0: chosen by device
    double slice_seconds = 0.25;     // aimed length of one submission

    bool operator==(const RenderSettings&) const = default;
};

} // namespace ajar
