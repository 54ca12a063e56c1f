// Choosing a device, creating it with what Ajar needs, and what all its kernels share.
#include "base/error.hpp"
#include "base/hash.hpp"
#include "gpu/device_impl.hpp"
#include "gpu/pipeline_cache.hpp"
#include "shaders/shared/bindings.glsl.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <optional>

namespace ajar::gpu {
namespace {

std::string lower(std::string_view text) {
    std::string result(text);
    for (char& c : result) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return result;
}

std::optional<std::uint32_t> as_index(std::string_view text) {
    std::uint32_t value = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (problem != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

// Lower is better.
int rank(const DeviceDescription& description) {
    constexpr std::array order = {"discrete GPU", "integrated GPU", "virtual GPU", "CPU"};
    return static_cast<int>(std::find(order.begin(), order.end(), description.kind) - order.begin());
}

std::string lacks(const DeviceDescription& d) {
    return fmt::format("device {} ({}) lacks {}", d.index, d.name, fmt::join(d.missing, ", "));
}

std::size_t choose(const std::vector<Facts>& devices, const std::string& select) {
    std::vector<std::size_t> matches;
    const auto index = as_index(select);
    for (std::size_t i = 0; i < devices.size(); ++i) {
        const DeviceDescription& d = devices[i].description;
        const bool by_name = lower(d.name).find(lower(select)) != std::string::npos;
        if (index ? *index == d.index : by_name) matches.push_back(i);
    }
    if (matches.empty()) {
        std::vector<std::string> all;
        for (const Facts& d : devices)
            all.push_back(fmt::format("{}: {}", d.description.index, d.description.name));
        throw Error(
            fmt::format("no Vulkan device matches \"{}\" (there are {})", select, fmt::join(all, "; ")));
    }
    std::stable_sort(matches.begin(), matches.end(), [&](std::size_t a, std::size_t b) {
        const auto key = [&](std::size_t i) {
            return std::pair(!devices[i].description.usable(), rank(devices[i].description));
        };
        return key(a) < key(b);
    });
    if (!devices[matches.front()].description.usable()) {
        std::vector<std::string> all;
        for (const std::size_t i : matches) all.push_back(lacks(devices[i].description));
        throw Error(fmt::format("no usable Vulkan device: {} (install mesa-vulkan-drivers for a CPU device)",
                                fmt::join(all, "; ")));
    }
    return matches.front();
}

CacheKey cache_key(const vk::raii::PhysicalDevice& physical) {
    const auto properties = physical.getProperties();
    CacheKey key{properties.vendorID, properties.deviceID, properties.driverVersion, {}};
    std::memcpy(key.uuid, properties.pipelineCacheUUID.data(), sizeof(key.uuid));
    return key;
}

vk::raii::PipelineCache make_cache(const vk::raii::Device& device, std::span<const std::byte> data) {
    try {
        return {device, vk::PipelineCacheCreateInfo({}, data.size(), data.data())};
    } catch (const vk::SystemError&) { // a driver that dislikes its own data
        return {device, vk::PipelineCacheCreateInfo()};
    }
}

} // namespace

Device::Impl::Impl(const DeviceOptions& options_in)
    : options(options_in), instance(options.validation, &options.on_validation) {
    auto devices = instance.physical_devices();
    std::vector<Facts> all;
    for (const auto& candidate : devices)
        all.push_back(describe(candidate, static_cast<std::uint32_t>(all.size())));
    const std::size_t chosen = choose(all, options.select);
    physical = std::move(devices[chosen]);
    facts = std::move(all[chosen]);
    if (options.workgroup_size > facts.limits.max_workgroup_size) {
        throw Error(fmt::format("workgroup size {}: {} allows at most {}", options.workgroup_size,
                                facts.description.name, facts.limits.max_workgroup_size));
    }
    try {
        create_device();
        const auto stored = load_cache(options.cache_folder, cache_key(physical));
        cache = make_cache(device, stored);
        cache_hash = content_hash(stored);
        create_layouts();
    } catch (const vk::SystemError& error) {
        throw_error("device " + facts.description.name, error);
    }
}

void Device::Impl::create_device() {
    std::vector<const char*> extensions;
    vk::PhysicalDeviceSubgroupSizeControlFeaturesEXT subgroup_features(true, true);
    vk::PhysicalDeviceVulkan12Features features;
    features.bufferDeviceAddress = true;
    features.scalarBlockLayout = true;
    if (facts.can_require_subgroup_size) {
        extensions.push_back(VK_EXT_SUBGROUP_SIZE_CONTROL_EXTENSION_NAME);
        features.pNext = &subgroup_features;
    }
    const float priority = 1;
    const vk::DeviceQueueCreateInfo queue_info({}, facts.queue_family, 1, &priority);
    vk::DeviceCreateInfo info({}, queue_info, {}, extensions);
    info.pNext = &features;
    device = vk::raii::Device(physical, info);
    queue = device.getQueue(facts.queue_family, 0);
}

void Device::Impl::create_layouts() {
    using Type = vk::DescriptorType;
    std::vector<vk::DescriptorSetLayoutBinding> bindings;
    const auto add = [&](std::uint32_t first, std::uint32_t last, Type type) {
        for (std::uint32_t i = first; i <= last; ++i) {
            bindings.emplace_back(i, type, 1, vk::ShaderStageFlagBits::eCompute);
        }
    };
    add(shared::BIND_FRAME, shared::BIND_FRAME, Type::eUniformBuffer);
    add(shared::BIND_STORAGE_FIRST, shared::BIND_STORAGE_LAST, Type::eStorageBuffer);
    add(shared::BIND_TEXEL_FIRST, shared::BIND_TEXEL_LAST, Type::eUniformTexelBuffer);
    set_layout = vk::raii::DescriptorSetLayout(device, vk::DescriptorSetLayoutCreateInfo({}, bindings));
    const vk::PushConstantRange args(vk::ShaderStageFlagBits::eCompute, 0, 128);
    pipeline_layout = vk::raii::PipelineLayout(device, vk::PipelineLayoutCreateInfo({}, *set_layout, args));
}

Device::Device(const DeviceOptions& options) : impl_(std::make_unique<Impl>(options)) {}

Device::~Device() {
    try {
        impl_->device.waitIdle();
        const std::vector<std::uint8_t> data = impl_->cache.getData();
        const auto bytes = std::as_bytes(std::span(data));
        if (!impl_->options.cache_folder.empty() && content_hash(bytes) != impl_->cache_hash) {
            store_cache(impl_->options.cache_folder, cache_key(impl_->physical), bytes);
        }
    } catch (const std::exception&) { // a lost device has nothing to store
    }
    impl_->staging.reset();
}

const DeviceDescription& Device::description() const { return impl_->facts.description; }
const DeviceLimits& Device::limits() const { return impl_->facts.limits; }
const DeviceOptions& Device::options() const { return impl_->options; }

std::uint32_t Device::workgroup_size() const {
    if (options().workgroup_size != 0) return options().workgroup_size;
    return limits().is_cpu ? limits().subgroup_size : std::min(64u, limits().max_workgroup_size);
}

} // namespace ajar::gpu
