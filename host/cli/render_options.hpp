// The options of `ajar render`, declared once: name, group, check, help and where the value goes.
#pragma once

#include "ajar/device.hpp"
#include "ajar/save_image.hpp"
#include "ajar/scene_file.hpp"
#include "radiosity/settings.hpp"
#include "render/settings.hpp"

#include <CLI/CLI.hpp>
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace ajar::cli {

// How solvers converged, as a picture.
struct ConvergencePlot {
    std::string file;                 // empty: none
    std::vector<std::string> solvers; // besides the one that is shown
};

struct RenderOptions {
    std::string scene;
    std::vector<std::string> outputs;
    std::string report;
    RenderSettings settings;
    RadiositySettings radiosity; // integrator radiosity; its `render` is `settings`
    ConvergencePlot plot;
    LoadOptions load;
    std::string environment;
    EnvironmentOptions environment_options;
    std::optional<std::array<float, 3>> background;
    DeviceOptions device;
    bool no_cache = false;
    SaveOptions save;
    std::string progress = "auto";
};

// All of them. `options` must outlive `app`.
void declare(CLI::App& app, RenderOptions& options);

// Their groups, for commands that take some of them.
void declare_files(CLI::App& app, RenderOptions& options);
void declare_output(CLI::App& app, RenderOptions& options);  // the files, and what is in them
void declare_progress(CLI::App& app, RenderOptions& options); // in declare_display
void declare_display(CLI::App& app, RenderOptions& options); // tone mapping, progress
void declare_image(CLI::App& app, RenderOptions& options);   // size, samples, bounces, filter
void declare_method(CLI::App& app, RenderOptions& options);  // rows of tables
void declare_scene(CLI::App& app, RenderOptions& options);   // the camera, and
void declare_light(CLI::App& app, RenderOptions& options);   // which scene, environment, back faces
void declare_device(CLI::App& app, RenderOptions& options);

} // namespace ajar::cli
