// The table of all lights, and the distributions over them.
#include "render/light_table.hpp"

#include "render/alias_table.hpp"
#include "render/light_records.hpp"
#include "shaders/shared/specialization.glsl.h"

#include <algorithm>
#include <cstring>

namespace ajar {

namespace {

// Sampling by solid angle costs a constant and gains with how large triangles are seen. On lavapipe the two
// meet where the mean triangle, by power, has about a sixteenth of the scene's radius squared
// (shaders/lights).
constexpr double WIDE_AREA = 1.0 / 16;

// `powers` begin with the triangles'.
bool are_wide(std::span<const EmissiveTriangle> triangles, std::span<const double> powers,
              float scene_radius) {
    double area_power = 0;
    double power = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (!(powers[i] > 0)) continue;
        area_power += powers[i] * triangles[i].area;
        power += powers[i];
    }
    return area_power > WIDE_AREA * scene_radius * scene_radius * power;
}

// The distribution over lights that are nowhere; their share goes into LightRecord::p2.x.
void add_distant(const std::vector<double>& weights, LightTable& table) {
    std::vector<double> irradiances;
    std::vector<std::uint32_t> lights;
    for (std::uint32_t i = 0; i < weights.size(); ++i) {
        if (!(weights[i] > 0)) continue;
        irradiances.push_back(weights[i]);
        lights.push_back(i);
        table.distant_irradiance += static_cast<float>(weights[i]);
    }
    if (lights.empty()) return;
    AliasTable alias = build_alias_table(irradiances);
    const auto light_of = [&](std::uint32_t entry) {
        return lights[std::min<std::size_t>(entry, lights.size() - 1)];
    };
    for (std::uint32_t i = 0; i < alias.entries.size(); ++i) {
        shared::AliasEntry entry = alias.entries[i];
        entry.own = light_of(i);
        entry.other = light_of(entry.other);
        table.distant.push_back(entry);
    }
    for (std::size_t i = 0; i < lights.size(); ++i) table.lights[lights[i]].p2.x = alias.pmf[i];
}

// Lights in the order of LightTable::lights, with what the distributions are made of.
class Builder {
  public:
    Builder(const Scene& scene, float scene_radius, double environment_share)
        : scene_(scene), radius_(scene_radius), environment_share_(environment_share) {}

    LightTable build(std::span<const EmissiveTriangle> triangles, std::span<const EmissiveSphere> spheres) {
        for (const EmissiveTriangle& t : triangles)
            add(triangle_record(t), light_power(t), shared::FEATURE_EMISSIVE_TRIANGLES, light_bounds(t));
        if (are_wide(triangles, table_.powers, radius_)) table_.features |= shared::FEATURE_WIDE_TRIANGLES;
        for (const Light& light : scene_.lights)
            if (!is_soft(light)) add(light, shared::FEATURE_PUNCTUAL_LIGHTS);
        add_soft_lights(spheres);
        add_environment();
        AliasTable alias = build_alias_table(table_.powers);
        for (std::size_t i = 0; i < table_.lights.size(); ++i) table_.lights[i].power_pmf = alias.pmf[i];
        table_.alias = std::move(alias.entries);
        add_distant(irradiances_, table_);
        table_.tree = build_light_tree(bounds_);
        return std::move(table_);
    }

  private:
    // A light without place has no bounds, others have no irradiance of their own.
    void add(const shared::LightRecord& record, double power, std::uint32_t feature,
             const LightBounds& bounds, double irradiance = 0) {
        table_.lights.push_back(record);
        table_.powers.push_back(power);
        table_.features |= feature;
        bounds_.push_back(bounds);
        irradiances_.push_back(irradiance);
    }
    void add(const Light& light, std::uint32_t feature) {
        add(light_record(light), light_power(light, radius_), feature, light_bounds(light),
            distant_irradiance(light));
    }

