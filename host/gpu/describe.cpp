// What a physical device is, what Ajar needs and it lacks, and the limits the rest of the house asks for.
#include "gpu/device_impl.hpp"
#include "shaders/shared/bindings.glsl.h"

#include <fmt/format.h>

#include <algorithm>

namespace ajar::gpu {
namespace {

constexpr std::uint32_t STORAGE_BINDINGS = shared::BIND_STORAGE_LAST - shared::BIND_STORAGE_FIRST + 1;
constexpr std::uint32_t PUSH_CONSTANT_BYTES = 128;

std::string kind_of(vk::PhysicalDeviceType type) {
    switch (type) {
    case vk::PhysicalDeviceType::eDiscreteGpu: return "discrete GPU";
    case vk::PhysicalDeviceType::eIntegratedGpu: return "integrated GPU";
    case vk::PhysicalDeviceType::eVirtualGpu: return "virtual GPU";
    case vk::PhysicalDeviceType::eCpu: return "CPU";
    default: return "other";
    }
}

std::string version_text(std::uint32_t version) {
    return fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(version), VK_API_VERSION_MINOR(version),
                       VK_API_VERSION_PATCH(version));
}

void find_queue(const vk::raii::PhysicalDevice& physical, Facts& facts, float timestamp_period) {
    const auto families = physical.getQueueFamilyProperties();
    const auto found = std::find_if(families.begin(), families.end(), [](const auto& family) {
        return family.queueCount > 0 && (family.queueFlags & vk::QueueFlagBits::eCompute);
    });
    if (found == families.end()) {
        facts.description.missing.emplace_back("a compute queue");
        return;
    }
    facts.queue_family = static_cast<std::uint32_t>(found - families.begin());
    facts.timestamp_bits = found->timestampValidBits;
    facts.timestamp_seconds = static_cast<double>(timestamp_period) * 1e-9;
    facts.limits.timestamps = facts.timestamp_bits > 0 && timestamp_period > 0;
}

void check_limits(const vk::PhysicalDeviceLimits& limits, std::vector<std::string>& missing) {
    const auto need = [&](std::uint32_t has, std::uint32_t wants, const char* name) {
        if (has < wants) missing.push_back(fmt::format("{} of {} (has {})", name, wants, has));
    };
    need(limits.maxPerStageDescriptorStorageBuffers, STORAGE_BINDINGS, "maxPerStageDescriptorStorageBuffers");
    need(limits.maxPerStageDescriptorSampledImages, shared::TEXEL_BINDING_COUNT,
         "maxPerStageDescriptorSampledImages");
    need(limits.maxPerStageResources, STORAGE_BINDINGS + shared::TEXEL_BINDING_COUNT + 1,
         "maxPerStageResources");
    need(limits.maxPushConstantsSize, PUSH_CONSTANT_BYTES, "maxPushConstantsSize");
}

void check_features(const vk::raii::PhysicalDevice& physical, std::vector<std::string>& missing) {
    const auto chain =
        physical.getFeatures2<vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceVulkan12Features>();
    const auto& features = chain.get<vk::PhysicalDeviceVulkan12Features>();
    if (!features.bufferDeviceAddress) missing.emplace_back("bufferDeviceAddress");
    if (!features.scalarBlockLayout) missing.emplace_back("scalarBlockLayout");
    for (const auto format : {vk::Format::eR32G32B32A32Uint, vk::Format::eR8G8B8A8Unorm}) {
        if (!(physical.getFormatProperties(format).bufferFeatures &
              vk::FormatFeatureFlagBits::eUniformTexelBuffer)) {
            missing.push_back("uniform texel buffers of " + vk::to_string(format));
        }
    }
}

// Sizes vary per kernel on some GPUs unless VK_EXT_subgroup_size_control pins them.
void read_subgroups(const vk::raii::PhysicalDevice& physical, Facts& facts) {
    const auto extensions = physical.enumerateDeviceExtensionProperties();
    facts.has_subgroup_size_control = std::any_of(extensions.begin(), extensions.end(), [](const auto& e) {
        return std::string_view(e.extensionName.data()) == VK_EXT_SUBGROUP_SIZE_CONTROL_EXTENSION_NAME;
    });
    const auto subgroups =
        physical.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceSubgroupProperties>()
            .get<vk::PhysicalDeviceSubgroupProperties>();
    using Feature = vk::SubgroupFeatureFlagBits;
    const auto wanted = Feature::eBasic | Feature::eVote | Feature::eBallot | Feature::eShuffle;
    facts.limits.subgroup_size = std::max(1u, subgroups.subgroupSize);
    facts.limits.subgroup_shuffle = (subgroups.supportedOperations & wanted) == wanted &&
                                    (subgroups.supportedStages & vk::ShaderStageFlagBits::eCompute);
    if (!facts.has_subgroup_size_control) return;

    const auto sizes = physical
                           .getProperties2<vk::PhysicalDeviceProperties2,
                                           vk::PhysicalDeviceSubgroupSizeControlPropertiesEXT>()
                           .get<vk::PhysicalDeviceSubgroupSizeControlPropertiesEXT>();
    const auto features =
        physical.getFeatures2<vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceSubgroupSizeControlFeaturesEXT>()
            .get<vk::PhysicalDeviceSubgroupSizeControlFeaturesEXT>();
    facts.can_require_subgroup_size =
        features.subgroupSizeControl && features.computeFullSubgroups &&
        (sizes.requiredSubgroupSizeStages & vk::ShaderStageFlagBits::eCompute) &&
        sizes.minSubgroupSize <= subgroups.subgroupSize && subgroups.subgroupSize <= sizes.maxSubgroupSize;
    facts.limits.subgroup_size_fixed =
        facts.can_require_subgroup_size || sizes.minSubgroupSize == sizes.maxSubgroupSize;
}

void read_limits(const vk::raii::PhysicalDevice& physical, const vk::PhysicalDeviceLimits& from,
                 Facts& facts) {
    DeviceLimits& limits = facts.limits;
    limits.max_workgroup_size =
        std::min(from.maxComputeWorkGroupInvocations, from.maxComputeWorkGroupSize[0]);
    limits.max_storage_bytes = from.maxStorageBufferRange;
    limits.max_texel_elements = from.maxTexelBufferElements;
    limits.max_allocation_bytes =
        physical.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceMaintenance3Properties>()
            .get<vk::PhysicalDeviceMaintenance3Properties>()
            .maxMemoryAllocationSize;
    facts.max_group_count[0] = from.maxComputeWorkGroupCount[0];
    facts.max_group_count[1] = from.maxComputeWorkGroupCount[1];
    facts.max_uniform_bytes = from.maxUniformBufferRange;
    const auto memory = physical.getMemoryProperties();
    for (std::uint32_t i = 0; i < memory.memoryHeapCount; ++i) {
        const auto& heap = memory.memoryHeaps[i];
        if (heap.flags & vk::MemoryHeapFlagBits::eDeviceLocal) {
            limits.memory_bytes = std::max<std::uint64_t>(limits.memory_bytes, heap.size);
        }
    }
}

} // namespace

Facts describe(const vk::raii::PhysicalDevice& physical, std::uint32_t index) {
    const auto properties = physical.getProperties();
    Facts facts;
    facts.description.index = index;
    facts.description.name = properties.deviceName.data();
    facts.description.kind = kind_of(properties.deviceType);
    facts.description.api_version = version_text(properties.apiVersion);
    facts.description.driver = fmt::format("driver {:#x}", properties.driverVersion);
    facts.limits.is_cpu = properties.deviceType == vk::PhysicalDeviceType::eCpu;
    find_queue(physical, facts, properties.limits.timestampPeriod);
    check_limits(properties.limits, facts.description.missing);
    if (properties.apiVersion < VK_API_VERSION_1_2) { // what follows may not even be asked
        facts.description.missing.push_back("Vulkan 1.2 (has " + facts.description.api_version + ")");
        return facts;
    }
    const auto driver =
        physical.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties>()
            .get<vk::PhysicalDeviceDriverProperties>();
    facts.description.driver = fmt::format("{} {}", driver.driverName.data(), driver.driverInfo.data());
    check_features(physical, facts.description.missing);
    read_subgroups(physical, facts);
    read_limits(physical, properties.limits, facts);
    return facts;
}

} // namespace ajar::gpu
