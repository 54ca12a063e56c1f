// One struct, two languages: every member of every shared struct lies where C++ thinks it does. The GLSL side
// is read from the SPIR-V of layouts.comp (SPIR-V specification 1.5, section 3.32: OpMemberDecorate ...
// Offset).
#include "gpu_test.hpp"

#include "shaders/kernels/accumulate.glsl.h"
#include "shaders/kernels/albedo.glsl.h"
#include "shaders/kernels/ao.glsl.h"
#include "shaders/kernels/aov.glsl.h"
#include "shaders/kernels/average.glsl.h"
#include "shaders/kernels/connect.glsl.h"
#include "shaders/kernels/extend.glsl.h"
#include "shaders/kernels/generate.glsl.h"
#include "shaders/kernels/measure.glsl.h"
#include "shaders/kernels/naive.glsl.h"
#include "shaders/kernels/normals.glsl.h"
#include "shaders/kernels/place.glsl.h"
#include "shaders/kernels/radiate.glsl.h"
#include "shaders/kernels/receive.glsl.h"
#include "shaders/kernels/shade.glsl.h"
#include "shaders/kernels/shoot.glsl.h"
#include "shaders/kernels/show_patches.glsl.h"
#include "shaders/kernels/tally.glsl.h"
#include "shaders/kernels/update.glsl.h"
#include "shaders/shared/bvh.glsl.h"
#include "shaders/shared/element.glsl.h"
#include "shaders/shared/film.glsl.h"
#include "shaders/shared/frame.glsl.h"
#include "shaders/shared/geometry.glsl.h"
#include "shaders/shared/light.glsl.h"
#include "shaders/shared/light_tree.glsl.h"
#include "shaders/shared/material.glsl.h"
#include "shaders/shared/patch.glsl.h"
#include "shaders/shared/path.glsl.h"
#include "shaders/shared/radiosity.glsl.h"
#include "shaders/shared/segment_args.glsl.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>

