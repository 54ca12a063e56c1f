// Small glTF files, made in memory by the tests that read them.
#pragma once

#include "import/import.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace ajar::test {

enum Component { I8 = 5120, U8 = 5121, I16 = 5122, U16 = 5123, U32 = 5125, F32 = 5126 };

class GltfBuilder {
  public:
    nlohmann::json json = {{"asset", {{"version", "2.0"}}}};
    std::vector<std::byte> bin;

    // Appends to the array json[array] and returns the new element's index.
    unsigned push(const char* array, nlohmann::json value);

    // A buffer view of these values, which begin at a multiple of four bytes. `stride` 0: none is written.
    template <class T> unsigned view(const std::vector<T>& values, unsigned stride = 0) {
        return view_of_bytes(std::as_bytes(std::span(values)), stride);
    }
    unsigned view_of_bytes(std::span<const std::byte> bytes, unsigned stride = 0);

    unsigned accessor(unsigned view, Component component, std::size_t count, const char* type,
                      bool normalized = false, std::size_t offset = 0);

    // View and accessor in one.
    unsigned add(const std::vector<float>& values);
    unsigned add(const std::vector<glm::vec2>& values);
    unsigned add(const std::vector<glm::vec3>& values);
    unsigned add(const std::vector<glm::vec4>& values);
    unsigned add(const std::vector<glm::mat4>& values);
    unsigned add(const std::vector<std::uint16_t>& values);
    unsigned add(const std::vector<std::uint32_t>& values);

    // A mesh of one primitive, a node that shows it, and the scene with that node. Returns the mesh.
    unsigned show(const nlohmann::json& primitive);

    std::vector<std::byte> glb() const;
    std::string text() const; // the buffer as a data URI
};

// A triangle (0,0,0) (1,0,0) (0,1,0) in the scene, without indices.
GltfBuilder triangle();

// The same with normals, texture coordinates equal to (x, y), and material 0, `material`.
GltfBuilder textured_triangle(const nlohmann::json& material);

ImportResult import(const GltfBuilder& builder, const ImportOptions& options = {});
ImportResult import_text(std::string_view text, const std::filesystem::path& folder = {});

// The message of the Error that importing throws; "" when it throws none.
std::string import_error(const GltfBuilder& builder, const ImportOptions& options = {});
std::string import_error(std::span<const std::byte> bytes);

std::string base64(std::span<const std::byte> bytes);

// A PNG of one texel.
std::vector<std::byte> one_texel(std::uint8_t r, std::uint8_t g, std::uint8_t b, std::uint8_t a = 255);

} // namespace ajar::test
