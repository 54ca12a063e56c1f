// What rays know of a triangle's material before they look at it.
#include "render/material_table.hpp"
#include "shaders/shared/bvh.glsl.h"

#include <gtest/gtest.h>

namespace ajar {
namespace {

using namespace shared;

Material black() {
    Material m;
    m.base_color = {0, 0, 0, 1};
    m.metallic = 0;
    m.specular = 0;
    return m;
}

TEST(TriangleFlags, AnOpaqueSurfaceScattersAndNoMore) {
    EXPECT_EQ(triangle_flags(Material{}, false), TRIANGLE_SCATTERS);
}

TEST(TriangleFlags, OnlyWhatReflectsNothingAtAllDoesNotScatter) {
    EXPECT_EQ(triangle_flags(black(), false), 0u);
    Material m = black();
    m.base_color.b = 0.01f;
    EXPECT_EQ(triangle_flags(m, false), TRIANGLE_SCATTERS);
    m = black();
    m.specular = 0.01f; // Fresnel's part
    EXPECT_EQ(triangle_flags(m, false), TRIANGLE_SCATTERS);
    m = black();
    m.metallic = 0.01f; // f90 of a metal is 1, whatever its colour
    EXPECT_EQ(triangle_flags(m, false), TRIANGLE_SCATTERS);
}

TEST(TriangleFlags, AnEmitterIsLookedAtAndMayScatter) {
    Material m;
    m.emission = {0, 0, 1e-6f};
    EXPECT_EQ(triangle_flags(m, false), TRIANGLE_EMITS | TRIANGLE_SCATTERS);
    m = black();
    m.emission = {1, 1, 1};
    EXPECT_EQ(triangle_flags(m, false), TRIANGLE_EMITS);
}

TEST(TriangleFlags, AnUnlitSurfaceShowsItsColourAndScattersNothing) {
    Material m;
    m.unlit = true;
    EXPECT_EQ(triangle_flags(m, false), TRIANGLE_EMITS);
}

TEST(TriangleFlags, AlphaAndCulledBacksAreUnsure) {
    Material m;
    m.alpha_mode = AlphaMode::mask;
    EXPECT_EQ(triangle_flags(m, false), TRIANGLE_ALPHA | TRIANGLE_SCATTERS);
    m = Material{};
    EXPECT_EQ(triangle_flags(m, true), TRIANGLE_ALPHA | TRIANGLE_SCATTERS);
    m.double_sided = true;
    EXPECT_EQ(triangle_flags(m, true), TRIANGLE_SCATTERS);
}

} // namespace
} // namespace ajar