namespace ajar::gpu {
namespace {

using namespace shared;

using Members = std::map<std::string, std::size_t>; // offset by name
using Layouts = std::map<std::string, Members>;     // by struct

struct Field {
    const char* type;
    const char* name;
    std::size_t offset;
};

#define F(type, member)                                                                                      \
    { #type, #member, offsetof(type, member) }

// Add the members of a new struct here and mention it in shaders/layouts.comp.
// clang-format off
const Field FIELDS[] = {
    F(BvhNode, origin), F(BvhNode, exponents), F(BvhNode, child_base), F(BvhNode, inner_orders),
    F(BvhNode, triangle_base), F(BvhNode, leaves),
    F(BvhNode, lower_x), F(BvhNode, lower_y), F(BvhNode, lower_z),
    F(BvhNode, upper_x), F(BvhNode, upper_y), F(BvhNode, upper_z),
    F(TriangleRecord, x), F(TriangleRecord, flags), F(TriangleRecord, y), F(TriangleRecord, material),
    F(TriangleRecord, z), F(TriangleRecord, object),
    F(FilmPixel, count), F(FilmPixel, sum), F(FilmPixel, square),
    F(AovPixel, sum), F(AovPixel, hits), F(AovPixel, object_id), F(AovPixel, material_id), F(AovPixel, pad),
    F(Diagnostics, invalid_count), F(Diagnostics, invalid_pixel), F(Diagnostics, invalid_sample),
    F(Diagnostics, invalid_bounce), F(Diagnostics, saturated_count), F(Diagnostics, assert_count),
    F(Diagnostics, assert_line), F(Diagnostics, assert_thread),
    F(TableWord, value),
    F(Texel, rgba8),
    F(PixelIndex, packed),
    F(FrameRecord, nodes), F(FrameRecord, triangles), F(FrameRecord, surfaces), F(FrameRecord, instances),
    F(FrameRecord, materials), F(FrameRecord, texels), F(FrameRecord, lights), F(FrameRecord, environment),
    F(FrameRecord, pixel_order), F(FrameRecord, aovs), F(FrameRecord, diagnostics),
    F(FrameRecord, visibility), F(FrameRecord, visibility_counts), F(FrameRecord, patches),
    F(FrameRecord, camera_origin), F(FrameRecord, camera_scale_x),
    F(FrameRecord, camera_right), F(FrameRecord, camera_scale_y), F(FrameRecord, camera_up),
    F(FrameRecord, width), F(FrameRecord, camera_back), F(FrameRecord, height), F(FrameRecord, seed),
    F(FrameRecord, max_bounces), F(FrameRecord, rr_depth), F(FrameRecord, background),
    F(FrameRecord, filter_radius), F(FrameRecord, environment_scale), F(FrameRecord, environment_cos),
    F(FrameRecord, environment_sin), F(FrameRecord, environment_width), F(FrameRecord, environment_height),
    F(FrameRecord, environment_light), F(FrameRecord, light_count), F(FrameRecord, alias_first),
    F(FrameRecord, textures_first), F(FrameRecord, root), F(FrameRecord, scene_center),
    F(FrameRecord, scene_radius), F(FrameRecord, cull_backfaces), F(FrameRecord, instance_count),
    F(FrameRecord, ao_distance), F(FrameRecord, distant_first), F(FrameRecord, distant_slots),
    F(FrameRecord, distant_irradiance), F(FrameRecord, tree_first), F(FrameRecord, tree_lights),
    F(FrameRecord, trails_first), F(FrameRecord, sample_clamp), F(FrameRecord, sequence_log2),
    F(FrameRecord, soft_first), F(FrameRecord, soft_count),
    F(FrameRecord, patch_nodes_first), F(FrameRecord, patch_sides_first), F(FrameRecord, pool_paths),
    F(FrameRecord, pad),
    F(SurfaceRecord, normal), F(SurfaceRecord, material), F(SurfaceRecord, uv0), F(SurfaceRecord, light),
    F(SurfaceRecord, object),
    F(SurfaceExtension, uv1), F(SurfaceExtension, tangent), F(SurfaceExtension, tangent_sign),
    F(SurfaceExtension, color),
    F(InstanceRecord, to_world), F(InstanceRecord, to_object), F(InstanceRecord, root),
    F(InstanceRecord, flags), F(InstanceRecord, object), F(InstanceRecord, pad),
    F(LightRecord, p0), F(LightRecord, kind), F(LightRecord, p1), F(LightRecord, triangle),
    F(LightRecord, p2), F(LightRecord, power_pmf), F(LightRecord, radiance), F(LightRecord, extent),
    F(AliasEntry, keep), F(AliasEntry, other), F(AliasEntry, own), F(AliasEntry, pad),
    F(VisibilityCount, traced), F(VisibilityCount, arrived), F(LightTreeRoot, center),
    F(LightTreeRoot, radius), F(LightTreeRoot, axis), F(LightTreeRoot, cones),
    F(LightTreeRoot, intensity), F(LightTreeRoot, flags), F(LightTreeNode, place),
    F(LightTreeNode, axis), F(LightTreeNode, radii), F(LightTreeNode, normals),
    F(LightTreeNode, emission), F(LightTreeNode, nodes), F(LightTreeNode, lights),
    F(MaterialRecord, base_color), F(MaterialRecord, emission), F(MaterialRecord, flags),
    F(MaterialRecord, metallic), F(MaterialRecord, roughness), F(MaterialRecord, normal_scale),
    F(MaterialRecord, alpha_cutoff), F(MaterialRecord, dielectric_f0), F(MaterialRecord, dielectric_f90),
    F(MaterialRecord, base_color_texture), F(MaterialRecord, metallic_roughness_texture),
    F(MaterialRecord, normal_texture), F(MaterialRecord, emission_texture),
    F(TextureRecord, first_texel), F(TextureRecord, width), F(TextureRecord, height), F(TextureRecord, flags),
    F(TextureRecord, uv_row_u), F(TextureRecord, pad0), F(TextureRecord, uv_row_v), F(TextureRecord, pad1),
    F(PatchNode, child), F(PatchNode, edge), F(PatchNode, pad),
    F(PatchSide, radiance), F(PatchSide, irradiance),
    F(PathState, origin), F(PathState, home), F(PathState, direction), F(PathState, leaves),
    F(PathState, beta), F(PathState, pdf), F(PathState, triangle), F(PathState, instance),
    F(PathState, u), F(PathState, v),
    F(ShadowRay, origin), F(ShadowRay, leaves), F(ShadowRay, direction), F(ShadowRay, reach),
    F(ShadowRay, contribution), F(ShadowRay, home), F(ShadowRay, instance), F(ShadowRay, counter),
    F(ShadowRay, pad),
    F(SegmentCounts, paths), F(SegmentCounts, shadows), F(SegmentCounts, rays_traced),
    F(SegmentCounts, shadows_traced), F(SegmentCounts, shadows_open), F(SegmentCounts, loops_exhausted),
    F(SegmentCounts, pad),
    F(SurfaceElement, triangle), F(SurfaceElement, flags), F(SurfaceElement, origin),
    F(SurfaceElement, edge_a), F(SurfaceElement, edge_b),
    F(SegmentArgs, segment_count), F(SegmentArgs, first_segment), F(SegmentArgs, segment_stride),
    F(SegmentArgs, bounce), F(SegmentArgs, path_count), F(SegmentArgs, first_ordinal),
    F(SegmentArgs, chunk_ordinal), F(SegmentArgs, samples_log2), F(SegmentArgs, first_sample),
    F(SideValue, rgb), F(SideValue, scalar), F(SideIndex, side), F(RowWord, sides),
    F(RowTotals, rays_nowhere), F(RowTotals, rays_sky), F(RowsMeasure, max_rest),
    F(RowsMeasure, max_value), F(RowsMeasure, rest_power), F(RowsMeasure, power),
    F(RowsMeasure, max_rest_power), F(RowsMeasure, pad),
    F(AccumulateArgs, segments),
    F(AlbedoArgs, segments),
    F(AoArgs, segments),
    F(AovArgs, segments),
    F(AverageArgs, elements), F(AverageArgs, emission), F(AverageArgs, reflectance),
    F(AverageArgs, first_side), F(AverageArgs, side_count), F(AverageArgs, points), F(AverageArgs, pad),
    F(ConnectArgs, segments),
    F(ExtendArgs, segments),
    F(GenerateArgs, segments),
    F(MeasureArgs, row_sides), F(MeasureArgs, reflectance), F(MeasureArgs, solution),
    F(MeasureArgs, rest), F(MeasureArgs, measures), F(MeasureArgs, row_count), F(MeasureArgs, pad),
    F(NaiveArgs, segments),
    F(NormalsArgs, segments),
    F(PlaceArgs, elements), F(PlaceArgs, segments), F(PlaceArgs, pad),
    F(RadiateArgs, elements), F(RadiateArgs, row_sides), F(RadiateArgs, segments), F(RadiateArgs, pad),
    F(ReceiveArgs, rows), F(ReceiveArgs, row_sides), F(ReceiveArgs, from), F(ReceiveArgs, to),
    F(ReceiveArgs, first_row), F(ReceiveArgs, row_count), F(ReceiveArgs, rays_log2), F(ReceiveArgs, pad),
    F(ShowPatchesArgs, segments),
    F(ShadeArgs, segments), F(ShadeArgs, light),
    F(ShootArgs, row_sides), F(ShootArgs, reflectance), F(ShootArgs, rest), F(ShootArgs, shot),
    F(ShootArgs, shooters), F(ShootArgs, threshold), F(ShootArgs, row_count),
    F(TallyArgs, entries), F(TallyArgs, met), F(TallyArgs, totals), F(TallyArgs, segments),
    F(TallyArgs, first_row), F(TallyArgs, rays_log2), F(TallyArgs, side_count),
    F(UpdateArgs, row_sides), F(UpdateArgs, received), F(UpdateArgs, source),
    F(UpdateArgs, reflectance), F(UpdateArgs, solution), F(UpdateArgs, rest), F(UpdateArgs, first_row),
    F(UpdateArgs, row_count),
};
// clang-format on

#undef F

Layouts of_cpp() {
    Layouts layouts;
    for (const Field& field : FIELDS) layouts[field.type][field.name] = field.offset;
    return layouts;
}

std::string text_at(const std::uint32_t* words) { return reinterpret_cast<const char*>(words); }

// Structs with offsets, by name. One name may stand for several types (one per storage class): they must
// agree.
Layouts of_spirv(std::span<const std::uint32_t> words) {
    constexpr std::uint32_t OP_NAME = 5, OP_MEMBER_NAME = 6, OP_MEMBER_DECORATE = 72, OFFSET = 35,
                            HEADER_WORDS = 5;
    std::map<std::uint32_t, std::string> names;
    std::map<std::uint32_t, std::map<std::uint32_t, std::string>> member_names;
    std::map<std::uint32_t, std::map<std::uint32_t, std::size_t>> offsets;
    for (std::size_t at = HEADER_WORDS; at < words.size(); at += words[at] >> 16) {
        const std::uint32_t* op = &words[at];
        const std::uint32_t code = op[0] & 0xffffu;
        if (code == OP_NAME) names[op[1]] = text_at(op + 2);
        if (code == OP_MEMBER_NAME) member_names[op[1]][op[2]] = text_at(op + 3);
        if (code == OP_MEMBER_DECORATE && op[3] == OFFSET) offsets[op[1]][op[2]] = op[4];
    }
    Layouts layouts;
    for (const auto& [type, members] : offsets) {
        Members found;
        for (const auto& [member, offset] : members) found[member_names[type][member]] = offset;
        const auto [place, is_new] = layouts.emplace(names[type], found);
        EXPECT_TRUE(is_new || place->second == found) << names[type];
    }
    return layouts;
}

// Names of the structs that the shared headers declare.
std::set<std::string> declared() {
    std::set<std::string> names;
    for (const char* folder : {"/shaders/shared", "/shaders/kernels"}) {
        for (const auto& entry : std::filesystem::directory_iterator(std::string(AJAR_SOURCE_DIR) + folder)) {
            if (!entry.path().filename().string().ends_with(".glsl.h")) continue;
            std::ifstream file(entry.path());
            const std::regex pattern("^struct (\\w+) \\{.*");
            for (std::string line; std::getline(file, line);) {
                if (std::smatch match; std::regex_match(line, match, pattern)) names.insert(match[1]);
            }
        }
    }
    return names;
}

TEST(SharedStructs, LieInSpirvWhereCppThinks) {
    KernelSet kernels = test_kernels();
    const auto found =
        std::find_if(kernels.begin(), kernels.end(), [](const auto& k) { return k.name == "layouts"; });
    ASSERT_NE(found, kernels.end());
    const Layouts spirv = of_spirv(found->spirv);
    const Layouts cpp = of_cpp();
    for (const auto& [type, members] : cpp) {
        ASSERT_TRUE(spirv.contains(type)) << type << " is not mentioned in shaders/layouts.comp";
        EXPECT_EQ(spirv.at(type), members) << type;
    }
}

TEST(SharedStructs, AreAllCompared) {
    const Layouts cpp = of_cpp();
    for (const std::string& name : declared()) EXPECT_TRUE(cpp.contains(name)) << name;
    EXPECT_EQ(declared().size(), cpp.size());
}

} // namespace
} // namespace ajar::gpu
