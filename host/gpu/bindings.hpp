// The descriptor set that all kernels share: which buffer stands at which number of bindings.glsl.h.
#pragma once

#include "gpu/buffer.hpp"

namespace ajar::gpu {

class Bindings {
  public:
    // All start out at a small zero-filled buffer, so kernels that ignore a binding need not have it set.
    explicit Bindings(const Device& device);
    ~Bindings();
    Bindings(const Bindings&) = delete;
    Bindings& operator=(const Bindings&) = delete;

    // BIND_FRAME.
    void uniform(const Buffer& buffer);
    // BIND_STORAGE_FIRST..LAST. The range must be within limits().max_storage_bytes (assert).
    void storage(std::uint32_t binding, const Buffer& buffer);
    // BIND_TEXEL_FIRST..LAST: RGBA32UI, BIND_TEXELS RGBA8 UNORM. A buffer that does not fit is not bound.
    void table(std::uint32_t binding, const Buffer& buffer);

    // Whether a table of so many bytes can be a texel buffer of this device (elements, bytes < 2^31), and may
    // be one (force_pointers).
    static bool table_fits(const Device& device, std::uint32_t binding, std::uint64_t size_bytes);

    struct Impl;
    Impl& impl() const { return *impl_; }

  private:
    std::unique_ptr<Impl> impl_;
};

} // namespace ajar::gpu
