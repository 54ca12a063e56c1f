#include "import/json.hpp"

#include "base/error.hpp"

#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>

namespace ajar::gltf {

using nlohmann::json;

namespace {

constexpr int MAX_DEPTH = 256;
constexpr std::size_t MAX_VALUES = 6'000'000; // about half a gigabyte as nlohmann keeps them

std::string_view type_name(const json& value) {
    switch (value.type()) {
    case json::value_t::null: return "null";
    case json::value_t::object: return "an object";
    case json::value_t::array: return "an array";
    case json::value_t::string: return "a string";
    case json::value_t::boolean: return "a boolean";
    default: return "a number";
    }
}

// The parser's own message without its prefix "[json.exception.parse_error.101] ".
std::string_view reason(const json::exception& error) {
    const std::string_view what = error.what();
    const std::size_t end = what.find("] ");
    return end == std::string_view::npos ? what : what.substr(end + 2);
}

// Before parsing, because a byte of brackets becomes a hundred bytes of values. (nlohmann's own hook, a
// parser callback, takes quadratic time: ten seconds for a hundred thousand nodes.)
void check_extent(std::string_view text, const std::string& file) {
    std::size_t values = 0;
    int depth = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (in_string && c == '\\') ++i;
        if (c == '"') in_string = !in_string;
        if (in_string) continue;
        if (c == '[' || c == '{') ++depth;
        if (c == ']' || c == '}') --depth;
        if (c == '[' || c == '{' || c == ',') ++values;
        if (depth > MAX_DEPTH)
            throw Error(fmt::format("{}: the JSON is nested more than {} deep", file, MAX_DEPTH));
        if (values > MAX_VALUES)
            throw Error(fmt::format("{}: the JSON has more than {} values", file, MAX_VALUES));
    }
}

} // namespace

json parse_json(std::span<const std::byte> bytes, const std::string& file) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    check_extent(text, file);
    try {
        return json::parse(text);
    } catch (const json::exception& error) {
        std::string message(reason(error));
        for (char& c : message)
            if (static_cast<unsigned char>(c) < ' ') c = ' ';
        throw Error(fmt::format("{}: is not valid JSON: {}", file, message));
    }
}

JsonObject::JsonObject(const json& value, std::string where)
    : value_(&value), where_(std::make_shared<std::string>(std::move(where))) {
    check_type();
}

JsonObject::JsonObject(const json& value, std::shared_ptr<const std::string> array, std::int64_t index)
    : value_(&value), where_(std::move(array)), index_(index) {
    check_type();
}

void JsonObject::check_type() const {
    if (!value_->is_object())
        throw Error(fmt::format("{}: must be an object, is {}", where(), type_name(*value_)));
}

std::string JsonObject::where() const {
    return index_ < 0 ? *where_ : fmt::format("{}[{}]", *where_, index_);
}

std::string JsonObject::path(std::string_view key) const {
    const std::string begin = where();
    return fmt::format("{}{}{}", begin, begin.ends_with(": ") ? "" : ".", key);
}

void JsonObject::fail(std::string_view key, std::string_view message) const {
    const std::string begin = where();
    if (key.empty()) throw Error(fmt::format("{}{}{}", begin, begin.ends_with(": ") ? "" : ": ", message));
    throw Error(fmt::format("{}: {}", path(key), message));
}

const json* JsonObject::find(std::string_view key) const {
    const auto it = value_->find(key);
    return it == value_->end() ? nullptr : &*it;
}

const json* JsonObject::find_array(std::string_view key) const {
    const json* value = find(key);
    if (value && !value->is_array()) fail(key, fmt::format("must be an array, is {}", type_name(*value)));
    return value;
}

bool JsonObject::has(std::string_view key) const { return find(key) != nullptr; }

std::vector<std::string> JsonObject::keys() const {
    std::vector<std::string> names;
    for (const auto& [key, unused] : value_->items()) names.push_back(key);
    return names;
}

std::string JsonObject::text(std::string_view key, std::string_view fallback) const {
    const json* value = find(key);
    if (!value) return std::string(fallback);
    if (!value->is_string()) fail(key, fmt::format("must be a string, is {}", type_name(*value)));
    return value->get_ref<const std::string&>();
}

bool JsonObject::flag(std::string_view key, bool fallback) const {
    const json* value = find(key);
    if (!value) return fallback;
    if (!value->is_boolean()) fail(key, fmt::format("must be true or false, is {}", type_name(*value)));
    return value->get<bool>();
}

float JsonObject::to_float(const json& value, std::string_view key) const {
    if (!value.is_number()) fail(key, fmt::format("must be a number, is {}", type_name(value)));
    const double number = value.get<double>();
    if (!(std::abs(number) <= std::numeric_limits<float>::max()))
        fail(key, fmt::format("{} is too large for a 32-bit float", number));
    return static_cast<float>(number);
}

