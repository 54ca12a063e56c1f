// Which device is chosen, what it says about itself, and one clear line where there is none.
#include "gpu_test.hpp"

#include <algorithm>
#include <cstdlib>

namespace ajar::gpu {
namespace {

class GpuDevice : public GpuTest {};

TEST_F(GpuDevice, IsTheFirstUsableOneUnlessSelected) {
    const Device& d = device();
    EXPECT_TRUE(d.description().usable());
    EXPECT_FALSE(d.description().name.empty());
    EXPECT_FALSE(d.description().driver.empty());
}

TEST_F(GpuDevice, IsSelectedByIndex) {
    for (const DeviceDescription& listed : list_devices()) {
        if (!listed.usable()) continue;
        const Device& d = device({.select = std::to_string(listed.index)});
        EXPECT_EQ(d.description().name, listed.name);
        EXPECT_EQ(d.description().index, listed.index);
    }
}

TEST_F(GpuDevice, IsSelectedByPartOfItsNameInAnyCase) {
    std::string part = device().description().name.substr(1, 5);
    for (char& c : part) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    const Device& d = device({.select = part});
    EXPECT_NE(d.description().name, "");
}

TEST_F(GpuDevice, ListsWhatThereIsWhenNoneMatches) {
    const std::string name = device().description().name;
    for (const char* select : {"no such device", "4294967295", "99999999999999999999", "-1"}) {
        const std::string error = error_of([&] { const Device d(DeviceOptions{.select = select}); });
        EXPECT_NE(error.find("no Vulkan device matches"), std::string::npos) << error;
        EXPECT_NE(error.find(name), std::string::npos) << error;
    }
}

TEST_F(GpuDevice, KnowsItsLimits) {
    const DeviceLimits& limits = device().limits();
    EXPECT_GE(limits.max_workgroup_size, 128u); // the least that Vulkan allows
    EXPECT_GE(limits.max_storage_bytes, std::uint64_t(1) << 27);
    EXPECT_GE(limits.max_allocation_bytes, std::uint64_t(1) << 30);
    EXPECT_GE(limits.max_texel_elements, 65536u);
    EXPECT_GT(limits.memory_bytes, 0u);
    EXPECT_GE(limits.subgroup_size, 1u);
}

TEST_F(GpuDevice, RefusesAWorkgroupSizeBeyondItsLimits) {
    const std::uint32_t most = device().limits().max_workgroup_size;
    const std::string error = error_of([&] { const Device d(DeviceOptions{.workgroup_size = most + 1}); });
    EXPECT_NE(error.find("workgroup size"), std::string::npos) << error;
}

TEST_F(GpuDevice, ReportsWhatTheValidationLayerSees) {
    std::vector<std::string> messages;
    DeviceOptions options;
    options.validation = true;
    options.on_validation = [&](std::string_view message) { messages.emplace_back(message); };
    try {
        const Device d(options);
        // A kernel that declares 64-bit integers (capability 11), which Ajar does not enable, but has none.
        const auto fill = std::find_if(test_kernels().begin(), test_kernels().end(),
                                       [](const EmbeddedKernel& kernel) { return kernel.name == "fill"; });
        std::vector<std::uint32_t> words(fill->spirv.begin(), fill->spirv.end());
        words.insert(words.begin() + 5, {2u << 16 | 17u, 11u}); // OpCapability, after the header
        error_of([&] { const Kernel<TestArgs> kernel(d, words, "int64", {}); }); // may or may not be made
    } catch (const Error& error) {
        if (std::string_view(error.what()).find("validationlayers") != std::string_view::npos) GTEST_SKIP();
        throw;
    }
    EXPECT_FALSE(messages.empty());
}

// The loader reads these when an instance is made.
TEST(GpuDriver, IsNamedWhenThereIsNone) {
    setenv("VK_DRIVER_FILES", "/no/such/driver.json", 1);
    setenv("VK_ICD_FILENAMES", "/no/such/driver.json", 1);
    const std::string error = error_of([] { list_devices(); });
    const std::string same = error_of([] { const Device d(DeviceOptions{}); });
    unsetenv("VK_DRIVER_FILES");
    unsetenv("VK_ICD_FILENAMES");
    EXPECT_NE(error.find("install mesa-vulkan-drivers"), std::string::npos) << error;
    EXPECT_EQ(error, same);
}

} // namespace
} // namespace ajar::gpu
