// Radiosity's times, and how far its patches are from a path tracer's, on a glTF file:
//   bench_radiosity FILE.gltf PATCHES... [--rays N] [--shadow-samples N] [--reference N] [--solver NAME]
// Prints a row for each number of patches. --reference: paths from each patch, for the error of its radiance:
// of the mean radiance, the mean over patches by area of |L - L_ref|, and its root mean square less what the
// reference's own variance puts into it.
#include "base/clock.hpp"
#include "gpu/device.hpp"
#include "import/import.hpp"
#include "radiosity/radiosity.hpp"
#include "render/luminance.hpp"

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdio>
#include <glm/gtc/constants.hpp>
#include <sys/resource.h>

using namespace ajar;

namespace {

double peak_gigabytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / (1 << 20);
}

double cpu_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

struct Errors {
    double mean = 0;     // |L - L_ref|
    double rms = 0;      // less the reference's noise
    double smallest = 0; // the mean error that the reference's noise alone would make
};

Errors errors_of(const gpu::Device& device, const Scene& scene, const RadiositySolution& solution,
                 std::uint32_t samples) {
    std::vector<SceneElement> elements;
    std::vector<std::uint32_t> sides;
    for (std::uint32_t side = 0; side < solution.active.size(); ++side) {
        if (solution.active[side] == 0) continue;
        const Patch& patch = solution.mesh.patches[side / 2];
        const PatchSource& source = solution.mesh.sources[patch.source];
        SceneElement e{source.instance,
                       source.triangle,
                       side % 2 == 1 ? shared::ELEMENT_BACK : 0u,
                       patch.corners[0],
                       patch.corners[1] - patch.corners[0],
                       patch.corners[2] - patch.corners[0]};
        if (mirrors(scene.instances[source.instance].to_world)) // patches know the triangle as it is placed
            for (glm::vec2* at : {&e.origin, &e.edge_a, &e.edge_b}) *at = glm::vec2(at->y, at->x);
        elements.push_back(e);
        sides.push_back(side);
    }
    RenderSettings settings;
    settings.samples = samples;
    settings.max_bounces = 64;
    settings.rr_depth = 5;
    settings.seed = 12345;
    const ElementRadiance reference = Renderer(device, scene, {}).irradiance(elements, settings);
    double area = 0, brightness = 0, absolute = 0, square = 0, noise = 0, smallest = 0;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const glm::dvec3 rho(solution.reflectance[sides[i]]);
        if (rho == glm::dvec3(0)) continue; // nothing reflected to compare
        const double a = solution.mesh.patches[sides[i] / 2].area;
        const double right = luminance(rho * glm::dvec3(reference.irradiance[i])) / glm::pi<double>();
        const double found = luminance(rho * glm::dvec3(solution.irradiance[sides[i]])) / glm::pi<double>();
        // Channels of a path go together: their deviations add.
        const double deviation =
            luminance(rho * glm::sqrt(glm::dvec3(reference.variance[i]))) / glm::pi<double>();
        area += a;
        brightness += a * right;
        absolute += a * std::abs(found - right);
        square += a * (found - right) * (found - right);
        noise += a * deviation * deviation;
        smallest += a * deviation * std::sqrt(2 / glm::pi<double>());
    }
    const double mean = brightness / area;
    return {absolute / area / mean, std::sqrt(std::max(square - noise, 0.0) / area) / mean,
            smallest / area / mean};
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app("Radiosity's times and errors");
    std::string file;
    std::vector<std::uint32_t> patches;
    RadiositySettings settings;
    std::uint32_t reference = 0;
    app.add_option("file", file, "glTF")->required();
    app.add_option("patches", patches)->required();
    app.add_option("--rays", settings.rays);
    app.add_option("--shadow-samples", settings.shadow_samples);
    app.add_option("--reference", reference);
    app.add_option("--solver", settings.solver);
    app.add_option("--direct", settings.direct);
    app.add_option("--memory", settings.memory_bytes, "bytes for rows");
    app.add_option("--refine", settings.refine);
    app.add_option("--refine-threshold", settings.refine_threshold);
    app.add_option("--tolerance", settings.tolerance);
    CLI11_PARSE(app, argc, argv);
    const Scene scene = import_gltf(file).scene;
    const gpu::Device device;
    std::printf("%8s %8s %6s | %7s %7s %7s %7s %7s | %4s %8s | %6s %6s | %7s %7s %7s | %s\n", "patches",
                "rows", "rays", "prepare", "mater.", "factors", "direct", "solve", "it.", "cpu s", "rows GB",
                "RSS GB", "recip.", "expect", "in/out", "error: mean, rms, reference's noise");
    for (const std::uint32_t count : patches) {
        settings.patches.patches = count;
        const double cpu = cpu_seconds();
        const RadiositySolution s = solve_radiosity(device, scene, settings);
        const RadiosityStats& t = s.stats;
        std::printf("%8zu %8zu %6u | %7.2f %7.2f %7.2f %7.2f %7.2f | %4u %8.2f | %6.3f %6.2f | %7.4f %7.4f "
                    "%7.4f | ",
                    static_cast<std::size_t>(t.patches), static_cast<std::size_t>(t.sides), settings.rays,
                    t.prepare_seconds, t.material_seconds, t.form_factor_seconds, t.direct_seconds,
                    t.solve_seconds, t.iterations, cpu_seconds() - cpu,
                    static_cast<double>(t.row_bytes) / (1 << 30), peak_gigabytes(), t.reciprocity_rms,
                    t.reciprocity_expected, (t.power_absorbed + t.power_escaped) / t.power_in);
        if (reference > 0) {
            const Errors e = errors_of(device, scene, s, reference);
            std::printf("%.4f %.4f %.4f", e.mean, e.rms, e.smallest);
        }
        std::printf("\n");
        std::fflush(stdout);
    }
}
