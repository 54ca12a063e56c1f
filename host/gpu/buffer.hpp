// Device memory. Every buffer may be a storage, texel and uniform buffer, and has an address.
#pragma once

#include "gpu/device.hpp"

#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

namespace ajar::gpu {

class Buffer {
  public:
    Buffer(); // empty: size 0, address 0
    // Zero-filled. Throws Error (out of device memory: how much was asked for what, and how much there is).
    Buffer(const Device& device, std::uint64_t size_bytes, std::string_view label);
    Buffer(Buffer&&) noexcept;
    Buffer& operator=(Buffer&&) noexcept;
    ~Buffer();

    std::uint64_t size_bytes() const;
    std::uint64_t address() const; // 64-bit device address for DUAL_PTR fields
    explicit operator bool() const { return impl_ != nullptr; }

    // Blocking transfers through host-visible memory (directly where the device's memory is visible).
    void write(std::span<const std::byte> bytes, std::uint64_t offset = 0);
    void read(std::span<std::byte> bytes, std::uint64_t offset = 0) const;
    void clear(); // zeroes

    template <class T> void write(std::span<const T> values, std::uint64_t first = 0) {
        static_assert(std::is_trivially_copyable_v<T>);
        write(std::as_bytes(values), first * sizeof(T));
    }
    template <class T> std::vector<T> read(std::uint64_t first, std::uint64_t count) const {
        static_assert(std::is_trivially_copyable_v<T>);
        std::vector<T> values(count);
        read(std::as_writable_bytes(std::span(values)), first * sizeof(T));
        return values;
    }

    struct Impl;
    Impl& impl() const { return *impl_; }

  private:
    std::unique_ptr<Impl> impl_;
};

} // namespace ajar::gpu
