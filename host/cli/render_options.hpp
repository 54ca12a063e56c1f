// The options of `ajar render`, declared once: name, group, check, help and where the value goes.
#pragma once

#include "ajar/device.hpp"
#include "ajar/save_image.hpp"
#include "ajar/scene_file.hpp"
#include "render/settings.hpp"

#include <CLI/CLI.hpp>
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace ajar::cli {

struct RenderOptions {
    std::string scene;
    std::vector<std::string> outputs;
    std::string report;
    RenderSettings settings;
    LoadOptions load;
    std::string environment;
    EnvironmentOptions environment_options;
    std::optional<std::array<float, 3>> background;
    DeviceOptions device;
    bool no_cache = false;
    SaveOptions save;
    std::string progress = "auto";
};

// `options` must outlive `app`.
void declare(CLI::App& app, RenderOptions& options);

} // namespace ajar::cli
