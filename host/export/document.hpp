// A glTF document in the making: JSON and one binary chunk.
#pragma once

#include "export/export.hpp"

#include <nlohmann/json.hpp>
#include <span>
#include <string_view>

namespace ajar::gltf_out {

using Json = nlohmann::ordered_json;

enum class Target : std::uint16_t { none = 0, vertices = 34962, indices = 34963 };

class Document {
  public:
    explicit Document(const ExportOptions& options);

    // Appends to the array json[array] and returns the new element's index. Arrays are made when they get
    // something: glTF allows no empty ones.
    std::uint32_t push(const char* array, Json value);
    Json& at(const char* array, std::uint32_t index) { return json_[array][index]; }
    // A node at the root of the scene.
    std::uint32_t add_root(Json node);

    std::uint32_t view(std::span<const std::byte> bytes, Target target);
    // Vertices' vectors of floats, tightly packed in a view of their own. With `bounds` the accessor states
    // the least and largest values.
    std::uint32_t floats(std::span<const float> values, unsigned components, bool bounds = false);
    // 16 bits where they suffice.
    std::uint32_t indices(std::span<const std::uint32_t> values, std::uint32_t vertex_count);

    void uses(std::string_view extension);
    void warn(std::string_view line) const;
    Json& root() { return json_; }

    std::vector<std::byte> glb();

  private:
    const ExportOptions& options_;
    Json json_;
    std::vector<std::byte> bin_;
};

// Left out where empty.
void set_name(Json& object, const std::string& name);

template <class Vec> Json numbers(const Vec& v) {
    Json array = Json::array();
    for (int i = 0; i < Vec::length(); ++i) array.push_back(v[i]);
    return array;
}

} // namespace ajar::gltf_out
