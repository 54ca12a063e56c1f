// glTF 2.0 files (.gltf, .glb) and environment maps become a Scene (Khronos, "glTF 2.0 Specification",
// 2.0.1).
#pragma once

#include "base/events.hpp"
#include "scene/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace ajar {

// What a file may cost, so that a hostile one ends in an Error and not in gigabytes. The first four are
// ceilings; below them, what is decoded may also be at most `decoded_slack_bytes` plus `decoded_ratio` times
// the bytes read.
struct ImportLimits {
    std::uint64_t max_file_bytes = std::uint64_t{16} << 30;    // of each file
    std::uint64_t max_decoded_bytes = std::uint64_t{64} << 30; // geometry and images together
    std::uint64_t max_triangles = 500'000'000;
    std::uint64_t max_nodes = 2'000'000;
    std::uint64_t decoded_slack_bytes = std::uint64_t{512} << 20;
    std::uint64_t decoded_ratio = 256;
};

struct ImportOptions {
    WarningSink warn;  // may be empty; AssetInfo::warnings keeps every line as well
    std::string scene; // a name or an index; empty: the file's default
    float aspect = 1;  // width / height that an automatic camera must frame
    ImportLimits limits;
};

enum class ExtensionSupport : std::uint8_t { supported, approximated, ignored };

struct ExtensionUse {
    std::string name;
    bool required = false;
    ExtensionSupport support = ExtensionSupport::ignored;
};

// What the file holds, in the file's own counts; what the chosen scene uses is in Scene.
struct AssetInfo {
    std::string file;
    std::string version;
    std::string generator;
    std::string copyright;
    std::vector<ExtensionUse> extensions;
    std::vector<std::string> scene_names; // "" where a scene has none
    std::uint32_t scene = 0;              // the chosen one
    std::size_t nodes = 0, meshes = 0, primitives = 0, materials = 0, textures = 0, images = 0;
    std::size_t cameras = 0, lights = 0, animations = 0, skins = 0;
    std::size_t skipped_primitives = 0; // points and lines of the chosen scene
    bool automatic_camera = false;      // the chosen scene has none: Scene's was made by framing_camera()
    std::uint64_t bytes_read = 0;       // the file and what it refers to
    std::vector<std::string> warnings;
};

struct ImportResult {
    Scene scene;
    AssetInfo info;
};

// Throws Error: one line that names the file and the place.
ImportResult import_gltf(const std::filesystem::path& path, const ImportOptions& options = {});

// The same from memory. `base_folder` is where relative URIs are looked for; empty: a file that has any is
// refused.
ImportResult import_gltf_memory(std::span<const std::byte> bytes, const std::filesystem::path& base_folder,
                                const ImportOptions& options = {});

// An equirectangular Radiance HDR or OpenEXR file, named after the file.
Environment import_environment(const std::filesystem::path& path);

} // namespace ajar
