#include "bake/packing.hpp"

#include <algorithm>
#include <numeric>

namespace ajar {

namespace {

// What is full lies below a line of steps from left to right.
class Skyline {
  public:
    explicit Skyline(std::uint32_t side) : side_(side), steps_{{0, 0, side}} {}

    std::optional<glm::uvec2> place(const glm::uvec2& size) {
        std::size_t best = steps_.size();
        std::uint32_t lowest = side_ + 1;
        for (std::size_t i = 0; i < steps_.size(); ++i)
            if (const std::uint32_t y = height(i, size.x); y < lowest && y + size.y <= side_)
                lowest = y, best = i;
        if (best == steps_.size()) return {};
        const glm::uvec2 at(steps_[best].x, lowest);
        raise(best, {at.x, at.y + size.y, size.x});
        return at;
    }

  private:
    struct Step {
        std::uint32_t x, y, width;
    };

    // Of the highest step under a rectangle that begins with step `i`; beyond the square if that is too near
    // its right side.
    std::uint32_t height(std::size_t i, std::uint32_t width) const {
        if (steps_[i].x + width > side_) return side_ + 1;
        std::uint32_t y = 0;
        for (std::uint32_t end = steps_[i].x + width; i < steps_.size() && steps_[i].x < end; ++i)
            y = std::max(y, steps_[i].y);
        return y;
    }

    void raise(std::size_t i, const Step& step) {
        const std::uint32_t end = step.x + step.width;
        std::size_t covered = i;
        while (covered < steps_.size() && steps_[covered].x + steps_[covered].width <= end) ++covered;
        if (covered < steps_.size() && steps_[covered].x < end) {
            steps_[covered].width -= end - steps_[covered].x;
            steps_[covered].x = end;
        }
        const auto first = steps_.begin() + static_cast<std::ptrdiff_t>(i);
        steps_.erase(first, steps_.begin() + static_cast<std::ptrdiff_t>(covered));
        steps_.insert(steps_.begin() + static_cast<std::ptrdiff_t>(i), step);
        const auto join = [&](std::size_t left) { // two neighbours of one height are one step
            if (left + 1 >= steps_.size() || steps_[left].y != steps_[left + 1].y) return;
            steps_[left].width += steps_[left + 1].width;
            steps_.erase(steps_.begin() + static_cast<std::ptrdiff_t>(left + 1));
        };
        join(i);
        if (i > 0) join(i - 1);
    }

    std::uint32_t side_;
    std::vector<Step> steps_;
};

} // namespace

std::optional<std::vector<glm::uvec2>> pack(std::span<const glm::uvec2> sizes, std::uint32_t side) {
    std::uint64_t area = 0;
    for (const glm::uvec2& size : sizes) {
        if (size.x > side || size.y > side) return {};
        area += std::uint64_t{size.x} * size.y;
    }
    if (area > std::uint64_t{side} * side) return {};
    std::vector<std::uint32_t> order(sizes.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return sizes[a].y != sizes[b].y ? sizes[a].y > sizes[b].y : sizes[a].x > sizes[b].x;
    });
    Skyline skyline(side);
    std::vector<glm::uvec2> places(sizes.size());
    for (const std::uint32_t i : order) {
        const auto place = skyline.place(sizes[i]);
        if (!place) return {};
        places[i] = *place;
    }
    return places;
}

} // namespace ajar
