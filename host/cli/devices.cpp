// ajar devices: what there is to render on, and why one cannot be used.
#include "ajar/device.hpp"
#include "cli/command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>
#include <nlohmann/json.hpp>

namespace ajar::cli {

namespace {

using Json = nlohmann::ordered_json;

std::string as_json(const std::vector<DeviceDescription>& devices) {
    Json json = Json::array();
    for (const DeviceDescription& d : devices)
        json.push_back({{"index", d.index},
                        {"name", d.name},
                        {"kind", d.kind},
                        {"driver", d.driver},
                        {"vulkan", d.api_version},
                        {"usable", d.usable()},
                        {"missing", d.missing}});
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string as_text(const std::vector<DeviceDescription>& devices) {
    std::string text;
    for (const DeviceDescription& d : devices) {
        text += fmt::format("{}  {} ({}, Vulkan {}, {})\n", d.index, d.name, d.kind, d.api_version, d.driver);
        if (!d.usable()) text += fmt::format("   cannot be used: lacks {}\n", fmt::join(d.missing, ", "));
    }
    return text;
}

} // namespace

Command devices_command(CLI::App& parent) {
    CLI::App* app = parent.add_subcommand("devices", "Lists the Vulkan devices");
    app->footer("  ajar devices\n"
                "  ajar render scene.glb -o out.png --device 1");
    const auto json = std::make_shared<bool>(false);
    app->add_flag("--json", *json, "For machines");
    return {app, [json] {
                const std::vector<DeviceDescription> devices = list_devices();
                print_result(*json ? as_json(devices) : as_text(devices));
                return EXIT_OK;
            }};
}

} // namespace ajar::cli
