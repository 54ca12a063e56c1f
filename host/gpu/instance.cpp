// The Vulkan instance: what can go wrong before there is any device, told so that a user can act on it.
#include "base/error.hpp"
#include "gpu/device_impl.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ajar::gpu {
namespace {

constexpr const char* VALIDATION_LAYER = "VK_LAYER_KHRONOS_validation";
constexpr const char* NO_DRIVER = "no Vulkan driver found (install mesa-vulkan-drivers, which brings a CPU "
                                  "device too, or your GPU vendor's driver)";

vk::raii::Context make_context() {
    try {
        return vk::raii::Context();
    } catch (const std::exception&) {
        throw Error("no Vulkan loader found (install libvulkan1 and mesa-vulkan-drivers)");
    }
}

bool offers(const std::vector<vk::ExtensionProperties>& extensions, const char* name) {
    return std::any_of(extensions.begin(), extensions.end(),
                       [&](const auto& e) { return std::string_view(e.extensionName.data()) == name; });
}

bool has_validation_layer(const vk::raii::Context& context) {
    const auto layers = context.enumerateInstanceLayerProperties();
    return std::any_of(layers.begin(), layers.end(), [](const auto& l) {
        return std::string_view(l.layerName.data()) == VALIDATION_LAYER;
    });
}

VKAPI_ATTR VkBool32 VKAPI_CALL on_message(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                          VkDebugUtilsMessageTypeFlagsEXT,
                                          const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
    const auto& sink = *static_cast<const std::function<void(std::string_view)>*>(user);
    if (sink) sink(data->pMessage != nullptr ? data->pMessage : "");
    return VK_FALSE;
}

VkDebugUtilsMessengerCreateInfoEXT messenger_info(const std::function<void(std::string_view)>* sink) {
    VkDebugUtilsMessengerCreateInfoEXT info = {};
    info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
    info.messageSeverity =
        VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
    info.pfnUserCallback = on_message;
    info.pUserData = const_cast<std::function<void(std::string_view)>*>(sink);
    return info;
}

} // namespace

Instance::Instance(bool validation, const std::function<void(std::string_view)>* on_validation)
    : context(make_context()) {
    if (context.enumerateInstanceVersion() < VK_API_VERSION_1_1) {
        throw Error("the Vulkan loader knows Vulkan 1.0 only, Ajar needs 1.2 (install a newer libvulkan1)");
    }
    std::vector<const char*> layers;
    auto extensions_offered = context.enumerateInstanceExtensionProperties();
    if (validation) {
        if (!has_validation_layer(context)) {
            throw Error("validation was asked for, but the Khronos layer is missing (install "
                        "vulkan-validationlayers)");
        }
        layers.push_back(VALIDATION_LAYER);
        const auto of_layer = context.enumerateInstanceExtensionProperties(std::string(VALIDATION_LAYER));
        extensions_offered.insert(extensions_offered.end(), of_layer.begin(), of_layer.end());
    }
    std::vector<const char*> extensions;
    debug_utils = offers(extensions_offered, VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    if (debug_utils) extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);

    const vk::ApplicationInfo application("ajar", 1, "ajar", 1, VK_API_VERSION_1_2);
    const auto messages = messenger_info(on_validation);
    vk::InstanceCreateInfo info({}, &application, layers, extensions);
    if (validation && debug_utils) info.pNext = &messages; // creation itself is checked too
    try {
        instance = vk::raii::Instance(context, info);
        if (validation && debug_utils) {
            messenger =
                vk::raii::DebugUtilsMessengerEXT(instance, vk::DebugUtilsMessengerCreateInfoEXT(messages));
        }
    } catch (const vk::IncompatibleDriverError&) {
        throw Error(NO_DRIVER);
    } catch (const vk::SystemError& error) {
        throw_error("Vulkan instance", error);
    }
}

std::vector<vk::raii::PhysicalDevice> Instance::physical_devices() const {
    std::vector<vk::raii::PhysicalDevice> devices;
    try {
        for (auto& device : instance.enumeratePhysicalDevices()) devices.push_back(std::move(device));
    } catch (const vk::SystemError&) {
        throw Error(NO_DRIVER); // some loaders say "initialization failed" where no driver works
    }
    if (devices.empty()) throw Error(NO_DRIVER);
    return devices;
}

std::vector<DeviceDescription> list_devices() {
    const Instance instance(false, nullptr);
    std::vector<DeviceDescription> descriptions;
    for (const auto& physical : instance.physical_devices()) {
        descriptions.push_back(
            describe(physical, static_cast<std::uint32_t>(descriptions.size())).description);
    }
    return descriptions;
}

std::string format_bytes(std::uint64_t bytes) {
    constexpr const char* units[] = {"bytes", "KiB", "MiB", "GiB", "TiB", "PiB", "EiB"};
    auto value = static_cast<double>(bytes);
    std::size_t unit = 0;
    while (value >= 1024 && unit + 1 < std::size(units)) {
        value /= 1024;
        ++unit;
    }
    return unit == 0 ? fmt::format("{} bytes", bytes) : fmt::format("{:.1f} {}", value, units[unit]);
}

void throw_error(const std::string& what, const vk::SystemError& error) {
    switch (static_cast<vk::Result>(error.code().value())) {
    case vk::Result::eErrorDeviceLost:
        throw Error(what + ": the device was lost: a driver's watchdog ended the work, or the driver crashed "
                           "(try smaller slices of work, fewer samples per pass, or another device)");
    case vk::Result::eErrorOutOfDeviceMemory:
        throw Error(what + ": out of device memory (a smaller image, scene or path pool needs less)");
    case vk::Result::eErrorOutOfHostMemory:
        throw Error(what +
                    ": the driver is out of host memory (close other programs, or render something smaller)");
    default: throw Error(what + ": the Vulkan driver refused: " + error.what());
    }
}

} // namespace ajar::gpu
