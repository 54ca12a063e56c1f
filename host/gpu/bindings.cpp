// One descriptor set, and the buffer views of its tables.
#include "gpu/bindings.hpp"

#include "gpu/device_impl.hpp"
#include "shaders/shared/bindings.glsl.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace ajar::gpu {
namespace {

// Enough for any one record a kernel reads before it learns that a table is empty, and within every device's
// limits.
constexpr std::uint64_t DUMMY_BYTES = 4096;
constexpr std::uint64_t MAX_VIEW_BYTES =
    (std::uint64_t(1) << 31) - 1; // drivers count bytes in signed 32 bits

std::uint64_t texel_bytes(std::uint32_t binding) { return binding == shared::BIND_TEXELS ? 4 : 16; }

vk::Format texel_format(std::uint32_t binding) {
    return binding == shared::BIND_TEXELS ? vk::Format::eR8G8B8A8Unorm : vk::Format::eR32G32B32A32Uint;
}

[[maybe_unused]] bool is_table(std::uint32_t binding) {
    return binding >= shared::BIND_TEXEL_FIRST && binding <= shared::BIND_TEXEL_LAST;
}

bool view_fits(const Device& device, std::uint32_t binding, std::uint64_t size_bytes) {
    const std::uint64_t texel = texel_bytes(binding);
    return size_bytes <= MAX_VIEW_BYTES / texel * texel &&
           (size_bytes + texel - 1) / texel <= device.limits().max_texel_elements;
}

} // namespace

Bindings::Impl::Impl(const Device& device_in)
    : device(device_in), dummy(device_in, DUMMY_BYTES, "unused binding") {
    using Type = vk::DescriptorType;
    const Device::Impl& owner = device.impl();
    const std::array sizes = {
        vk::DescriptorPoolSize(Type::eUniformBuffer, 1),
        vk::DescriptorPoolSize(Type::eStorageBuffer,
                               shared::BIND_STORAGE_LAST - shared::BIND_STORAGE_FIRST + 1),
        vk::DescriptorPoolSize(Type::eUniformTexelBuffer, shared::TEXEL_BINDING_COUNT)};
    try {
        pool = vk::raii::DescriptorPool(owner.device,
                                        {vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, sizes});
        set_handle = std::move(
            vk::raii::DescriptorSets(owner.device, vk::DescriptorSetAllocateInfo(*pool, *owner.set_layout))
                .front());
    } catch (const vk::SystemError& error) {
        throw_error("descriptor set", error);
    }
    for (std::uint32_t i = 0; i < shared::TEXEL_BINDING_COUNT; ++i) views.emplace_back(nullptr);
    set(shared::BIND_FRAME, Type::eUniformBuffer, dummy.impl(), DUMMY_BYTES);
    for (std::uint32_t i = shared::BIND_STORAGE_FIRST; i <= shared::BIND_STORAGE_LAST; ++i) {
        set(i, Type::eStorageBuffer, dummy.impl(), DUMMY_BYTES);
    }
    for (std::uint32_t i = shared::BIND_TEXEL_FIRST; i <= shared::BIND_TEXEL_LAST; ++i)
        set_table(i, dummy.impl());
}

void Bindings::Impl::set(std::uint32_t binding, vk::DescriptorType type, const Buffer::Impl& buffer,
                         std::uint64_t range) {
    const vk::DescriptorBufferInfo info(*buffer.buffer, 0, range);
    device.impl().device.updateDescriptorSets(vk::WriteDescriptorSet(*set_handle, binding, 0, type, {}, info),
                                              {});
}

void Bindings::Impl::set_table(std::uint32_t binding, const Buffer::Impl& buffer) {
    const std::uint64_t texel = texel_bytes(binding);
    const std::uint64_t range = std::max(texel, (buffer.size_bytes + texel - 1) / texel * texel);
    vk::raii::BufferView& view = views[binding - shared::BIND_TEXEL_FIRST];
    try {
        vk::raii::BufferView made(device.impl().device,
                                  {{}, *buffer.buffer, texel_format(binding), 0, range});
        const vk::BufferView handle = *made;
        const vk::WriteDescriptorSet write(*set_handle, binding, 0, vk::DescriptorType::eUniformTexelBuffer,
                                           {}, {}, handle);
        device.impl().device.updateDescriptorSets(write, {});
        view = std::move(made);
    } catch (const vk::SystemError& error) {
        throw_error("texel buffer " + buffer.label, error);
    }
}

Bindings::Bindings(const Device& device) : impl_(std::make_unique<Impl>(device)) {}
Bindings::~Bindings() = default;

void Bindings::uniform(const Buffer& buffer) {
    const std::uint64_t limit = impl_->device.impl().facts.max_uniform_bytes;
    impl_->set(shared::BIND_FRAME, vk::DescriptorType::eUniformBuffer, buffer.impl(),
               std::min(limit, buffer.impl().capacity_bytes));
}

void Bindings::storage(std::uint32_t binding, const Buffer& buffer) {
    assert(binding >= shared::BIND_STORAGE_FIRST && binding <= shared::BIND_STORAGE_LAST);
    assert(buffer.size_bytes() <= impl_->device.limits().max_storage_bytes);
    impl_->set(binding, vk::DescriptorType::eStorageBuffer, buffer.impl(),
               std::min(buffer.impl().capacity_bytes, impl_->device.limits().max_storage_bytes));
}

void Bindings::table(std::uint32_t binding, const Buffer& buffer) {
    assert(is_table(binding));
    const bool fits = table_fits(impl_->device, binding, buffer.size_bytes());
    impl_->set_table(binding, fits ? buffer.impl() : impl_->dummy.impl());
}

bool Bindings::table_fits(const Device& device, std::uint32_t binding, std::uint64_t size_bytes) {
    assert(is_table(binding));
    return !device.options().force_pointers && view_fits(device, binding, size_bytes);
}

} // namespace ajar::gpu
