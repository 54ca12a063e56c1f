// Vulkan behind the public headers of this room: for its own .cpp files only.
#pragma once

#include "gpu/kernel.hpp"

#include <vulkan/vulkan_raii.hpp>

#include <atomic>
#include <map>
#include <mutex>

namespace ajar::gpu {

// What `describe` found out about a physical device.
struct Facts {
    DeviceDescription description;
    DeviceLimits limits;
    std::uint32_t queue_family = 0;
    bool can_require_subgroup_size = false; // VK_EXT_subgroup_size_control with full subgroups in compute
    bool has_subgroup_size_control = false; // the extension is there to be enabled
    std::uint32_t max_group_count[2] = {65535, 65535};
    std::uint32_t max_uniform_bytes = 16384;
    std::uint32_t timestamp_bits = 0;
    double timestamp_seconds = 0; // per tick
};
Facts describe(const vk::raii::PhysicalDevice& physical, std::uint32_t index);

// Throws Error in the words of `what` ("kernel extend") for whatever went wrong with Vulkan.
[[noreturn]] void throw_error(const std::string& what, const vk::SystemError& error);
std::string format_bytes(std::uint64_t bytes);

// The loader, an instance, and the validation layer's messenger.
struct Instance {
    Instance(bool validation, const std::function<void(std::string_view)>* on_validation);
    std::vector<vk::raii::PhysicalDevice> physical_devices() const; // Error when there is none

    vk::raii::Context context;
    bool debug_utils = false;
    vk::raii::Instance instance = nullptr;
    vk::raii::DebugUtilsMessengerEXT messenger = nullptr;
};

// Submits one command buffer at a time and waits for it.
struct Submitter {
    explicit Submitter(const Device::Impl& device);
    void begin();
    void run(const std::string& what); // ends the commands, runs them, waits
    void drop();                       // forgets the commands

    const Device::Impl& device;
    vk::raii::CommandPool pool = nullptr;
    vk::raii::CommandBuffer commands = nullptr;
    vk::raii::Fence fence = nullptr;
    bool recording = false;
};

// Host-visible memory through which transfers go where a buffer's own is not visible.
struct Staging {
    explicit Staging(const Device& owner) : device(owner), submitter(owner.impl()) {}
    Buffer::Impl& piece(std::uint64_t size_bytes); // at least that large, up to the bound

    const Device& device;
    Submitter submitter;
    std::unique_ptr<Buffer::Impl> memory;
};

struct Device::Impl {
    explicit Impl(const DeviceOptions& options);
    // Names an object for debuggers and validation messages.
    template <class Handle> void set_name(const Handle& handle, const std::string& name) const;

    DeviceOptions options; // first: the messenger points at its callback
    Instance instance;
    vk::raii::PhysicalDevice physical = nullptr;
    Facts facts;
    vk::raii::Device device = nullptr;
    vk::raii::Queue queue = nullptr;
    vk::raii::PipelineCache cache = nullptr;
    std::string cache_hash; // of what was loaded from disk
    vk::raii::DescriptorSetLayout set_layout = nullptr;
    vk::raii::PipelineLayout pipeline_layout = nullptr;
    mutable std::mutex queue_mutex;   // a VkQueue is one thread's at a time
    mutable std::mutex staging_mutex; // so is the staging memory
    mutable std::unique_ptr<Staging> staging;
    mutable std::atomic<std::uint64_t> allocated_bytes = 0;
    mutable std::mutex kernels_mutex;
    mutable std::map<std::string, std::shared_ptr<KernelBase::Impl>> kernels; // by all that decides them

  private:
    void create_device();
    void create_layouts();
};

struct Buffer::Impl {
    // `staging`: host-visible, whatever it costs.
    Impl(const Device& device, std::uint64_t size_bytes, std::string_view label, bool staging);
    ~Impl();
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    const Device& device;
    std::string label;
    std::uint64_t size_bytes;     // as asked for
    std::uint64_t capacity_bytes; // a multiple of 16, at least 16
    vk::raii::Buffer buffer = nullptr;
    vk::raii::DeviceMemory memory = nullptr;
    std::byte* mapped = nullptr; // where the host can write
    bool fast_reads = false;     // mapped memory is cached, so the host may read it too
    std::uint64_t address = 0;

  private:
    void allocate(bool staging);
};

struct Bindings::Impl {
    explicit Impl(const Device& device);
    void set(std::uint32_t binding, vk::DescriptorType type, const Buffer::Impl& buffer, std::uint64_t range);
    void set_table(std::uint32_t binding, const Buffer::Impl& buffer);

    const Device& device;
    Buffer dummy;
    vk::raii::DescriptorPool pool = nullptr;
    vk::raii::DescriptorSet set_handle = nullptr;
    std::vector<vk::raii::BufferView> views; // by table
};

struct KernelBase::Impl {
    // `full_subgroups`: the SPIR-V relies on a workgroup being one subgroup.
    Impl(const Device& device, std::span<const std::uint32_t> spirv, std::string_view label,
         Specialization specialization, std::uint32_t args_bytes, bool full_subgroups);

    std::string name;
    std::uint32_t args_bytes;
    vk::raii::Pipeline pipeline = nullptr;
};

struct Commands::Impl {
    explicit Impl(const Device& device);
    void dispatch(const KernelBase::Impl& kernel, const void* args, std::uint32_t group_count);
    void stamp();
    double collect(); // timestamps into profile; device seconds

    const Device& device;
    Submitter submitter;
    vk::DescriptorSet set;
    bool set_bound = false;
    std::vector<vk::raii::QueryPool> queries; // STAMPS_PER_POOL timestamps each
    std::uint32_t stamp_count = 0;
    std::vector<std::string> labels; // of the dispatches recorded
    Profile profile;
};

template <class Handle> void Device::Impl::set_name(const Handle& handle, const std::string& name) const {
    if (!instance.debug_utils) return;
    using Plain = std::remove_cvref_t<decltype(*handle)>;
    // A handle is a pointer or a 64-bit number; the C cast is the one that takes both.
    const auto number = (std::uint64_t)(static_cast<typename Plain::CType>(*handle));
    device.setDebugUtilsObjectNameEXT({Plain::objectType, number, name.c_str()});
}

} // namespace ajar::gpu
