// Device memory. One allocation per buffer: a render has a few dozen, most of them large.
#include "gpu/buffer.hpp"

#include "base/error.hpp"
#include "gpu/device_impl.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <optional>

namespace ajar::gpu {
namespace {

constexpr std::uint64_t MAX_STAGING_BYTES = std::uint64_t(64) << 20;
constexpr std::uint64_t GRANULE = 16; // of capacities: the largest texel, so that views need no remainder

struct MemoryChoice {
    std::uint32_t type = 0;
    vk::MemoryPropertyFlags flags;
};

std::optional<MemoryChoice> find_type(const vk::PhysicalDeviceMemoryProperties& memory, std::uint32_t allowed,
                                      vk::MemoryPropertyFlags wanted, std::uint64_t smallest_heap) {
    for (std::uint32_t i = 0; i < memory.memoryTypeCount; ++i) {
        const auto& type = memory.memoryTypes[i];
        if ((allowed >> i & 1u) == 0 || (type.propertyFlags & wanted) != wanted) continue;
        if (memory.memoryHeaps[type.heapIndex].size < smallest_heap) continue;
        return MemoryChoice{i, type.propertyFlags};
    }
    return std::nullopt;
}

MemoryChoice choose_type(const Device::Impl& device, std::uint32_t allowed, bool staging) {
    using Flag = vk::MemoryPropertyFlagBits;
    const auto memory = device.physical.getMemoryProperties();
    const vk::MemoryPropertyFlags visible = Flag::eHostVisible | Flag::eHostCoherent;
    if (staging) {
        if (const auto cached = find_type(memory, allowed, visible | Flag::eHostCached, 0)) return *cached;
        if (const auto plain = find_type(memory, allowed, visible, 0)) return *plain;
        throw Error(device.facts.description.name + ": no memory that host and device both see");
    }
    // Memory of the device that the host sees: all of it (CPU, integrated, resizable BAR) or a small window,
    // which is better left to the driver.
    const std::uint64_t nearly_all = device.facts.limits.memory_bytes / 10 * 9;
    for (const auto extra : {vk::MemoryPropertyFlags(Flag::eHostCached), vk::MemoryPropertyFlags()}) {
        if (const auto both = find_type(memory, allowed, Flag::eDeviceLocal | visible | extra, nearly_all))
            return *both;
    }
    if (const auto local = find_type(memory, allowed, Flag::eDeviceLocal, 0)) return *local;
    if (const auto any = find_type(memory, allowed, {}, 0)) return *any;
    throw Error(device.facts.description.name + ": no memory type for buffers");
}

void copy(const Device::Impl& device, Submitter& submitter, const Buffer::Impl& from, const Buffer::Impl& to,
          const vk::BufferCopy& region) {
    submitter.begin();
    submitter.commands.copyBuffer(*from.buffer, *to.buffer, region);
    // Whatever was copied is visible to later work and to the host.
    using Stage = vk::PipelineStageFlagBits;
    using Access = vk::AccessFlagBits;
    const vk::MemoryBarrier barrier(Access::eTransferWrite, Access::eShaderRead | Access::eShaderWrite |
                                                                Access::eUniformRead | Access::eTransferRead |
                                                                Access::eTransferWrite | Access::eHostRead);
    submitter.commands.pipelineBarrier(
        Stage::eTransfer, Stage::eComputeShader | Stage::eTransfer | Stage::eHost, {}, barrier, {}, {});
    submitter.run("copying " + from.label + " to " + to.label + " on " + device.facts.description.name);
}

// Calls step(staging, offset, bytes) for each piece of a transfer.
template <class Step> void in_pieces(const Device& device, std::uint64_t size, Step step) {
    const Device::Impl& impl = device.impl();
    const std::lock_guard lock(impl.staging_mutex);
    if (!impl.staging) impl.staging = std::make_unique<Staging>(device);
    Buffer::Impl& piece = impl.staging->piece(size);
    for (std::uint64_t done = 0; done < size;) {
        const std::uint64_t now = std::min(size - done, piece.capacity_bytes);
        step(piece, done, now);
        done += now;
    }
}

} // namespace

Buffer::Impl& Staging::piece(std::uint64_t size_bytes) {
    const std::uint64_t wanted = std::min(size_bytes, MAX_STAGING_BYTES);
    if (!memory || memory->capacity_bytes < wanted) {
        memory.reset();
        memory =
            std::make_unique<Buffer::Impl>(device, std::max<std::uint64_t>(wanted, 1 << 16), "staging", true);
    }
    return *memory;
}

Buffer::Impl::Impl(const Device& device_in, std::uint64_t size, std::string_view label_in, bool staging)
    : device(device_in), label(label_in), size_bytes(size) {
    const Device::Impl& owner = device.impl();
    const DeviceLimits& limits = device.limits();
    const auto too_large = [&](const char* what, std::uint64_t has) {
        return Error(
            fmt::format("buffer {}: {} wanted, but {} {} {} (a smaller image, scene or path pool needs less)",
                        label, format_bytes(size), device.description().name, what, format_bytes(has)));
    };
    if (size > limits.max_allocation_bytes) throw too_large("allows at most", limits.max_allocation_bytes);
    if (size > limits.memory_bytes) throw too_large("has", limits.memory_bytes);
    capacity_bytes = std::max(GRANULE, (size + GRANULE - 1) / GRANULE * GRANULE);
    try {
        allocate(staging);
    } catch (const vk::OutOfDeviceMemoryError&) {
        throw Error(fmt::format("buffer {}: out of device memory: {} wanted, {} in use here, {} has {} "
                                "(other programs may use it; a "
                                "smaller image, scene or path pool needs less)",
                                label, format_bytes(size), format_bytes(owner.allocated_bytes),
                                device.description().name, format_bytes(limits.memory_bytes)));
    } catch (const vk::SystemError& error) {
        throw_error("buffer " + label + " of " + format_bytes(size), error);
    }
    owner.allocated_bytes += capacity_bytes;
}

Buffer::Impl::~Impl() { device.impl().allocated_bytes -= capacity_bytes; }

void Buffer::Impl::allocate(bool staging) {
    const Device::Impl& owner = device.impl();
    using Usage = vk::BufferUsageFlagBits;
    vk::BufferUsageFlags usage = Usage::eTransferSrc | Usage::eTransferDst;
    if (!staging) {
        usage |= Usage::eStorageBuffer | Usage::eUniformBuffer | Usage::eUniformTexelBuffer |
                 Usage::eShaderDeviceAddress;
    }
    buffer = vk::raii::Buffer(owner.device, vk::BufferCreateInfo({}, capacity_bytes, usage));
    owner.set_name(buffer, label);
    const auto needs = buffer.getMemoryRequirements();
    const MemoryChoice choice = choose_type(owner, needs.memoryTypeBits, staging);
    const vk::MemoryAllocateFlagsInfo flags(vk::MemoryAllocateFlagBits::eDeviceAddress);
    vk::MemoryAllocateInfo info(needs.size, choice.type);
    if (!staging) info.pNext = &flags;
    memory = vk::raii::DeviceMemory(owner.device, info);
    buffer.bindMemory(*memory, 0);
    const vk::MemoryPropertyFlags visible =
        vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent;
    if ((choice.flags & visible) == visible && (staging || !device.options().force_staging)) {
        mapped = static_cast<std::byte*>(memory.mapMemory(0, VK_WHOLE_SIZE));
        fast_reads = bool(choice.flags & vk::MemoryPropertyFlagBits::eHostCached);
    }
    if (!staging) address = owner.device.getBufferAddress(vk::BufferDeviceAddressInfo(*buffer));
}

Buffer::Buffer(const Device& device, std::uint64_t size_bytes, std::string_view label)
    : impl_(std::make_unique<Impl>(device, size_bytes, label, false)) {
    clear();
}

Buffer::Buffer() = default;
Buffer::Buffer(Buffer&&) noexcept = default;
Buffer& Buffer::operator=(Buffer&&) noexcept = default;
Buffer::~Buffer() = default;

std::uint64_t Buffer::size_bytes() const { return impl_ ? impl_->size_bytes : 0; }
std::uint64_t Buffer::address() const { return impl_ ? impl_->address : 0; }

void Buffer::write(std::span<const std::byte> bytes, std::uint64_t offset) {
    if (bytes.empty()) return;
    assert(offset <= size_bytes() && bytes.size() <= size_bytes() - offset);
    if (impl_->mapped != nullptr) {
        std::memcpy(impl_->mapped + offset, bytes.data(), bytes.size());
        return;
    }
    in_pieces(impl_->device, bytes.size(), [&](Impl& piece, std::uint64_t done, std::uint64_t now) {
        std::memcpy(piece.mapped, bytes.data() + done, now);
        copy(impl_->device.impl(), impl_->device.impl().staging->submitter, piece, *impl_,
             {0, offset + done, now});
    });
}

void Buffer::read(std::span<std::byte> bytes, std::uint64_t offset) const {
    if (bytes.empty()) return;
    assert(offset <= size_bytes() && bytes.size() <= size_bytes() - offset);
    if (impl_->mapped != nullptr && impl_->fast_reads) {
        std::memcpy(bytes.data(), impl_->mapped + offset, bytes.size());
        return;
    }
    in_pieces(impl_->device, bytes.size(), [&](Impl& piece, std::uint64_t done, std::uint64_t now) {
        copy(impl_->device.impl(), impl_->device.impl().staging->submitter, *impl_, piece,
             {offset + done, 0, now});
        std::memcpy(bytes.data() + done, piece.mapped, now);
    });
}

void Buffer::clear() {
    if (!impl_) return;
    if (impl_->mapped != nullptr) {
        std::memset(impl_->mapped, 0, impl_->capacity_bytes);
        return;
    }
    in_pieces(impl_->device, 1, [&](Impl&, std::uint64_t, std::uint64_t) {
        Submitter& submitter = impl_->device.impl().staging->submitter;
        submitter.begin();
        submitter.commands.fillBuffer(*impl_->buffer, 0, VK_WHOLE_SIZE, 0);
        submitter.run("clearing " + impl_->label);
    });
}

} // namespace ajar::gpu
