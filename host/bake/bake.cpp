#include "bake/bake.hpp"

#include "bake/lightmap.hpp"
#include "bake/patch_light.hpp"
#include "bake/vertex_colors.hpp"
#include "base/error.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace ajar {

namespace {

constexpr std::array TARGETS{
    Choice{"vertices", "in the colours of vertices, of a finer mesh"},
    Choice{"lightmap", "in a texture, with everything that is seen"},
    Choice{"occlusion", "ambient occlusion as a texture of the same materials"},
};
constexpr std::array METHODS{
    Choice{"path", "paths from the surfaces"},
    Choice{"radiosity",
           "a linear system over patches: quick and smooth, shadows as sharp as patches are small"},
};

template <std::size_t N>
void check_name(const std::array<Choice, N>& rows, const char* what, const std::string& name) {
    std::string known;
    for (const Choice& row : rows) {
        if (name == row.name) return;
        known += known.empty() ? row.name : std::string(", ") + row.name;
    }
    throw Error(fmt::format("{} '{}': there is none of that name (there are: {})", what, name, known));
}

void check(const Scene& scene, const BakeSettings& settings) {
    check_name(TARGETS, "bake", settings.to);
    check_name(METHODS, "bake with", settings.with);
    std::size_t triangles = 0;
    for (const Instance& instance : scene.instances)
        triangles += scene.meshes[instance.mesh].triangles.size();
    if (triangles == 0) throw Error("there are no triangles to bake light on");
    const float* background = settings.render.background;
    const bool is_lit = has_light(scene) || std::max({background[0], background[1], background[2]}) > 0;
    if (settings.to != "occlusion" && !is_lit)
        throw Error("there is no light to bake (give it some: --env, --background)");
}

std::string listed(const std::vector<std::string>& names) {
    constexpr std::size_t SHOWN = 8;
    std::string line;
    for (std::size_t i = 0; i < std::min(names.size(), SHOWN); ++i)
        line += fmt::format("{}'{}'", i == 0 ? "" : ", ", names[i]);
    return names.size() <= SHOWN ? line : fmt::format("{} and {} more", line, names.size() - SHOWN);
}

class Baker {
  public:
    Baker(const gpu::Device& device, const Scene& scene, const BakeSettings& settings,
          const ProgressSink& progress, const WarningSink& warn)
        : device_(device), scene_(scene), settings_(settings), progress_(progress), warn_(warn),
          renderer_(device, scene, warn) {}

    BakeOutput run() {
        if (settings_.to == "vertices")
            to_vertices();
        else
            to_atlas();
        return std::move(output_);
    }

  private:
    bool with_radiosity() const { return settings_.with == "radiosity" && settings_.to != "occlusion"; }

    // Light on elements by path tracing; occlusion if that is asked for. Empty if no sample was done.
    std::vector<glm::vec3> gather(const std::vector<SceneElement>& elements) {
        RenderSettings settings = settings_.render;
        settings.integrator = settings_.to == "occlusion" ? "ao" : "path";
        ElementRadiance light = renderer_.irradiance(elements, settings, [&](Progress progress) {
            progress.stage = "bake";
            return !progress_ || progress_(progress);
        });
        output_.stats.elements = elements.size();
        output_.stats.render = std::move(light.stats);
        if (output_.stats.render.samples == 0) return {};
        return std::move(light.irradiance);
    }

    RadiositySolution solve() {
        RadiositySolution solution = solve_for_bake(device_, scene_, settings_, progress_, warn_);
        const RadiosityStats& stats = solution.stats;
        RenderStats& render = output_.stats.render;
        render.settings = settings_.render;
        render.samples = stats.settings.shadow_samples;
        render.interrupted = stats.interrupted;
        render.render_seconds =
            stats.material_seconds + stats.form_factor_seconds + stats.direct_seconds + stats.solve_seconds;
        render.extension_rays = stats.form_factor_rays;
        render.invalid_samples = stats.invalid_samples;
        render.exhausted_loops = stats.exhausted_loops;
        output_.stats.elements = stats.patches;
        return solution;
    }

