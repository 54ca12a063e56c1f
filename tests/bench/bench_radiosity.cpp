// Radiosity's times, and how far its patches are from a path tracer's, on a glTF file:
//   bench_radiosity FILE.gltf PATCHES... [--rays N] [--shadow-samples N] [--reference N] [--solver NAME]
//                   [--plot FILE.svg]
// Prints a row for each number of patches. --reference: paths from each patch, for the error of its radiance,
// which --plot draws.
// Not with --refine, where two seeds make two meshes.
#include "base/file.hpp"
#include "gpu/device.hpp"
#include "image/plot.hpp"
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

// Of the mean radiance that patches reflect, means over their area.
struct Errors {
    double mean = 0;            // |L - L_ref|, with all noise
    double bias = 0;            // root mean square without: residuals of independent pairs, multiplied
    double noise = 0;           // of L: mean absolute
    double reference_noise = 0; // of L_ref
};

Errors errors_of(const gpu::Device& device, const Scene& scene, const RadiositySolution& solution,
                 const RadiositySolution& other, std::uint32_t samples) {
    std::vector<SceneElement> elements;
    std::vector<std::uint32_t> sides;
    for (std::uint32_t side = 0; side < solution.active.size(); ++side) {
        if (solution.active[side] == 0) continue;
        const Patch& patch = solution.mesh.patches[side / 2];
        const PatchSource& source = solution.mesh.sources[patch.source];
        SceneElement e{source.instance,
                       source.triangle,
                       side % 2 == shared::PATCH_BACK ? shared::ELEMENT_BACK : 0u,
                       patch.corners[0],
                       patch.corners[1] - patch.corners[0],
                       patch.corners[2] - patch.corners[0]};
        if (mirrors(scene.instances[source.instance].to_world)) // patches know the triangle as it is placed
            for (glm::vec2* at : {&e.origin, &e.edge_a, &e.edge_b}) *at = glm::vec2(at->y, at->x);
        elements.push_back(e);
        sides.push_back(side);
    }
    ElementRadiance halves[2];
    for (std::uint32_t half = 0; half < 2; ++half) {
        RenderSettings settings;
        settings.samples = samples / 2;
        settings.max_bounces = 64;
        settings.rr_depth = 5;
        settings.seed = 12345 + half;
        halves[half] = Renderer(device, scene, {}).irradiance(elements, settings);
    }
    double area = 0, brightness = 0, absolute = 0, cross = 0, noise = 0, reference_noise = 0;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const std::uint32_t side = sides[i];
        const glm::dvec3 rho(solution.reflectance[side]);
        if (rho == glm::dvec3(0)) continue; // nothing reflected to compare
        const auto reflected = [&](const glm::vec3& e) {
            return luminance(rho * glm::dvec3(e)) / glm::pi<double>();
        };
        const double a = solution.mesh.patches[side / 2].area;
        const double right[2] = {reflected(halves[0].irradiance[i]), reflected(halves[1].irradiance[i])};
        const double found[2] = {reflected(solution.irradiance[side]), reflected(other.irradiance[side])};
        area += a;
        brightness += a * 0.5 * (right[0] + right[1]);
        absolute += a * std::abs(found[0] - 0.5 * (right[0] + right[1]));
        cross += a * (found[0] - right[0]) * (found[1] - right[1]);
        noise += a * std::abs(found[0] - found[1]) / std::sqrt(2.0);
        reference_noise += a * 0.5 * std::abs(right[0] - right[1]);
    }
    return {absolute / brightness, std::sqrt(std::max(cross / area, 0.0)) * area / brightness,
            noise / brightness, reference_noise / brightness};
}

// Errors against the number of patches; halving their size is four times as many, so order one is x^-1/2.
class ErrorPlot {
  public:
    void add(double patches, const Errors& e) {
        mean_.points.push_back({patches, e.mean});
        bias_.points.push_back({patches, e.bias});
        noise_.points.push_back({patches, e.noise});
    }
    std::string svg() const {
        return log_log_svg({"Radiosity against path tracing from the patches",
                            "patches",
                            "error, of the mean radiance reflected",
                            {mean_, bias_, noise_},
                            -0.5});
    }

  private:
    PlotLine mean_{"mean error, all noise included", {}};
    PlotLine bias_{"bias, root mean square", {}};
    PlotLine noise_{"noise of the solution", {}};
};

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
    std::string plot_file;
    app.add_option("--plot", plot_file)->needs(app.get_option("--reference"));
    CLI11_PARSE(app, argc, argv);
    const Scene scene = import_gltf(file).scene;
    const gpu::Device device;
    ErrorPlot plot;
    std::printf("%8s %8s %6s | %7s %7s %7s %7s %7s | %4s %8s | %6s %6s | %7s %7s %7s | %s\n", "patches",
                "rows", "rays", "prepare", "mater.", "factors", "direct", "solve", "it.", "cpu s", "rows GB",
                "RSS GB", "recip.", "expect", "in/out", "error: mean; bias (rms); noise; the reference's");
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
            RadiositySettings again = settings;
            again.render.seed = 54321;
            const RadiositySolution other = solve_radiosity(device, scene, again);
            const Errors e = errors_of(device, scene, s, other, reference);
            plot.add(static_cast<double>(t.patches), e);
            std::printf("%.4f %.4f %.4f %.4f", e.mean, e.bias, e.noise, e.reference_noise);
        }
        std::printf("\n");
        std::fflush(stdout);
    }
    if (!plot_file.empty()) write_file(plot_file, plot.svg());
}
