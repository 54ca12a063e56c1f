#include "render_test.hpp"

#include "support/statistics.hpp"

#include <algorithm>
#include <array>

namespace ajar::test {

namespace {

constexpr std::uint32_t PARTS = 4; // of a side of the picture

// Two-sided tail of Student's t for a mean at `distance` from what is expected, by Wallace's normal
// approximation (1959), good to a few per cent of the probability from 8 degrees on.
double student_two_sided(const Moments& moments, double distance) {
    if (distance <= 0) return 1;
    const double error = moments.standard_error();
    if (error == 0) return 0;
    const double degrees = static_cast<double>(moments.count() - 1);
    const double t = distance / error;
    const double z = (8 * degrees + 1) / (8 * degrees + 3) * std::sqrt(degrees * std::log1p(t * t / degrees));
    return normal_two_sided(z);
}

// Moments of something, per channel, in each part of the picture and in all of it.
class PartMoments {
  public:
    PartMoments(std::uint32_t width, std::uint32_t height) : width_(width), height_(height) {}

    void add(std::uint32_t x, std::uint32_t y, int channel, double value, double magnitude) {
        for (const std::size_t at : {part(x, y, channel), whole(channel)}) {
            moments_[at].add(value);
            magnitudes_[at].add(magnitude);
        }
    }
    double mean(std::uint32_t x, std::uint32_t y, int channel) const {
        return moments_[part(x, y, channel)].mean();
    }

    // Expects every mean to be zero, but for `relative` of the magnitudes.
    void expect_zero(double relative, const std::string& what) const {
        const double level = sidak_level(SIGNIFICANCE, COUNT);
        for (std::size_t at = 0; at < COUNT; ++at) {
            const Moments& moments = moments_[at];
            if (moments.count() < 16) continue; // too few to know their spread
            const double magnitude = magnitudes_[at].mean();
            const double tolerance = relative * magnitude + 0x1p-27; // the film's steps
            EXPECT_GE(student_two_sided(moments, std::abs(moments.mean()) - tolerance), level)
                << what << ": " << name(at) << ", channel " << at % 3 << ": mean residual " << moments.mean()
                << " +- " << moments.standard_error() << " where values are about " << magnitude;
        }
    }

  private:
    static constexpr std::size_t COUNT = (std::size_t{PARTS} * PARTS + 1) * 3;

    std::size_t part(std::uint32_t x, std::uint32_t y, int channel) const {
        return (std::size_t{y} * PARTS / height_ * PARTS + std::size_t{x} * PARTS / width_) * 3 +
               static_cast<std::size_t>(channel);
    }
    static std::size_t whole(int channel) { return COUNT - 3 + static_cast<std::size_t>(channel); }
    static std::string name(std::size_t at) {
        if (at >= COUNT - 3) return "whole picture";
        return "part " + std::to_string(at / 3 % PARTS) + ", " + std::to_string(at / 3 / PARTS);
    }

