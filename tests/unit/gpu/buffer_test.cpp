// Device memory: what is written is read, directly and through staging memory; too much is refused in words.
#include "gpu_test.hpp"

#include <numeric>

namespace ajar::gpu {
namespace {

class GpuBuffer : public GpuTest {};

void expect_round_trip(const Device& device) {
    std::vector<std::uint32_t> values(10'000);
    std::iota(values.begin(), values.end(), 1u);
    Buffer buffer(device, 20'001 * 4, "numbers");
    buffer.write(std::span<const std::uint32_t>(values), 5);
    EXPECT_EQ(buffer.read<std::uint32_t>(5, 10'000), values);
    EXPECT_EQ(buffer.read<std::uint32_t>(0, 5), std::vector<std::uint32_t>(5, 0));
    EXPECT_EQ(buffer.read<std::uint32_t>(10'005, 9'996), std::vector<std::uint32_t>(9'996, 0));
    buffer.clear();
    EXPECT_EQ(buffer.read<std::uint32_t>(0, 20'001), std::vector<std::uint32_t>(20'001, 0));
}

TEST_F(GpuBuffer, ReadsWhatWasWrittenAndZeroesElsewhere) { expect_round_trip(device()); }

TEST_F(GpuBuffer, DoesTheSameThroughStagingMemory) { expect_round_trip(device({.force_staging = true})); }

TEST_F(GpuBuffer, MovesMoreThanOneStagingPiece) {
    Device& d = device({.force_staging = true});
    std::vector<std::uint64_t> values((std::size_t(70) << 20) / sizeof(std::uint64_t)); // pieces are 64 MiB
    std::iota(values.begin(), values.end(), 1u);
    Buffer buffer(d, values.size() * 8, "large");
    buffer.write(std::span<const std::uint64_t>(values));
    EXPECT_TRUE(buffer.read<std::uint64_t>(0, values.size()) == values); // EXPECT_EQ would print all of them
}

TEST_F(GpuBuffer, KernelsSeeWhatWasStaged) {
    Device& d = device({.force_staging = true});
    const auto words = run_words(d, "fill", {3, 2, 1}, {{shared::SPEC_WORKGROUP_SIZE, 8}}, 3);
    EXPECT_EQ(words, (std::vector<std::uint32_t>{1, 3, 5}));
}

TEST_F(GpuBuffer, MayBeEmpty) {
    Buffer buffer(device(), 0, "nothing");
    EXPECT_EQ(buffer.size_bytes(), 0u);
    EXPECT_NE(buffer.address(), 0u); // a kernel may hold the pointer, only not follow it
    buffer.clear();
    EXPECT_TRUE(buffer.read<std::uint32_t>(0, 0).empty());
    EXPECT_FALSE(Buffer());
    EXPECT_EQ(Buffer().address(), 0u);
}

TEST_F(GpuBuffer, KeepsItsAddressWhenMoved) {
    Buffer first(device(), 64, "moved");
    const std::uint64_t address = first.address();
    Buffer second = std::move(first);
    EXPECT_EQ(second.address(), address);
    EXPECT_FALSE(first); // NOLINT(bugprone-use-after-move)
}

TEST_F(GpuBuffer, RefusesAnExbibyteAndSaysHowMuchThereIs) {
    Device& d = device();
    const std::string error = error_of([&] { const Buffer buffer(d, std::uint64_t(1) << 60, "paths"); });
    EXPECT_NE(error.find("buffer paths"), std::string::npos) << error;
    EXPECT_NE(error.find("1.0 EiB"), std::string::npos) << error;
    EXPECT_NE(error.find(d.description().name), std::string::npos) << error;
}

TEST_F(GpuBuffer, WorksOnAfterARefusal) {
    Device& d = device();
    EXPECT_NE(error_of([&] { const Buffer buffer(d, ~std::uint64_t(0), "all"); }), "");
    EXPECT_NE(error_of([&] { const Buffer buffer(d, d.limits().max_allocation_bytes + 1, "more"); }), "");
    expect_round_trip(d);
}

} // namespace
} // namespace ajar::gpu
