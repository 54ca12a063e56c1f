// For tests, never run: mentions every struct that C++ and GLSL share, so that layouts_test.cpp can read from
// this module where each member lies.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "core/variants.glsl"
#include "shared/bindings.glsl.h"
#include "shared/bvh.glsl.h"
#include "shared/film.glsl.h"
#include "shared/frame.glsl.h"
#include "shared/geometry.glsl.h"
#include "shared/light.glsl.h"
#include "shared/light_tree.glsl.h"
#include "shared/material.glsl.h"
#include "shared/patch.glsl.h"
#include "shared/path.glsl.h"
#include "shared/radiosity.glsl.h"
#include "kernels/accumulate.glsl.h"
#include "kernels/albedo.glsl.h"
#include "kernels/ao.glsl.h"
#include "kernels/aov.glsl.h"
#include "kernels/average.glsl.h"
#include "kernels/connect.glsl.h"
#include "kernels/extend.glsl.h"
#include "kernels/generate.glsl.h"
#include "kernels/measure.glsl.h"
#include "kernels/naive.glsl.h"
#include "kernels/normals.glsl.h"
#include "kernels/place.glsl.h"
#include "kernels/radiate.glsl.h"
#include "kernels/receive.glsl.h"
#include "kernels/shade.glsl.h"
#include "kernels/shoot.glsl.h"
#include "kernels/show_patches.glsl.h"
#include "kernels/tally.glsl.h"
#include "kernels/update.glsl.h"

#define MENTION(T) layout(set = 0, binding = BIND_PATHS, scalar) buffer Block##T { T at[]; } block_##T;
MENTION(BvhNode)
MENTION(TriangleRecord)
MENTION(FilmPixel)
MENTION(AovPixel)
MENTION(Diagnostics)
MENTION(TableWord)
MENTION(Texel)
MENTION(PixelIndex)
MENTION(FrameRecord)
MENTION(SurfaceRecord)
MENTION(SurfaceExtension)
MENTION(InstanceRecord)
MENTION(LightRecord)
MENTION(AliasEntry)
MENTION(LightTreeRoot)
MENTION(LightTreeNode)
MENTION(VisibilityCount)
MENTION(MaterialRecord)
MENTION(TextureRecord)
MENTION(PatchNode)
MENTION(PatchSide)
MENTION(PathState)
MENTION(ShadowRay)
MENTION(SegmentCounts)
MENTION(SurfaceElement)
MENTION(SegmentArgs)
MENTION(SideValue)
MENTION(SideIndex)
MENTION(RowWord)
MENTION(RowTotals)
MENTION(RowsMeasure)
MENTION(AccumulateArgs)
MENTION(AlbedoArgs)
MENTION(AoArgs)
MENTION(AovArgs)
MENTION(ConnectArgs)
MENTION(ExtendArgs)
MENTION(GenerateArgs)
MENTION(NaiveArgs)
MENTION(NormalsArgs)
MENTION(PlaceArgs)
MENTION(ShadeArgs)
MENTION(ShowPatchesArgs)
MENTION(AverageArgs)
MENTION(MeasureArgs)
MENTION(RadiateArgs)
MENTION(ReceiveArgs)
MENTION(ShootArgs)
MENTION(TallyArgs)
MENTION(UpdateArgs)

#define USE(T) +block_##T.at.length()

void main() {
    const int total = 0 USE(BvhNode) USE(TriangleRecord) USE(FilmPixel) USE(AovPixel) USE(Diagnostics)
        USE(TableWord) USE(Texel) USE(PixelIndex) USE(FrameRecord) USE(SurfaceRecord) USE(SurfaceExtension)
        USE(InstanceRecord) USE(LightRecord) USE(AliasEntry) USE(LightTreeRoot)
        USE(LightTreeNode) USE(VisibilityCount)
        USE(MaterialRecord) USE(TextureRecord)
        USE(PatchNode) USE(PatchSide) USE(PathState) USE(ShadowRay) USE(SegmentCounts)
        USE(SurfaceElement) USE(SegmentArgs)
        USE(AccumulateArgs)
        USE(AlbedoArgs) USE(AoArgs) USE(AovArgs) USE(ConnectArgs) USE(ExtendArgs) USE(GenerateArgs)
        USE(NaiveArgs) USE(NormalsArgs) USE(PlaceArgs) USE(ShadeArgs) USE(ShowPatchesArgs)
        USE(SideValue) USE(SideIndex) USE(RowWord) USE(RowTotals) USE(RowsMeasure) USE(AverageArgs)
        USE(MeasureArgs) USE(RadiateArgs) USE(ReceiveArgs) USE(ShootArgs) USE(TallyArgs) USE(UpdateArgs);
    block_Texel.at[0].rgba8 = uint(total);
}
