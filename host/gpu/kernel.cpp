// Kernels: SPIR-V with its specialization, as a pipeline.
#include "gpu/kernel.hpp"

#include "base/error.hpp"
#include "base/hash.hpp"
#include "gpu/device_impl.hpp"
#include "production_kernels.hpp"
#include "shaders/shared/specialization.glsl.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace ajar::gpu {
namespace {

constexpr std::string_view SUBGROUP_SUFFIX = ".subgroup";

std::span<const std::uint32_t> find(KernelSet set, std::string_view name) {
    const auto found =
        std::find_if(set.begin(), set.end(), [&](const auto& kernel) { return kernel.name == name; });
    return found == set.end() ? std::span<const std::uint32_t>() : found->spirv;
}

std::uint32_t workgroup_size_of(const Device& device, const Specialization& specialization) {
    for (const auto& [id, value] : specialization) {
        if (id == shared::SPEC_WORKGROUP_SIZE) return value;
    }
    return device.workgroup_size();
}

bool subgroup_is_workgroup(const Device& device, std::uint32_t workgroup_size) {
    const DeviceLimits& limits = device.limits();
    return limits.subgroup_shuffle && limits.subgroup_size_fixed && limits.subgroup_size == workgroup_size;
}

struct Choice {
    std::span<const std::uint32_t> spirv;
    bool full_subgroups = false;
};

Choice choose(const Device& device, KernelSet set, std::string_view name,
              const Specialization& specialization) {
    const auto plain = find(set, name);
    if (plain.empty()) {
        std::vector<std::string_view> known;
        for (const EmbeddedKernel& kernel : set) {
            if (!kernel.name.ends_with(SUBGROUP_SUFFIX)) known.push_back(kernel.name);
        }
        throw Error(
            fmt::format("kernel {}: not part of this program (it has {})", name, fmt::join(known, ", ")));
    }
    if (subgroup_is_workgroup(device, workgroup_size_of(device, specialization))) {
        const auto variant = find(set, std::string(name) + std::string(SUBGROUP_SUFFIX));
        if (!variant.empty() && !std::equal(variant.begin(), variant.end(), plain.begin(), plain.end())) {
            return {variant, true};
        }
    }
    return {plain, false};
}

} // namespace

KernelBase::Impl::Impl(const Device& device, std::span<const std::uint32_t> spirv, std::string_view label,
                       Specialization specialization, std::uint32_t args_bytes_in, bool full_subgroups)
    : name(label), args_bytes(args_bytes_in) {
    const Device::Impl& owner = device.impl();
    const std::uint32_t workgroup_size = workgroup_size_of(device, specialization);
    if (workgroup_size == 0 || workgroup_size > device.limits().max_workgroup_size) {
        throw Error(fmt::format("kernel {}: workgroup size {}, but {} allows 1 to {}", name, workgroup_size,
                                device.description().name, device.limits().max_workgroup_size));
    }
    if (std::none_of(specialization.begin(), specialization.end(),
                     [](const auto& pair) { return pair.first == shared::SPEC_WORKGROUP_SIZE; })) {
        specialization.emplace_back(shared::SPEC_WORKGROUP_SIZE, workgroup_size);
    }
    std::vector<vk::SpecializationMapEntry> entries;
    std::vector<std::uint32_t> values;
    for (const auto& [id, value] : specialization) {
        entries.emplace_back(id, static_cast<std::uint32_t>(values.size() * sizeof(value)), sizeof(value));
        values.push_back(value);
    }
    const vk::SpecializationInfo constants(static_cast<std::uint32_t>(entries.size()), entries.data(),
                                           values.size() * sizeof(values[0]), values.data());
    try {
        const vk::raii::ShaderModule module(owner.device,
                                            vk::ShaderModuleCreateInfo({}, spirv.size_bytes(), spirv.data()));
        vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *module, "main",
                                                &constants);
        const vk::PipelineShaderStageRequiredSubgroupSizeCreateInfoEXT size(device.limits().subgroup_size);
        if (full_subgroups && owner.facts.can_require_subgroup_size) {
            stage.flags = vk::PipelineShaderStageCreateFlagBits::eRequireFullSubgroupsEXT;
            stage.pNext = &size;
        }
        pipeline = owner.device.createComputePipeline(
            owner.cache, vk::ComputePipelineCreateInfo({}, stage, *owner.pipeline_layout));
        owner.set_name(pipeline, name);
    } catch (const vk::SystemError& error) {
        throw_error("kernel " + name, error);
    }
}

KernelBase::KernelBase(const Device& device, KernelSet set, std::string_view name,
                       const Specialization& specialization, std::uint32_t args_bytes) {
    const Choice choice = choose(device, set, name, specialization);
    // Embedded SPIR-V lives as long as the program, so its address stands for it.
    std::string key = fmt::format("{} {} {} {}", name, static_cast<const void*>(choice.spirv.data()),
                                  args_bytes, choice.full_subgroups);
    for (const auto& [id, value] : specialization) key += fmt::format(" {}={}", id, value);
    const Device::Impl& owner = device.impl();
    {
        const std::lock_guard lock(owner.kernels_mutex);
        impl_ = owner.kernels[key];
    }
    if (impl_) return;
    impl_ =
        std::make_shared<Impl>(device, choice.spirv, name, specialization, args_bytes, choice.full_subgroups);
    const std::lock_guard lock(owner.kernels_mutex);
    owner.kernels[key] = impl_;
}

KernelBase::KernelBase(const Device& device, std::string_view name, const Specialization& specialization,
                       std::uint32_t args_bytes)
    : KernelBase(device, embedded_kernels(), name, specialization, args_bytes) {}

KernelBase::KernelBase(const Device& device, std::span<const std::uint32_t> spirv, std::string_view label,
                       const Specialization& specialization, std::uint32_t args_bytes)
    : impl_(std::make_shared<Impl>(device, spirv, label, specialization, args_bytes, false)) {}

KernelBase::~KernelBase() = default;
KernelBase::KernelBase(KernelBase&&) noexcept = default;
KernelBase& KernelBase::operator=(KernelBase&&) noexcept = default;

const std::string& KernelBase::name() const { return impl_->name; }

void KernelBase::record(Commands& commands, const void* args, std::uint32_t group_count) const {
    commands.impl().dispatch(*impl_, args, group_count);
}

KernelSet embedded_kernels() { return production_kernels(); }

std::span<const std::uint32_t> embedded_kernel(std::string_view name) {
    return find(embedded_kernels(), name);
}

std::vector<std::string> embedded_kernel_names() {
    std::vector<std::string> names;
    for (const EmbeddedKernel& kernel : embedded_kernels()) names.emplace_back(kernel.name);
    return names;
}

std::string embedded_kernel_hash(std::string_view name) {
    const auto spirv = embedded_kernel(name);
    return spirv.empty() ? std::string() : content_hash(std::as_bytes(spirv));
}

} // namespace ajar::gpu
