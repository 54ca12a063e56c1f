// A compute kernel by name, specialised, with typed arguments (push constants).
#pragma once

#include "gpu/bindings.hpp"
#include "gpu/commands.hpp"

#include <memory>
#include <utility>

namespace ajar::gpu {

// Pairs of SPEC_* id and value; SPEC_WORKGROUP_SIZE is always given.
using Specialization = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

// SPIR-V that is part of the program: "extend", and "extend.subgroup" compiled with AJAR_SUBGROUP.
struct EmbeddedKernel {
    std::string_view name;
    std::span<const std::uint32_t> spirv;
};
using KernelSet = std::span<const EmbeddedKernel>;

// Those of shaders/kernels/. A program may embed its own (cmake/Shaders.cmake).
KernelSet embedded_kernels();

// The untyped half of Kernel.
class KernelBase {
  public:
    // `name` is that of shaders/kernels/NAME.comp. Throws Error when there is none, or the driver refuses it.
    // Where the device has shuffles, a fixed subgroup size and workgroup_size equals it, the variant compiled
    // with AJAR_SUBGROUP is taken.
    KernelBase(const Device& device, std::string_view name, const Specialization& specialization,
               std::uint32_t args_bytes);
    // The same from another set than embedded_kernels().
    KernelBase(const Device& device, KernelSet set, std::string_view name,
               const Specialization& specialization, std::uint32_t args_bytes);
    // Any SPIR-V; `label` stands for the name.
    KernelBase(const Device& device, std::span<const std::uint32_t> spirv, std::string_view label,
               const Specialization& specialization, std::uint32_t args_bytes);
    ~KernelBase();
    KernelBase(KernelBase&&) noexcept;
    KernelBase& operator=(KernelBase&&) noexcept;

    const std::string& name() const;

    struct Impl;
    Impl& impl() const { return *impl_; }

  protected:
    void record(Commands& commands, const void* args, std::uint32_t group_count) const;

  private:
    std::shared_ptr<Impl> impl_; // the device keeps it for the next kernel that is equal
};

template <class Args> class Kernel : public KernelBase {
    static_assert(sizeof(Args) <= 128, "push constants are at most 128 bytes");
    static_assert(sizeof(Args) % 4 == 0);

  public:
    Kernel(const Device& device, std::string_view name, const Specialization& specialization)
        : KernelBase(device, name, specialization, sizeof(Args)) {}
    Kernel(const Device& device, KernelSet set, std::string_view name, const Specialization& specialization)
        : KernelBase(device, set, name, specialization, sizeof(Args)) {}
    Kernel(const Device& device, std::span<const std::uint32_t> spirv, std::string_view label,
           const Specialization& specialization)
        : KernelBase(device, spirv, label, specialization, sizeof(Args)) {}

    // Records the dispatch under the kernel's name, then a barrier that makes its writes visible to whatever
    // follows. A few workgroups more than group_count may run: see shaders/core/workgroup.glsl. The kernel,
    // the bindings and their buffers must live, unchanged, until the commands were submitted.
    void dispatch(Commands& commands, const Args& args, std::uint32_t group_count) const {
        record(commands, &args, group_count);
    }
};

// The SPIR-V that was embedded for a kernel ("extend", or "extend.subgroup"), empty when there is none.
std::span<const std::uint32_t> embedded_kernel(std::string_view name);
std::vector<std::string> embedded_kernel_names();
// content_hash of that SPIR-V, for manifests; empty when there is none.
std::string embedded_kernel_hash(std::string_view name);

} // namespace ajar::gpu
