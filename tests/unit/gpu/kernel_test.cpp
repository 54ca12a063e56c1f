// Kernels on a device: what a dispatch writes, with which arguments and constants, however many workgroups.
#include "gpu_test.hpp"

#include <numeric>

namespace ajar::gpu {
namespace {

class GpuKernel : public GpuTest {
  protected:
    // What fill.comp leaves behind.
    std::vector<std::uint32_t> fill(const Device& device, const FillArgs& args, Specialization specialization,
                                    std::uint32_t group_count) {
        Buffer buffer(device, args.count * sizeof(std::uint32_t), "out");
        Bindings bindings(device);
        bindings.storage(shared::BIND_PATHS, buffer);
        const Kernel<FillArgs> kernel(device, test_kernels(), "fill", specialization);
        Commands commands(device);
        commands.bind(bindings);
        kernel.dispatch(commands, args, group_count);
        commands.submit();
        return buffer.read<std::uint32_t>(0, args.count);
    }

    static std::vector<std::uint32_t> expected(const FillArgs& args, std::uint32_t option) {
        std::vector<std::uint32_t> values(args.count);
        for (std::uint32_t i = 0; i < args.count; ++i) values[i] = i * args.factor + args.offset + option;
        return values;
    }
};

TEST_F(GpuKernel, WritesWhatItsArgumentsSay) {
    const FillArgs args{1000, 3, 7};
    EXPECT_EQ(fill(device(), args, {{shared::SPEC_WORKGROUP_SIZE, 8}}, 125), expected(args, 0));
}

TEST_F(GpuKernel, TakesSpecializationConstants) {
    const FillArgs args{64, 1, 0};
    EXPECT_EQ(fill(device(), args, {{shared::SPEC_OPTION, 40}, {shared::SPEC_WORKGROUP_SIZE, 64}}, 1),
              expected(args, 40));
}

TEST_F(GpuKernel, GivesTheSameWithAnyWorkgroupSize) {
    const FillArgs args{777, 5, 11};
    Device& d = device();
    for (const std::uint32_t size : {1u, 8u, 32u, 64u, 128u}) {
        EXPECT_EQ(fill(d, args, {{shared::SPEC_WORKGROUP_SIZE, size}}, (args.count + size - 1) / size),
                  expected(args, 0));
    }
}

TEST_F(GpuKernel, RunsMoreWorkgroupsThanOneDimensionAllows) {
    const FillArgs args{200'003, 1, 1};
    EXPECT_EQ(fill(device(), args, {{shared::SPEC_WORKGROUP_SIZE, 1}}, args.count), expected(args, 0));
}

} // namespace
} // namespace ajar::gpu
