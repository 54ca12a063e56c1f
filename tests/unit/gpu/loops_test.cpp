// The loop forms that kernels may use give right values on this driver: some drivers get other forms wrong.
#include "gpu_test.hpp"

#include <algorithm>

namespace ajar::gpu {
namespace {

class GpuLoops : public GpuTest {};

constexpr std::uint32_t COUNT = 1024;
constexpr std::uint32_t ROW = 5; // words that loops.comp writes per thread

std::uint32_t next(std::uint32_t n) { return n % 2 == 0 ? n / 2 : 3 * n + 1; }

std::uint32_t nested(std::uint32_t n) {
    std::uint32_t total = 0;
    for (std::uint32_t outer = 0; outer < 16; ++outer) {
        std::uint32_t found = 99;
        for (std::uint32_t inner = 0; inner < 8 && found == 99; ++inner) {
            const std::uint32_t candidate = n + outer * 8 + inner;
            if (candidate % 7 == 3) found = candidate;
        }
        if (found == 99 || found % 11 == n % 5) return total;
        total += found;
    }
    return total;
}

TEST_F(GpuLoops, KeepTheValuesOfLanesThatLeftEarlier) {
    Device& d = device();
    const auto words =
        as<std::uint32_t>(run(d, "loops", {COUNT, 0, 0}, {{shared::SPEC_WORKGROUP_SIZE, d.workgroup_size()}},
                              COUNT, COUNT * ROW * 4));
    for (std::uint32_t i = 0; i < COUNT; ++i) {
        std::uint32_t trips = 0;
        std::uint32_t peak = i + 1;
        for (std::uint32_t n = i + 1; n != 1; ++trips) {
            n = next(n);
            peak = std::max(peak, n);
        }
        const std::vector<std::uint32_t> row(words.begin() + i * ROW, words.begin() + (i + 1) * ROW);
        ASSERT_EQ(row, (std::vector<std::uint32_t>{trips, peak, trips, peak, nested(i)})) << "lane " << i;
    }
}

} // namespace
} // namespace ajar::gpu
