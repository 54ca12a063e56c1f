// A glTF scene in memory, ready to be rendered on any device.
#pragma once

#include "base/events.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace ajar {

struct Scene; // the rooms' own description, see scene/scene.hpp; programs outside do not need it

struct LoadOptions {
    std::string scene;           // a name or an index; empty: the file's default
    float aspect = 16.0f / 9.0f; // width / height that the automatic camera of a file without any must frame
    WarningSink warn;            // one line for each thing that was ignored or replaced; may be empty
};

struct EnvironmentOptions {
    float strength = 1;         // multiplies the map's radiance
    float rotation_degrees = 0; // about +Y
};

class SceneFile {
  public:
    // Reads a .gltf or .glb file and whatever it refers to. Throws Error: one line naming the file and the
    // place.
    static SceneFile load(const std::filesystem::path& path, const LoadOptions& options = {});
    ~SceneFile();
    SceneFile(SceneFile&&) noexcept;
    SceneFile& operator=(SceneFile&&) noexcept;

    // Lights the scene by an equirectangular .hdr or .exr map (u = atan2(z, x) / 2 pi + 1/2, +Y at the top).
    void set_environment(const std::filesystem::path& map, const EnvironmentOptions& options = {});
    // The same radiance (linear Rec. 709) from everywhere.
    void set_environment(float red, float green, float blue);
    // A soft neutral studio, for scenes that bring no light of their own.
    void set_default_environment();

    // False where every pixel would be black: no light, no environment, nothing that emits or is unlit.
    bool has_light() const;
    // False where the file had none, and its camera was made to frame the scene.
    bool has_camera() const;
    std::uint64_t triangle_count() const; // each instance counted

    const std::string& name() const; // the file's, without its folder
    // Thirty-two hexadecimal digits that stand for all that was loaded, the environment included: the same
    // scene gives the same digits, wherever its files lie.
    std::string hash() const;

    const Scene& scene() const;

  private:
    struct Impl;
    explicit SceneFile(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

} // namespace ajar
