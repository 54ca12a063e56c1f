// A compute kernel by name, specialised, with typed arguments (push constants).
#pragma once

#include "gpu/bindings.hpp"
#include "gpu/commands.hpp"

#include <utility>

namespace ajar::gpu {

// Pairs of SPEC_* id and value; SPEC_WORKGROUP_SIZE is always given.
using Specialization = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

// The untyped half of Kernel.
class KernelBase {
  public:
    // `name` is that of shaders/kernels/NAME.comp. Throws Error when there is none, or the driver refuses it.
    // Where the device has shuffles, a fixed subgroup size and workgroup_size equals it, the variant compiled with
    // AJAR_SUBGROUP is taken.
    KernelBase(const Device& device, std::string_view name, const Specialization& specialization,
               std::uint32_t args_bytes);
    ~KernelBase();
    KernelBase(KernelBase&&) noexcept;
    KernelBase& operator=(KernelBase&&) noexcept;

    const std::string& name() const;

    struct Impl;
    Impl& impl() const { return *impl_; }

  protected:
    void record(Commands& commands, const void* args, std::uint32_t group_count) const;

  private:
    std::unique_ptr<Impl> impl_;
};

template <class Args> class Kernel : public KernelBase {
    static_assert(sizeof(Args) <= 128, "push constants are at most 128 bytes");
    static_assert(sizeof(Args) % 4 == 0);

  public:
    Kernel(const Device& device, std::string_view name, const Specialization& specialization)
        : KernelBase(device, name, specialization, sizeof(Args)) {}

    // Records the dispatch under the kernel's name, then a barrier that makes its writes visible to whatever follows.
    void dispatch(Commands& commands, const Args& args, std::uint32_t group_count) const {
        record(commands, &args, group_count);
    }
};

// The SPIR-V that was embedded for a kernel ("extend", or "extend.subgroup"), empty when there is none.
std::span<const std::uint32_t> embedded_kernel(std::string_view name);
std::vector<std::string> embedded_kernel_names();

} // namespace ajar::gpu
