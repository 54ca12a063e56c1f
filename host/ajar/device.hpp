// Which Vulkan devices there are, and the one to render on. See gpu/device.hpp for the members.
#pragma once

#include "gpu/device.hpp"

namespace ajar {

using gpu::default_cache_folder;
using gpu::Device;
using gpu::DeviceDescription;
using gpu::DeviceOptions;
using gpu::list_devices;

} // namespace ajar