    void to_vertices() {
        RadiositySolution solution;
        if (with_radiosity())
            solution = solve();
        else
            solution.mesh = PatchMesh::subdivide(scene_, {settings_.patch_size, settings_.patches});
        const PatchMesh& mesh = solution.mesh;
        if (mesh.patches.empty()) throw Error(NO_AREA);
        const std::vector<SceneElement> elements = patch_elements(scene_, mesh);
        ElementLight light;
        if (with_radiosity()) {
            light.irradiance = front_irradiance(solution);
            light.materials = front_materials(solution);
        } else {
            warn_of_materials();
            light.irradiance = gather(elements);
            if (light.irradiance.empty()) return;
            light.materials = renderer_.materials(elements, settings_.render);
        }
        light.textures = texture_means(scene_, elements);
        Brightness brightness;
        output_.scene = vertex_colored_scene(scene_, mesh, light, settings_.exposure, brightness);
        note(brightness);
    }

    void to_atlas() {
        std::vector<PlacedTriangle> triangles = placed_triangles(scene_);
        if (triangles.empty()) throw Error(NO_AREA);
        const Atlas atlas = make_atlas(make_charts(std::move(triangles)), settings_.side);
        output_.stats.charts = atlas.charts.charts.size();
        output_.stats.texels_per_metre = atlas.texels_per_metre;
        const std::vector<CoveredTexel> covered = covered_texels(atlas);
        const std::vector<SceneElement> elements = texel_elements(atlas, covered);
        if (settings_.to == "occlusion")
            to_occlusion(atlas, covered, elements);
        else
            to_lightmap(atlas, covered, elements);
    }

    void to_occlusion(const Atlas& atlas, std::span<const CoveredTexel> covered,
                      const std::vector<SceneElement>& elements) {
        std::vector<std::string> without;
        Scene unwrapped = unwrapped_scene_with_textures(scene_, atlas, without);
        if (!without.empty() && warn_)
            warn_(fmt::format("no occlusion for {}: both sets of texture coordinates are in use",
                              listed(without)));
        const std::vector<glm::vec3> openness = gather(elements);
        if (!openness.empty())
            output_.scene = occluded_scene(std::move(unwrapped), atlas.side, covered, openness);
    }

    void to_lightmap(const Atlas& atlas, std::span<const CoveredTexel> covered,
                     const std::vector<SceneElement>& elements) {
        ElementLight light;
        if (with_radiosity()) {
            light.irradiance = irradiance_at(scene_, solve(), elements);
        } else {
            warn_of_materials();
            light.irradiance = gather(elements);
            if (light.irradiance.empty()) return;
        }
        light.materials = renderer_.materials(elements, settings_.render);
        light.textures = texture_means(scene_, elements);
        Brightness brightness;
        output_.scene = lightmapped_scene(unwrapped_scene(scene_, atlas), atlas.side, covered, light,
                                          settings_.exposure, brightness);
        output_.irradiance = irradiance_image(atlas.side, covered, light.irradiance);
        note(brightness);
    }

    void warn_of_materials() const {
        const std::vector<std::string> names = view_dependent_materials(scene_);
        if (!names.empty() && warn_)
            warn_(fmt::format("baked as if diffuse, since what is baked looks alike from everywhere: {}",
                              listed(names)));
    }

    void note(const Brightness& brightness) {
        output_.stats.clipped = brightness.clipped_share();
        output_.stats.exposure_to_fit = settings_.exposure - brightness.stops_too_bright();
        if (output_.stats.clipped > 0.001 && warn_)
            warn_(fmt::format(
                "{:.1f} % of the surface is brighter than can be stored and is cut (by --exposure "
                "{:.1f} nothing is)",
                100 * output_.stats.clipped, output_.stats.exposure_to_fit));
    }

    static constexpr const char* NO_AREA = "none of its triangles has any area to bake light on";

    const gpu::Device& device_;
    const Scene& scene_;
    const BakeSettings& settings_;
    const ProgressSink& progress_;
    const WarningSink& warn_;
    Renderer renderer_;
    BakeOutput output_;
};

} // namespace

std::span<const Choice> bake_targets() { return TARGETS; }
std::span<const Choice> bake_methods() { return METHODS; }

BakeOutput bake(const gpu::Device& device, const Scene& scene, const BakeSettings& settings,
                const ProgressSink& progress, const WarningSink& warn) {
    check(scene, settings);
    return Baker(device, scene, settings, progress, warn).run();
}

} // namespace ajar
