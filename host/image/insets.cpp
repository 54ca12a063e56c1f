// Where a contact sheet should look closely: sums over windows by summed-area tables (Crow 1984).
#include "image/contact_sheet.hpp"

#include <algorithm>
#include <cmath>

namespace ajar {
namespace {

// Sums of the errors of all pixels above and left; one row and column of zeros first.
class SumTable {
  public:
    SumTable(const Image& image, const Image& reference, const Tonemap& tonemap)
        : stride_(std::size_t{image.width} + 1), sums_(stride_ * (std::size_t{image.height} + 1)) {
        const Layer &a = beauty(image, "picture"), &b = beauty(reference, "reference");
        const auto shown = [&](const Layer& layer, std::size_t i) {
            const float* p = layer.pixels.data() + i * layer.channels;
            return tonemap(glm::vec3(p[0], p[1], p[2]));
        };
        for (std::uint32_t y = 0; y < image.height; ++y)
            for (std::uint32_t x = 0; x < image.width; ++x) {
                const std::size_t i = std::size_t{y} * image.width + x;
                const glm::vec3 error = shown(a, i) - shown(b, i);
                at(x + 1, y + 1) = double{glm::dot(error, error)} + at(x, y + 1) + at(x + 1, y) - at(x, y);
            }
    }

    // Root of the mean square.
    double error(const Region& r) const {
        const double sum = at(r.x + r.width, r.y + r.height) - at(r.x, r.y + r.height) -
                           at(r.x + r.width, r.y) + at(r.x, r.y);
        return std::sqrt(std::max(sum, 0.0) / (static_cast<double>(r.width) * r.height));
    }

  private:
    double& at(std::uint32_t x, std::uint32_t y) { return sums_[y * stride_ + x]; }
    double at(std::uint32_t x, std::uint32_t y) const { return sums_[y * stride_ + x]; }

    std::size_t stride_;
    std::vector<double> sums_;
};

// How unlike the pictures err there; the only picture of all: how much.
double interest(const std::vector<SumTable>& tables, const Region& r) {
    double low = tables.size() == 1 ? 0 : INFINITY, high = 0;
    for (const SumTable& table : tables) {
        const double error = table.error(r);
        low = std::min(low, error), high = std::max(high, error);
    }
    return high - low;
}

bool overlap(const Region& a, const Region& b) {
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

} // namespace

std::vector<Region> choose_insets(const std::vector<const Image*>& images, const Image& reference,
                                  const Tonemap& tonemap, std::uint32_t width, std::uint32_t height,
                                  std::size_t count) {
    std::vector<Region> chosen;
    if (images.empty() || width == 0 || height == 0 || width > reference.width || height > reference.height)
        return chosen;
    std::vector<SumTable> tables;
    for (const Image* image : images) tables.emplace_back(*image, reference, tonemap);
    while (chosen.size() < count) {
        Region best;
        double most = -1;
        for (std::uint32_t y = 0; y + height <= reference.height; ++y)
            for (std::uint32_t x = 0; x + width <= reference.width; ++x) {
                const Region r{x, y, width, height};
                const auto taken = [&](const Region& other) { return overlap(r, other); };
                if (std::any_of(chosen.begin(), chosen.end(), taken)) continue;
                if (const double value = interest(tables, r); value > most) most = value, best = r;
            }
        if (most < 0) break;
        chosen.push_back(best);
    }
    return chosen;
}

} // namespace ajar
