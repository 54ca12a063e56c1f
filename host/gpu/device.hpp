// A Vulkan device with one compute queue. Vulkan itself stays inside host/gpu: headers here know none of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace ajar::gpu {

// A device as `ajar devices` lists it. `missing` names each thing Ajar needs and the device lacks.
struct DeviceDescription {
    std::uint32_t index = 0;
    std::string name;   // as the driver spells it
    std::string driver; // name and version
    std::string kind;   // "discrete GPU", "integrated GPU", "virtual GPU", "CPU", "other"
    std::string api_version;
    std::vector<std::string> missing;
    bool usable() const { return missing.empty(); }
};

// Every Vulkan device of the machine. Throws Error when there is no Vulkan driver at all (names the package
// to install).
std::vector<DeviceDescription> list_devices();

struct DeviceOptions {
    // Index, or part of the name in any case; empty: discrete GPU, integrated, then CPU.
    std::string select = {};
    bool validation = false; // load the Khronos validation layer; Error when it is not installed
    std::function<void(std::string_view)> on_validation = {}; // each warning or error of the layer
    std::filesystem::path cache_folder = {}; // where compiled pipelines are kept; empty: nowhere
    bool force_pointers = false;      // read scene tables through pointers even where texel buffers would do
    bool force_staging = false;       // transfers as on a GPU whose memory the host can't see
    std::uint32_t workgroup_size = 0; // 0: chosen by device; Error when it allows fewer
    bool timestamps = true;           // time each kernel; on lavapipe the threads meet at every timestamp
};

// What the rest of the house may ask of a device.
struct DeviceLimits {
    bool is_cpu = false;
    std::uint32_t subgroup_size = 1;
    bool subgroup_size_fixed = false; // every kernel runs with exactly subgroup_size
    bool subgroup_shuffle = false;    // votes, ballots and shuffles in compute kernels
    std::uint32_t max_workgroup_size = 0;
    std::uint64_t max_storage_bytes = 0; // of one bound storage buffer
    std::uint64_t max_allocation_bytes = 0;
    std::uint64_t max_texel_elements = 0; // of one texel buffer
    std::uint64_t memory_bytes = 0;       // of the largest device-local heap
    bool timestamps = false;
};

// $XDG_CACHE_HOME/ajar, else $HOME/.cache/ajar, else empty. The caller reads the environment (null: not set).
std::filesystem::path default_cache_folder(const char* xdg_cache_home, const char* home);

class Device {
  public:
    // Throws Error: no such device, or what it lacks.
    explicit Device(const DeviceOptions& options = {});
    ~Device(); // waits for the device and stores the pipeline cache
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    const DeviceDescription& description() const;
    const DeviceLimits& limits() const;
    const DeviceOptions& options() const;
    // Threads of a workgroup for kernels over segments: the subgroup size on a CPU, 64 elsewhere, unless set.
    std::uint32_t workgroup_size() const;

    struct Impl; // Vulkan, defined in device_impl.hpp for the other files of this room
    Impl& impl() const { return *impl_; }

  private:
    std::unique_ptr<Impl> impl_;
};

} // namespace ajar::gpu