float JsonObject::number(std::string_view key, float fallback) const {
    const json* value = find(key);
    return value ? to_float(*value, key) : fallback;
}

std::vector<float> JsonObject::numbers(std::string_view key) const {
    std::vector<float> result;
    if (const json* array = find_array(key))
        for (const json& value : *array) result.push_back(to_float(value, key));
    return result;
}

template <int N>
glm::vec<N, float> JsonObject::vector(std::string_view key, const glm::vec<N, float>& fallback) const {
    if (!has(key)) return fallback;
    const std::vector<float> values = numbers(key);
    if (values.size() != std::size_t{N})
        fail(key, fmt::format("must have {} numbers, has {}", N, values.size()));
    glm::vec<N, float> result;
    for (int i = 0; i < N; ++i) result[i] = values[static_cast<std::size_t>(i)];
    return result;
}
template glm::vec2 JsonObject::vector<2>(std::string_view, const glm::vec2&) const;
template glm::vec3 JsonObject::vector<3>(std::string_view, const glm::vec3&) const;
template glm::vec4 JsonObject::vector<4>(std::string_view, const glm::vec4&) const;

// Some exporters write 24.0; a whole number is a whole number.
std::uint64_t JsonObject::to_integer(const json& value, std::string_view key) const {
    if (value.is_number_unsigned()) return value.get<std::uint64_t>();
    if (!value.is_number()) fail(key, fmt::format("must be a whole number, is {}", type_name(value)));
    const double number = value.get<double>();
    if (!(number >= 0 && number <= 9007199254740992.0 &&
          number == std::floor(number))) // 2^53: exact in a double
        fail(key, fmt::format("must be a whole number of at least 0, is {}", number));
    return static_cast<std::uint64_t>(number);
}

std::uint64_t JsonObject::integer(std::string_view key, std::uint64_t fallback) const {
    const json* value = find(key);
    return value ? to_integer(*value, key) : fallback;
}

std::uint64_t JsonObject::integer(std::string_view key) const {
    const json* value = find(key);
    if (!value) fail(key, "is missing");
    return to_integer(*value, key);
}

std::uint32_t JsonObject::to_index(const json& value, std::string_view key, std::size_t count,
                                   std::string_view what) const {
    const std::uint64_t index = to_integer(value, key);
    if (index >= count) fail(key, fmt::format("{} {} does not exist (the file has {})", what, index, count));
    return static_cast<std::uint32_t>(index);
}

std::optional<std::uint32_t> JsonObject::index(std::string_view key, std::size_t count,
                                               std::string_view what) const {
    const json* value = find(key);
    if (!value) return std::nullopt;
    return to_index(*value, key, count, what);
}

std::vector<std::uint32_t> JsonObject::indices(std::string_view key, std::size_t count,
                                               std::string_view what) const {
    std::vector<std::uint32_t> result;
    if (const json* array = find_array(key))
        for (const json& value : *array) result.push_back(to_index(value, key, count, what));
    return result;
}

std::optional<JsonObject> JsonObject::object(std::string_view key) const {
    const json* value = find(key);
    if (!value) return std::nullopt;
    return JsonObject(*value, path(key));
}

std::optional<JsonObject> JsonObject::extension(std::string_view name) const {
    const auto extensions = object("extensions");
    return extensions ? extensions->object(name) : std::nullopt;
}

std::optional<JsonObject> JsonObject::extras() const {
    const json* value = find("extras");
    if (!value || !value->is_object()) return std::nullopt;
    return JsonObject(*value, path("extras"));
}

std::optional<double> JsonObject::if_number(std::string_view key) const {
    const json* value = find(key);
    return value && value->is_number() ? std::optional(value->get<double>()) : std::nullopt;
}

std::optional<bool> JsonObject::if_flag(std::string_view key) const {
    const json* value = find(key);
    return value && value->is_boolean() ? std::optional(value->get<bool>()) : std::nullopt;
}

std::vector<JsonObject> JsonObject::objects(std::string_view key) const {
    std::vector<JsonObject> result;
    const json* array = find_array(key);
    if (!array) return result;
    result.reserve(array->size());
    const auto shared_path = std::make_shared<const std::string>(path(key));
    for (const json& value : *array)
        result.push_back(JsonObject(value, shared_path, static_cast<std::int64_t>(result.size())));
    return result;
}

std::vector<std::string> JsonObject::texts(std::string_view key) const {
    std::vector<std::string> result;
    const json* array = find_array(key);
    if (!array) return result;
    for (const json& value : *array) {
        if (!value.is_string()) fail(key, fmt::format("must hold strings, holds {}", type_name(value)));
        result.push_back(value.get<std::string>());
    }
    return result;
}

} // namespace ajar::gltf
