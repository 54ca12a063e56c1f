// The largest texel comes from a pyramid of maxima, walked in strips over the triangle's outline in texture
// space, grown by the bilinear filter's reach; the mean from area-uniform points (Roberts' R2 sequence).
#include "render/emission_means.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <utility>

namespace ajar {
namespace {

constexpr int POINTS = 64;
constexpr double CELLS_ACROSS = 64; // of a triangle's footprint at the pyramid level chosen for it

struct Range {
    std::int64_t first = 0;
    std::int64_t last = -1; // inclusive
};

// The texels that unwrapped texels first..last fall on: one or two ranges, all of them where the texture
// repeats within.
std::array<Range, 2> wrapped(Range range, std::int64_t size, Wrap wrap) {
    if (wrap == Wrap::clamp)
        return {Range{std::clamp<std::int64_t>(range.first, 0, size - 1),
                      std::clamp<std::int64_t>(range.last, 0, size - 1)},
                Range{}};
    if (range.last - range.first + 1 >= size) return {Range{0, size - 1}, Range{}};
    const std::int64_t period = wrap == Wrap::mirror ? 2 * size : size;
    const std::int64_t first = ((range.first % period) + period) % period;
    const std::int64_t last = first + (range.last - range.first);
    // Odd copies of a mirrored texture run backwards.
    const auto fold = [&](std::int64_t a, std::int64_t b) {
        const std::int64_t copy = a / size;
        const bool backwards = wrap == Wrap::mirror && copy % 2 == 1;
        a -= copy * size;
        b -= copy * size;
        return backwards ? Range{size - 1 - b, size - 1 - a} : Range{a, b};
    };
    const std::int64_t border = (first / size + 1) * size;
    if (last < border) return {fold(first, last), Range{}};
    return {fold(first, border - 1), fold(border, last)};
}

// Extent in x of the part of a triangle with y in [lower, upper]; empty (min > max) where there is none.
std::pair<double, double> slab_extent(const std::array<glm::dvec2, 3>& p, double lower, double upper) {
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec2 a = p[k];
        const glm::dvec2 b = p[(k + 1) % 3];
        if (std::max(a.y, b.y) < lower || std::min(a.y, b.y) > upper) continue;
        for (const double y : {std::clamp(a.y, lower, upper), std::clamp(b.y, lower, upper)}) {
            const double x = a.y == b.y ? a.x : a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y);
            least = std::min(least, x);
            most = std::max(most, x);
        }
        if (a.y == b.y) most = std::max(most, b.x), least = std::min(least, b.x);
    }
    return {least, most};
}

// The texels whose bilinear tents reach into [least, most].
Range reach(double least, double most) {
    return {static_cast<std::int64_t>(std::floor(least - 0.5)),
            static_cast<std::int64_t>(std::floor(most - 0.5)) + 1};
}

} // namespace

EmissionMeans::Pyramid EmissionMeans::build_pyramid(const TextureImage& image) {
    Pyramid pyramid;
    Level base{image.width, image.height, {}};
    base.cells.reserve(std::size_t{image.width} * image.height);
    for (std::size_t i = 0; i + 3 < image.rgba.size(); i += 4)
        base.cells.push_back({image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]});
    pyramid.push_back(std::move(base));
    while (pyramid.back().width > 1 || pyramid.back().height > 1) {
        const Level& fine = pyramid.back();
        Level coarse{(fine.width + 1) / 2, (fine.height + 1) / 2, {}};
        coarse.cells.resize(std::size_t{coarse.width} * coarse.height);
        for (std::uint32_t y = 0; y < fine.height; ++y)
            for (std::uint32_t x = 0; x < fine.width; ++x)
                for (std::size_t c = 0; c < 3; ++c) {
                    std::uint8_t& cell = coarse.cells[std::size_t{y / 2} * coarse.width + x / 2][c];
                    cell = std::max(cell, fine.cells[std::size_t{y} * fine.width + x][c]);
                }
        pyramid.push_back(std::move(coarse));
    }
    return pyramid;
}

EmissionMeans::EmissionMeans(const Scene& scene) : scene_(scene) {
    for (std::size_t i = 0; i < decode_.size(); ++i) {
        const double v = static_cast<double>(i) / 255;
        decode_[i] = static_cast<float>(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
    }
    for (const Material& material : scene.materials) {
        if (material.emission == glm::vec3(0) || !material.emission_texture.used()) continue;
        const std::uint32_t image = scene.textures[material.emission_texture.texture].image;
        if (!pyramids_.contains(image)) pyramids_.emplace(image, build_pyramid(scene.images[image]));
    }
}

glm::vec3 EmissionMeans::mean(std::uint32_t material, const std::array<glm::vec2, 3>& uv) const {
    const Material& m = scene_.materials[material];
    if (m.emission == glm::vec3(0) || !m.emission_texture.used()) return m.emission;
    const Texture& texture = scene_.textures[m.emission_texture.texture];
    const TextureImage& image = scene_.images[texture.image];
    std::array<glm::dvec2, 3> texels;
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 at(uv[k], 1);
        texels[k] = {glm::dot(glm::dvec3(m.emission_texture.uv_row_u), at) * image.width,
                     glm::dot(glm::dvec3(m.emission_texture.uv_row_v), at) * image.height};
    }
    const glm::vec3 most = footprint_max(texture, texels);
    if (most == glm::vec3(0)) return most;
    return m.emission * glm::max(sampled_mean(texture, texels), most / float{POINTS});
}

