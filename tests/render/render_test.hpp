// Fixture and comparisons for tests of whole images: a scene, its render, and an expectation for each pixel.
#pragma once

#include "render/render.hpp"
#include "support/gpu_test.hpp"
#include "support/scene_builder.hpp"

#include <functional>
#include <optional>
#include <string>

namespace ajar::test {

// 32 x 32 pixels, direct light only.
RenderSettings small_settings();

// Renders and expects that nothing went wrong: no invalid or saturated sample, exhausted loop or warning.
RenderOutput render_checked(const gpu::Device& device, const Scene& scene, const RenderSettings& settings);

class RenderTest : public GpuTest {
  protected:
    static Image render(const Scene& scene, const RenderSettings& settings) {
        return render_checked(device(), scene, settings).image;
    }
};

// For each strategy's name.
class RenderTestByStrategy : public RenderTest, public testing::WithParamInterface<const char*> {
  protected:
    static RenderSettings strategy_settings() {
        RenderSettings settings = small_settings();
        settings.strategy = GetParam();
        return settings;
    }
};

// The ray through a point of the image plane, in pixels from the top left corner, worked out in doubles.
struct ViewRay {
    glm::dvec3 origin;
    glm::dvec3 direction; // unit
};
ViewRay view_ray(const Camera& camera, const RenderSettings& settings, double x, double y);

// The mean of `radiance` over a pixel, on a grid of its own; none where any part of the pixel has none.
using RayRadiance = std::function<std::optional<glm::dvec3>(const ViewRay&)>;
std::optional<glm::dvec3> pixel_mean(const Camera& camera, const RenderSettings& settings, std::uint32_t x,
                                     std::uint32_t y, const RayRadiance& radiance);

// Where the ray meets the plane through `point` with that normal.
glm::dvec3 meet_plane(const ViewRay& ray, const glm::dvec3& point, const glm::dvec3& normal);
// Where the ray enters the sphere; none if it misses, or comes within a hundredth of the outline.
std::optional<glm::dvec3> meet_sphere(const ViewRay& ray, const glm::dvec3& center, double radius);

// Tests the beauty layer's pixels against `radiance` (none: the pixel is not tested): every pixel by its
// variance, and the mean residuals of the picture and of its sixteen parts by the residuals' own spread,
// which stratified sampling makes much narrower. `relative`: by which the expectation itself may be off, from
// tessellation or rounding.
void expect_radiance(const Image& image, const Camera& camera, const RenderSettings& settings,
                     const RayRadiance& radiance, double relative = 1e-5);

// Tests that two estimators' images have equal means, in sixteen parts of the picture and as a whole, by the
// differences' own spread.
void expect_equal_means(const Image& a, const Image& b, const std::string& what);

glm::dvec3 pixel(const Image& image, std::string_view layer, std::uint32_t x, std::uint32_t y);

} // namespace ajar::test
