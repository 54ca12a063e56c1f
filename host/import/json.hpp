// JSON read with suspicion: every access checks the type, and a complaint names the place ("scene.gltf:
// nodes[3].mesh").
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ajar::gltf {

// An object of a JSON document and its path, which begins with the file's name. The document must outlive
// it.
class JsonObject {
  public:
    // Throws Error when `value` is not an object.
    JsonObject(const nlohmann::json& value, std::string where);

    bool has(std::string_view key) const;
    std::vector<std::string> keys() const;

    // A missing key gives `fallback` (or nullopt); a wrong type, a number that is not finite or out of
    // range throws.
    std::string text(std::string_view key, std::string_view fallback = {}) const;
    bool flag(std::string_view key, bool fallback) const;
    float number(std::string_view key, float fallback) const;
    std::uint64_t integer(std::string_view key, std::uint64_t fallback) const;
    std::uint64_t integer(std::string_view key) const;      // required
    std::vector<float> numbers(std::string_view key) const; // empty when missing
    template <int N>
    glm::vec<N, float> vector(std::string_view key, const glm::vec<N, float>& fallback) const;

    // Indices into an array of `count` elements; `what` names one of them in the complaint ("accessor").
    std::optional<std::uint32_t> index(std::string_view key, std::size_t count, std::string_view what) const;
    std::vector<std::uint32_t> indices(std::string_view key, std::size_t count, std::string_view what) const;

    std::optional<JsonObject> object(std::string_view key) const;
    std::optional<JsonObject> extension(std::string_view name) const; // extensions.name
    std::vector<JsonObject> objects(std::string_view key) const;      // an array of objects
    std::vector<std::string> texts(std::string_view key) const;       // an array of strings

    // `extras`, which may be of any type: nullopt unless it is an object. In there, values of another type
    // count as missing.
    std::optional<JsonObject> extras() const;
    std::optional<double> if_number(std::string_view key) const;
    std::optional<bool> if_flag(std::string_view key) const;

    // "PATH.key: message"; an empty key complains about the object itself.
    std::string path(std::string_view key) const; // "PATH.key"
    [[noreturn]] void fail(std::string_view key, std::string_view message) const;

  private:
    const nlohmann::json* find(std::string_view key) const;
    const nlohmann::json* find_array(std::string_view key) const;
    float to_float(const nlohmann::json& value, std::string_view key) const;
    std::uint64_t to_integer(const nlohmann::json& value, std::string_view key) const;
    std::uint32_t to_index(const nlohmann::json& value, std::string_view key, std::size_t count,
                           std::string_view what) const;

    // An element of an array. The path is put together only to complain: millions of nodes share one.
    JsonObject(const nlohmann::json& value, std::shared_ptr<const std::string> array, std::int64_t index);
    void check_type() const;
    std::string where() const;

    const nlohmann::json* value_;
    std::shared_ptr<const std::string> where_; // of the array, where index_ is not negative
    std::int64_t index_ = -1;
};

// Parses text of bounded depth and bounded number of values, as a small file of brackets can fill the
// memory.
nlohmann::json parse_json(std::span<const std::byte> bytes, const std::string& file);

} // namespace ajar::gltf