glm::vec3 EmissionMeans::footprint_max(const Texture& texture,
                                       const std::array<glm::dvec2, 3>& texels) const {
    const Pyramid& pyramid = pyramids_.at(texture.image);
    const std::int64_t width = pyramid[0].width;
    const std::int64_t height = pyramid[0].height;
    const glm::dvec2 lower = glm::min(texels[0], glm::min(texels[1], texels[2]));
    const glm::dvec2 upper = glm::max(texels[0], glm::max(texels[1], texels[2]));
    // Beyond 2^20 repeats (and for NaN) kernels read texel 0; the whole texture is a safe superset.
    const double limit = 1048576.0 * static_cast<double>(std::min(width, height));
    const bool sane = lower.x >= -limit && lower.y >= -limit && upper.x <= limit && upper.y <= limit;
    const auto decoded = [&](const std::array<std::uint8_t, 3>& c) {
        return glm::vec3(decode_[c[0]], decode_[c[1]], decode_[c[2]]);
    };
    if (!sane) return decoded(pyramid.back().cells[0]);

    const double across = std::max(std::min(upper.x - lower.x, static_cast<double>(width)),
                                   std::min(upper.y - lower.y, static_cast<double>(height)));
    const int shift = std::clamp(static_cast<int>(std::ceil(std::log2(std::max(across / CELLS_ACROSS, 1.0)))),
                                 0, static_cast<int>(pyramid.size()) - 1);
    const Level& level = pyramid[static_cast<std::size_t>(shift)];
    std::array<std::uint8_t, 3> most{0, 0, 0};
    const auto visit = [&](Range rows, Range columns) {
        for (const Range& r : wrapped(rows, height, texture.wrap_v))
            for (const Range& c : wrapped(columns, width, texture.wrap_u))
                for (std::int64_t y = r.first >> shift; r.first <= r.last && y <= r.last >> shift; ++y)
                    for (std::int64_t x = c.first >> shift; c.first <= c.last && x <= c.last >> shift; ++x)
                        for (std::size_t k = 0; k < 3; ++k)
                            most[k] =
                                std::max(most[k], level.cells[static_cast<std::size_t>(y) * level.width +
                                                              static_cast<std::size_t>(x)][k]);
    };
    const Range rows = reach(lower.y, upper.y);
    if (rows.last - rows.first + 1 >= height) {
        visit(rows, reach(lower.x, upper.x));
        return decoded(most);
    }
    const std::int64_t strip = std::int64_t{1} << shift;
    for (std::int64_t y = rows.first; y <= rows.last; y += strip) {
        const std::int64_t end = std::min(y + strip - 1, rows.last);
        const auto [least, greatest] =
            slab_extent(texels, static_cast<double>(y) - 0.5, static_cast<double>(end) + 1.5);
        if (least <= greatest) visit({y, end}, reach(least, greatest));
    }
    return decoded(most);
}

glm::vec3 EmissionMeans::sampled_mean(const Texture& texture, const std::array<glm::dvec2, 3>& texels) const {
    const TextureImage& image = scene_.images[texture.image];
    const auto texel = [&](std::int64_t x, std::int64_t y) {
        const std::int64_t i = wrapped({x, x}, image.width, texture.wrap_u)[0].first;
        const std::int64_t j = wrapped({y, y}, image.height, texture.wrap_v)[0].first;
        const std::size_t at = 4 * (static_cast<std::size_t>(j) * image.width + static_cast<std::size_t>(i));
        return glm::dvec3(decode_[image.rgba[at]], decode_[image.rgba[at + 1]], decode_[image.rgba[at + 2]]);
    };
    glm::dvec3 sum(0);
    for (int k = 0; k < POINTS; ++k) {
        glm::dvec2 u(0.5 + k * 0.7548776662466927, 0.5 + k * 0.5698402909980532);
        u -= glm::floor(u);
        if (u.x + u.y > 1) u = 1.0 - u;
        const glm::dvec2 p = texels[0] + u.x * (texels[1] - texels[0]) + u.y * (texels[2] - texels[0]);
        if (!(std::abs(p.x) < 1e15 && std::abs(p.y) < 1e15))
            continue; // beyond all texels that can be told apart
        const double reach_back = texture.filter == TextureFilter::nearest ? 0.0 : 0.5;
        const glm::dvec2 corner = glm::floor(p - reach_back);
        const glm::dvec2 w =
            texture.filter == TextureFilter::nearest ? glm::dvec2(0) : p - reach_back - corner;
        const auto x = static_cast<std::int64_t>(corner.x);
        const auto y = static_cast<std::int64_t>(corner.y);
        sum += glm::mix(glm::mix(texel(x, y), texel(x + 1, y), w.x),
                        glm::mix(texel(x, y + 1), texel(x + 1, y + 1), w.x), w.y);
    }
    return glm::vec3(sum / double{POINTS});
}

} // namespace ajar
