// What an image was made of, as a JSON document for --report and, the part that reproduces it, as the image's
// metadata.
#pragma once

#include "ajar/session.hpp"
#include "gpu/device.hpp"
#include "render/render.hpp"

#include <string>
#include <utility>
#include <vector>

namespace ajar {

struct Manifest {
    const std::string& scene_name;
    const std::string& scene_hash;
    const Scene& scene;
    const gpu::Device& device;
    const RenderStats& stats;                   // with the settings as used
    const RadiosityResult* radiosity = nullptr; // what the image shows, if it does
};

// Settings that decide the image, hashes of scene and shaders, version, device and driver. No clock, no path
// and nothing that only decides the speed: equal images have equal metadata.
std::vector<std::pair<std::string, std::string>> reproduction_metadata(const Manifest& manifest);

// All of it, times and rays included; indented, with a newline at the end.
std::string manifest_json(const Manifest& manifest);

} // namespace ajar
