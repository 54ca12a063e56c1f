// A Scene becomes a glTF 2.0 file that other programs read, and that import reads back as the same Scene
// (Khronos, "glTF 2.0 Specification", 2.0.1).
#pragma once

#include "base/events.hpp"
#include "scene/scene.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace ajar {

struct ExportOptions {
    std::string generator; // asset.generator; empty: none
    WarningSink warn;      // one line for each thing that glTF cannot say; may be empty
};

// A .glb with everything in it: geometry, materials, images (as PNG), placed lights and cameras. `scene` must
// be valid; it is validated. Throws Error for what no glTF can hold. The same scene gives the same bytes.
std::vector<std::byte> glb_bytes(const Scene& scene, const ExportOptions& options = {});

// The same as a file, replaced in one step. Throws Error unless the name ends in .glb.
void export_gltf(const std::filesystem::path& path, const Scene& scene, const ExportOptions& options = {});

// Throws the Error that export_gltf would for the name: before hours of work.
void check_export_name(const std::filesystem::path& path);

} // namespace ajar