    std::uint32_t width_;
    std::uint32_t height_;
    std::array<Moments, COUNT> moments_;
    std::array<Moments, COUNT> magnitudes_;
};

} // namespace

RenderSettings small_settings() {
    RenderSettings settings;
    settings.width = settings.height = 32;
    settings.samples = 64;
    settings.max_bounces = 0;
    return settings;
}

RenderOutput render_checked(const gpu::Device& device, const Scene& scene, const RenderSettings& settings) {
    const WarningSink warn = [](std::string_view line) { ADD_FAILURE() << "unexpected warning: " << line; };
    RenderOutput output = Renderer(device, scene, warn).render(settings);
    EXPECT_EQ(output.stats.samples, settings.samples);
    EXPECT_EQ(output.stats.invalid_samples, 0u);
    EXPECT_EQ(output.stats.saturated_samples, 0u);
    EXPECT_EQ(output.stats.exhausted_loops, 0u);
    return output;
}

ViewRay view_ray(const Camera& camera, const RenderSettings& settings, double x, double y) {
    const double aspect = static_cast<double>(settings.width) / settings.height;
    const double u = (2 * x / settings.width - 1) * aspect;
    const double v = 1 - 2 * y / settings.height;
    const glm::dmat4 to_world(camera.to_world);
    if (camera.kind == CameraKind::orthographic)
        return {glm::dvec3(to_world * glm::dvec4(u * camera.ymag, v * camera.ymag, 0, 1)),
                -glm::dvec3(to_world[2])};
    const double scale = std::tan(0.5 * camera.yfov);
    return {glm::dvec3(to_world[3]),
            glm::normalize(glm::dvec3(to_world * glm::dvec4(u * scale, v * scale, -1, 0)))};
}

std::optional<glm::dvec3> pixel_mean(const Camera& camera, const RenderSettings& settings, std::uint32_t x,
                                     std::uint32_t y, const RayRadiance& radiance) {
    constexpr int GRID = 6;
    glm::dvec3 sum(0);
    for (int j = 0; j < GRID; ++j)
        for (int i = 0; i < GRID; ++i) {
            const auto value =
                radiance(view_ray(camera, settings, x + (i + 0.5) / GRID, y + (j + 0.5) / GRID));
            if (!value) return std::nullopt;
            sum += *value;
        }
    return sum / static_cast<double>(GRID * GRID);
}

glm::dvec3 meet_plane(const ViewRay& ray, const glm::dvec3& point, const glm::dvec3& normal) {
    return ray.origin +
           ray.direction * (glm::dot(point - ray.origin, normal) / glm::dot(ray.direction, normal));
}

std::optional<glm::dvec3> meet_sphere(const ViewRay& ray, const glm::dvec3& center, double radius) {
    const glm::dvec3 to_center = center - ray.origin;
    const double along = glm::dot(to_center, ray.direction);
    const double distance = glm::length(to_center - along * ray.direction);
    if (distance > 0.99 * radius) return std::nullopt;
    return ray.origin + ray.direction * (along - std::sqrt(radius * radius - distance * distance));
}

glm::dvec3 pixel(const Image& image, std::string_view layer, std::uint32_t x, std::uint32_t y) {
    const Layer* found = image.find(layer);
    if (found == nullptr || found->channels < 3) {
        ADD_FAILURE() << "the image has no layer '" << layer << "' of three channels";
        return glm::dvec3(0);
    }
    const float* p = &found->pixels[(std::size_t{y} * image.width + x) * found->channels];
    return {p[0], p[1], p[2]};
}

void expect_radiance(const Image& image, const Camera& camera, const RenderSettings& settings,
                     const RayRadiance& radiance, double relative) {
    PartMoments parts(image.width, image.height);
    // A pixel that a rare event never reached has variance 0: its part's mean variance stands in.
    PartMoments variances(image.width, image.height);
    for (std::uint32_t y = 0; y < image.height; ++y)
        for (std::uint32_t x = 0; x < image.width; ++x)
            for (int c = 0; c < 3; ++c) variances.add(x, y, c, pixel(image, "variance", x, y)[c], 0);
    const double level = sidak_level(SIGNIFICANCE, image.pixel_count() * 3);
    std::size_t tested = 0;
    std::size_t wrong = 0;
    for (std::uint32_t y = 0; y < image.height; ++y)
        for (std::uint32_t x = 0; x < image.width; ++x) {
            const auto expected = pixel_mean(camera, settings, x, y, radiance);
            if (!expected) continue;
            ++tested;
            const glm::dvec3 mean = pixel(image, "", x, y);
            const glm::dvec3 variance = pixel(image, "variance", x, y);
            for (int c = 0; c < 3; ++c) {
                const double residual = mean[c] - (*expected)[c];
                parts.add(x, y, c, residual, std::abs((*expected)[c]));
                // The film's steps, the image's floats, and what the caller allows.
                const double allowed = 0x1p-27 + (0x1p-23 + relative) * std::abs((*expected)[c]);
                const double distance = std::max(std::abs(residual) - allowed, 0.0);
                const double deviation = std::sqrt(std::max(variance[c], variances.mean(x, y, c)));
                const double p = distance == 0 ? 1 : normal_two_sided(distance / deviation);
                if (p >= level || ++wrong > 5) continue;
                ADD_FAILURE() << "pixel " << x << ", " << y << ", channel " << c << ": " << mean[c] << " +- "
                              << deviation << " where " << (*expected)[c] << " is right";
            }
        }
    EXPECT_EQ(wrong, 0u) << "of " << 3 * tested;
    EXPECT_GE(tested, image.pixel_count() / 10) << "the expectation leaves out too much of the picture";
    parts.expect_zero(relative, "against the formula");
}

void expect_equal_means(const Image& a, const Image& b, const std::string& what) {
    ASSERT_EQ(a.width, b.width);
    ASSERT_EQ(a.height, b.height);
    PartMoments parts(a.width, a.height);
    double brightness = 0;
    for (std::uint32_t y = 0; y < a.height; ++y)
        for (std::uint32_t x = 0; x < a.width; ++x) {
            const glm::dvec3 of_a = pixel(a, "", x, y);
            const glm::dvec3 difference = of_a - pixel(b, "", x, y);
            brightness += of_a.x + of_a.y + of_a.z;
            for (int c = 0; c < 3; ++c) parts.add(x, y, c, difference[c], of_a[c]);
        }
    EXPECT_GT(brightness, 0) << what << ": black images always agree";
    parts.expect_zero(0, what);
}

} // namespace ajar::test
