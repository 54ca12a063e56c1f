// Kernels on a device: what a dispatch writes, with which arguments and constants, however many workgroups.
#include "gpu_test.hpp"

#include <algorithm>

namespace ajar::gpu {
namespace {

class GpuKernel : public GpuTest {};

std::vector<std::uint32_t> filled(const TestArgs& args, std::uint32_t option) {
    std::vector<std::uint32_t> values(args.count);
    for (std::uint32_t i = 0; i < args.count; ++i) values[i] = i * args.factor + args.offset + option;
    return values;
}

TEST_F(GpuKernel, WritesWhatItsArgumentsSay) {
    const TestArgs args{1000, 3, 7};
    EXPECT_EQ(run_words(device(), "fill", args, {{shared::SPEC_WORKGROUP_SIZE, 8}}, 1000), filled(args, 0));
}

TEST_F(GpuKernel, TakesSpecializationConstants) {
    const TestArgs args{64, 1, 0};
    const Specialization constants = {{shared::SPEC_OPTION, 40}, {shared::SPEC_WORKGROUP_SIZE, 64}};
    EXPECT_EQ(run_words(device(), "fill", args, constants, 64), filled(args, 40));
}

TEST_F(GpuKernel, GivesTheSameWithAnyWorkgroupSize) {
    const TestArgs args{777, 5, 11};
    Device& d = device();
    for (const std::uint32_t size : {1u, 8u, 32u, 64u, 128u}) {
        EXPECT_EQ(run_words(d, "fill", args, {{shared::SPEC_WORKGROUP_SIZE, size}}, 777), filled(args, 0))
            << size;
    }
}

TEST_F(GpuKernel, TakesTheDevicesWorkgroupSizeWhenNoneIsGiven) {
    const TestArgs args{100, 1, 0};
    Device& d = device({.workgroup_size = 16});
    EXPECT_EQ(d.workgroup_size(), 16u);
    EXPECT_EQ(run_words(d, "fill", args, {}, 100), filled(args, 0));
}

TEST_F(GpuKernel, RunsMoreWorkgroupsThanOneDimensionAllows) {
    const TestArgs args{200'003, 1, 1};
    EXPECT_EQ(run_words(device(), "fill", args, {{shared::SPEC_WORKGROUP_SIZE, 1}}, args.count),
              filled(args, 0));
}

TEST_F(GpuKernel, UsesShufflesOnlyWhereAWorkgroupIsOneSubgroup) {
    Device& d = device();
    const DeviceLimits& limits = d.limits();
    const std::uint32_t size = limits.subgroup_size;
    const bool expected = limits.subgroup_shuffle && limits.subgroup_size_fixed;
    const auto one =
        run_words(d, "subgroup", {2 * size, 0, 0}, {{shared::SPEC_WORKGROUP_SIZE, size}}, 2 * size);
    for (std::uint32_t i = 0; i < 2 * size; ++i) {
        const std::uint32_t first = i / size * size;
        EXPECT_EQ(one[i], expected ? 1 + size * first + size * (size - 1) / 2 : 0);
    }
    const auto many =
        run_words(d, "subgroup", {2 * size, 0, 0}, {{shared::SPEC_WORKGROUP_SIZE, 2 * size}}, 2 * size);
    EXPECT_EQ(many, std::vector<std::uint32_t>(2 * size, 0));
}

TEST_F(GpuKernel, TakesAnySpirvUnderALabel) {
    const auto fill = std::find_if(test_kernels().begin(), test_kernels().end(),
                                   [](const EmbeddedKernel& kernel) { return kernel.name == "fill"; });
    const Kernel<TestArgs> kernel(device(), fill->spirv, "filling", {{shared::SPEC_WORKGROUP_SIZE, 8}});
    EXPECT_EQ(kernel.name(), "filling");
}

TEST_F(GpuKernel, NamesAKernelThatDoesNotExist) {
    const std::string error =
        error_of([&] { const Kernel<TestArgs> kernel(device(), test_kernels(), "fil", {}); });
    EXPECT_NE(error.find("kernel fil: not part of this program"), std::string::npos) << error;
    EXPECT_NE(error.find("fill"), std::string::npos) << error;
}

TEST_F(GpuKernel, RefusesAWorkgroupThatTheDeviceCantRun) {
    Device& d = device();
    const std::uint32_t size = d.limits().max_workgroup_size + 1;
    const auto make = [&] {
        const Kernel<TestArgs> kernel(d, test_kernels(), "fill", {{shared::SPEC_WORKGROUP_SIZE, size}});
    };
    EXPECT_NE(error_of(make).find("kernel fill: workgroup size"), std::string::npos);
}

TEST_F(GpuKernel, RecordsAFailedAssert) {
    Device& d = device();
    Buffer diagnostics(d, sizeof(shared::Diagnostics), "diagnostics");
    shared::FrameRecord frame = {};
    frame.diagnostics = {diagnostics.address()};
    run(d, "assertion", {101, 0, 0}, {{shared::SPEC_WORKGROUP_SIZE, 8}}, 101, 4, &frame);
    const auto seen = diagnostics.read<shared::Diagnostics>(0, 1).front();
    EXPECT_EQ(seen.assert_count, 21u); // 0, 5, ..., 100
    EXPECT_EQ(seen.assert_line, 11u);
    EXPECT_EQ(seen.assert_thread % 5, 0u);
    EXPECT_LT(seen.assert_thread, 101u);
}

TEST_F(GpuKernel, SurvivesAFailedAssertThatNobodyListensTo) {
    run(device(), "assertion", {101, 0, 0}, {{shared::SPEC_WORKGROUP_SIZE, 8}}, 101, 4);
}

TEST(GpuEmbedding, HashesWhatIsEmbedded) {
    for (const std::string& name : embedded_kernel_names()) {
        EXPECT_EQ(embedded_kernel(name)[0], 0x07230203u) << name; // SPIR-V's magic number
        EXPECT_EQ(embedded_kernel_hash(name).size(), 32u) << name;
    }
    EXPECT_TRUE(embedded_kernel("no such kernel").empty());
    EXPECT_EQ(embedded_kernel_hash("no such kernel"), "");
}

} // namespace
} // namespace ajar::gpu
