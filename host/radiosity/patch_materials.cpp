#include "radiosity/patch_materials.hpp"

#include "shaders/kernels/average.glsl.h"
#include "shaders/shared/radiosity.glsl.h"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace ajar {

using namespace shared;

namespace {

// Four a row and column of a texture's footprint, or the mean of so many directions: a rough metal's albedo
// to about a hundredth.
constexpr std::uint32_t POINTS = 64;
constexpr std::uint32_t SIDES_AT_ONCE = 1u << 16;

std::uint64_t vector_bytes(const RadiosityRig& rig) {
    return std::uint64_t{rig.side_count() + SIDES_BESIDE} * sizeof(SideValue);
}

} // namespace

PatchMaterials::PatchMaterials(const RadiosityRig& rig)
    : emission(rig.device, vector_bytes(rig), "emission of sides"),
      reflectance(rig.device, vector_bytes(rig), "reflectance of sides") {}

bool PatchMaterials::average(RadiosityRig& rig, const std::function<bool(std::uint32_t)>& progress) {
    const gpu::Kernel<AverageArgs> kernel(rig.device, "average", rig.specialization);
    for (std::uint32_t first = 0; first < rig.side_count(); first += SIDES_AT_ONCE) {
        const std::uint32_t count = std::min(SIDES_AT_ONCE, rig.side_count() - first);
        const AverageArgs args{{rig.element_buffer.address()},
                               {emission.address()},
                               {reflectance.address()},
                               first,
                               count,
                               POINTS,
                               0};
        kernel.dispatch(rig.commands, args, rig.groups(count));
        rig.commands.submit();
        if (!progress(first + count)) return false;
    }
    const std::vector<SideValue> there = emission.read<SideValue>(0, rig.side_count());
    std::vector<SideValue> reflects = reflectance.read<SideValue>(0, rig.side_count());
    for (std::uint32_t side = 0; side < rig.side_count(); ++side)
        reflects[side].scalar = rig.mesh.patches[side / 2].area * there[side].scalar;
    reflectance.write(std::span<const SideValue>(reflects));
    return true;
}

void warn_of_other_than_diffuse(const Scene& scene, const PatchMesh& mesh, const WarningSink& warn) {
    if (!warn) return;
    std::set<std::uint32_t> used;
    for (const PatchSource& source : mesh.sources) used.insert(source.material);
    std::string names;
    std::size_t count = 0;
    constexpr std::size_t MAX_NAMES = 8;
    for (const std::uint32_t index : used) {
        const Material& m = scene.materials[index];
        if (m.unlit || (m.metallic == 0 && m.specular == 0)) continue;
        if (++count <= MAX_NAMES)
            names += fmt::format("{}'{}'", count == 1 ? "" : ", ",
                                 m.name.empty() ? fmt::format("{}", index) : m.name);
    }
    if (count > MAX_NAMES) names += fmt::format(" and {} more", count - MAX_NAMES);
    if (count > 0)
        warn(fmt::format("radiosity takes every surface for diffuse: material{} {} reflect{} as much light, "
                         "but evenly",
                         count == 1 ? "" : "s", names, count == 1 ? "s" : ""));
}

} // namespace ajar
