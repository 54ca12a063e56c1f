// Recording and timing: order, reuse, and times that can be true.
#include "gpu_test.hpp"

#include <chrono>

namespace ajar::gpu {
namespace {

class GpuCommands : public GpuTest {
  protected:
    void SetUp() override {
        Device& d = device();
        out = Buffer(d, COUNT * 4, "out");
        bindings = std::make_unique<Bindings>(d);
        bindings->storage(shared::BIND_PATHS, out);
        const Specialization constants = {{shared::SPEC_WORKGROUP_SIZE, 8}};
        fill = std::make_unique<Kernel<TestArgs>>(d, test_kernels(), "fill", constants);
        commands = std::make_unique<Commands>(d);
        commands->bind(*bindings);
        timestamps = d.limits().timestamps;
    }
    void TearDown() override {
        commands.reset();
        fill.reset();
        bindings.reset();
        out = Buffer();
        GpuTest::TearDown();
    }

    static constexpr std::uint32_t COUNT = 4096;
    Buffer out;
    std::unique_ptr<Bindings> bindings;
    std::unique_ptr<Kernel<TestArgs>> fill;
    std::unique_ptr<Commands> commands;
    bool timestamps = false;
};

TEST_F(GpuCommands, RunDispatchesInOrder) {
    for (std::uint32_t i = 0; i <= 10; ++i) fill->dispatch(*commands, {COUNT, 0, i}, COUNT / 8);
    commands->submit();
    EXPECT_EQ(out.read<std::uint32_t>(0, COUNT), std::vector<std::uint32_t>(COUNT, 10));
}

TEST_F(GpuCommands, TimeEachKernelWithinTheWallTime) {
    const auto begin = std::chrono::steady_clock::now();
    double seconds = 0;
    for (std::uint32_t i = 0; i < 4; ++i) {
        fill->dispatch(*commands, {COUNT, 1, i}, COUNT / 8);
        fill->dispatch(*commands, {COUNT, 2, i}, COUNT / 8);
        const double now = commands->submit();
        EXPECT_GE(now, 0);
        seconds += now;
    }
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
    ASSERT_EQ(commands->profile().size(), 1u);
    const KernelTime& time = commands->profile().at("fill");
    EXPECT_EQ(time.dispatches, 8u);
    EXPECT_LE(seconds, wall.count());
    if (timestamps) {
        EXPECT_GT(time.seconds, 0);
        EXPECT_NEAR(time.seconds, seconds, 1e-9);
    }
}

TEST_F(GpuCommands, TimeMoreDispatchesThanOneQueryPoolHolds) {
    for (std::uint32_t round = 0; round < 2; ++round) {
        for (std::uint32_t i = 0; i < 1300; ++i) fill->dispatch(*commands, {8, 0, i}, 1);
        const auto begin = std::chrono::steady_clock::now();
        const double seconds = commands->submit();
        const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
        EXPECT_LE(seconds, wall.count()); // a timestamp that runs backwards would make it centuries
    }
    EXPECT_EQ(commands->profile().at("fill").dispatches, 2600u);
}

TEST_F(GpuCommands, ForgetWhatWasReset) {
    fill->dispatch(*commands, {COUNT, 0, 1}, COUNT / 8);
    commands->reset();
    EXPECT_EQ(commands->submit(), 0);
    EXPECT_TRUE(commands->profile().empty());
    EXPECT_EQ(out.read<std::uint32_t>(0, COUNT), std::vector<std::uint32_t>(COUNT, 0));
    fill->dispatch(*commands, {COUNT, 0, 2}, COUNT / 8); // the bindings stay
    commands->submit();
    EXPECT_EQ(out.read<std::uint32_t>(0, COUNT), std::vector<std::uint32_t>(COUNT, 2));
}

TEST_F(GpuCommands, SkipDispatchesOfNoWorkgroups) {
    fill->dispatch(*commands, {COUNT, 0, 1}, 0);
    EXPECT_EQ(commands->submit(), 0);
    EXPECT_TRUE(commands->profile().empty());
}

} // namespace
} // namespace ajar::gpu