    // Suns before lamps: they are few, and the more it costs to miss one.
    void add_soft_lights(std::span<const EmissiveSphere> spheres) {
        table_.soft_first = static_cast<std::uint32_t>(table_.lights.size());
        for (const EmissiveSphere& s : spheres)
            add(sphere_record(s), light_power(s), shared::FEATURE_SOFT_LIGHTS, light_bounds(s));
        for (const bool suns : {true, false})
            for (const Light& light : scene_.lights)
                if (is_soft(light) && (light.kind == LightKind::directional) == suns)
                    add(light, shared::FEATURE_SOFT_LIGHTS);
        const auto count = static_cast<std::uint32_t>(table_.lights.size()) - table_.soft_first;
        table_.soft_count = std::min(count, shared::MAX_SOFT_LIGHTS);
        for (std::uint32_t i = table_.soft_count; i < count; ++i)
            table_.lights[table_.soft_first + i].kind |= shared::LIGHT_UNMET;
    }

    void add_environment() {
        if (!scene_.environment) return;
        const Environment& environment = *scene_.environment;
        shared::LightRecord record{};
        record.kind = shared::LIGHT_ENVIRONMENT;
        record.radiance = environment.scale;
        table_.environment_light = static_cast<std::uint32_t>(table_.lights.size());
        add(record, environment_share_ * light_power(environment, radius_),
            environment.radiance.empty() ? shared::FEATURE_CONSTANT_ENVIRONMENT
                                         : shared::FEATURE_ENVIRONMENT_MAP,
            {}, environment_share_ * distant_irradiance(environment));
    }

    const Scene& scene_;
    float radius_;
    double environment_share_;
    LightTable table_;
    std::vector<LightBounds> bounds_; // per light; without intensity: not in the tree
    std::vector<double> irradiances_; // per light
};

} // namespace

LightTable build_light_table(const Scene& scene, std::span<const EmissiveTriangle> triangles,
                             float scene_radius, std::span<const EmissiveSphere> spheres,
                             double environment_share) {
    return Builder(scene, scene_radius, environment_share).build(triangles, spheres);
}

namespace {

// Of each part of BIND_LIGHTS, in texels, and where the last one ends.
struct Layout {
    std::uint32_t alias, distant, tree, trails, end;

    explicit Layout(const LightTable& table) {
        const auto size = [](const auto& part) { return static_cast<std::uint32_t>(part.size()); };
        alias = size(table.lights) * shared::LIGHT_TEXELS;
        distant = alias + size(table.alias);
        // Nodes do not straddle cache lines.
        tree = (distant + size(table.distant) + 3u) / 4u * 4u;
        const std::uint32_t nodes = table.tree.empty ? 0 : 1 + size(table.tree.nodes); // and the root
        trails = tree + nodes * shared::LIGHT_TREE_NODE_TEXELS;
        end = trails + (size(table.tree.trails) + 3u) / 4u;
    }
};

} // namespace

std::vector<glm::uvec4> LightTable::words() const {
    static_assert(sizeof(shared::AliasEntry) == sizeof(glm::uvec4));
    const Layout at(*this);
    std::vector<glm::uvec4> result(at.end);
    const auto put = [&](std::uint32_t first, const auto& part) {
        if (!part.empty()) std::memcpy(result.data() + first, part.data(), part.size() * sizeof(part[0]));
    };
    put(0, lights);
    put(at.alias, alias);
    put(at.distant, distant);
    if (!tree.empty) {
        std::memcpy(result.data() + at.tree, &tree.root, sizeof tree.root);
        put(at.tree + shared::LIGHT_TREE_NODE_TEXELS, tree.nodes);
    }
    put(at.trails, tree.trails);
    return result;
}

void LightTable::describe(shared::FrameRecord& frame) const {
    const Layout at(*this);
    frame.light_count = static_cast<std::uint32_t>(lights.size());
    frame.environment_light = environment_light;
    frame.soft_first = soft_first;
    frame.soft_count = soft_count;
    frame.alias_first = at.alias;
    frame.distant_first = at.distant;
    frame.distant_slots = static_cast<std::uint32_t>(distant.size());
    frame.distant_irradiance = distant_irradiance;
    frame.tree_first = at.tree;
    frame.tree_lights = tree.empty ? 0 : 1;
    frame.trails_first = at.trails;
}

} // namespace ajar
