// What decides a radiosity solution, and what is told about how it came. Plain data, for the public interface
// too.
#pragma once

#include "render/settings.hpp"

#include <cstdint>
#include <string>

namespace ajar {

// At least one of the two; with both, both hold.
struct PatchOptions {
    float patch_size = 0;      // metres: no edge is longer; 0: no limit
    std::uint32_t patches = 0; // at least so many (where floats can tell their corners apart)
};

struct RadiositySettings {
    PatchOptions patches{0, 10000};
    std::uint32_t refine = 0;            // times that patches with a high gradient are halved
    float refine_threshold = 0.1f;       // difference between a patch's corners, of the scene's mean radiance
    std::string solver = "gauss-seidel"; // a row of radiosity_solvers()
    std::string direct = "shadow-rays";  // a row of radiosity_directs()
    std::uint32_t rays = 256;            // of a row of form factors; a power of two, 4 to 65536
    std::uint32_t shadow_samples = 128;  // paths to luminaires from each side
    float tolerance = 1e-4f; // of the greatest value: the error of the solution is estimated below
    std::uint32_t max_iterations = 1000;
    // For rows of form factors. What does not fit is computed again in every iteration: the same result.
    std::uint64_t memory_bytes = std::uint64_t{2} << 30;
    // Of these: seed, background, cull_backfaces, how lights are sampled (strategy, heuristic, light_sampler,
    // light_rays, sampler, triangle_sampling), and what never changes a result (pool, segments, slices).
    RenderSettings render{};
};

// What a solver had done, and what was left to do, when it was measured.
struct RadiosityIteration {
    std::uint32_t mesh = 0;      // refinements before
    std::uint32_t iteration = 0; // 0: before the first
    std::uint64_t rows = 0;      // of form factors used so far (shooting: columns, one for each shooter)
    double residual = 0;         // greatest change or unshot radiance, of the greatest value
    double residual_power = 0;   // the same of powers (luminance)
    double error = 0;            // estimate of how far the solution is from its end, of the greatest value
    double power = 0;            // that leaves all sides, luminance, W; without light by shadow rays
};

struct RadiosityStats {
    RadiositySettings settings;
    bool interrupted = false; // the progress callback said stop
    bool converged = false;
    std::uint32_t iterations = 0; // of the last mesh
    std::uint64_t patches = 0;
    std::uint64_t sides = 0;       // that take part: rows
    std::uint64_t rows_stored = 0; // the others were computed again in every iteration
    std::uint64_t row_bytes = 0;   // stored
    std::uint64_t device_bytes = 0;
    std::uint64_t form_factor_rays = 0;
    double sky_share = 0;     // of those rays that left the scene
    double nowhere_share = 0; // that met nothing with patches, or went below their surface
    // A_i F_ij = A_j F_ji, over pairs of sides that see much of each other: their difference, and the one that
    // the number of rays leads to expect; root mean squares, of the mean of both.
    double reciprocity_rms = 0;
    double reciprocity_expected = 0;
    double reciprocity_max = 0;
    std::uint64_t reciprocity_pairs = 0;
    // W, luminance: what is brought to patches and what is done with it. Equal but for the noise of F.
    double power_in = 0;
    double power_absorbed = 0;
    double power_escaped = 0;
    double prepare_seconds = 0; // patches, hierarchy, upload
    double material_seconds = 0;
    double form_factor_seconds = 0;
    double direct_seconds = 0;
    double solve_seconds = 0;
    std::uint64_t exhausted_loops = 0;
    std::uint64_t invalid_samples = 0; // of direct light: NaN, Inf or negative, dropped
};

} // namespace ajar
