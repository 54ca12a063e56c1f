#include "export/document.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cstring>
#include <fmt/format.h>
#include <limits>

namespace ajar::gltf_out {

namespace {

enum ComponentType { U16 = 5123, U32 = 5125, F32 = 5126 };

void put32(std::vector<std::byte>& out, std::uint64_t value) {
    for (int shift = 0; shift < 32; shift += 8) out.push_back(static_cast<std::byte>(value >> shift & 0xff));
}

void pad(std::vector<std::byte>& bytes, std::byte by) {
    while (bytes.size() % 4 != 0) bytes.push_back(by);
}

void put_chunk(std::vector<std::byte>& out, std::span<const std::byte> bytes, std::string_view type) {
    put32(out, bytes.size());
    for (const char c : type) out.push_back(static_cast<std::byte>(c));
    out.insert(out.end(), bytes.begin(), bytes.end());
}

} // namespace

Document::Document(const ExportOptions& options) : options_(options) {
    json_["asset"]["version"] = "2.0";
    if (!options.generator.empty()) json_["asset"]["generator"] = options.generator;
}

std::uint32_t Document::push(const char* array, Json value) {
    Json& values = json_[array];
    values.push_back(std::move(value));
    return static_cast<std::uint32_t>(values.size() - 1);
}

std::uint32_t Document::add_root(Json node) {
    const std::uint32_t index = push("nodes", std::move(node));
    json_["scenes"][0]["nodes"].push_back(index);
    return index;
}

std::uint32_t Document::view(std::span<const std::byte> bytes, Target target) {
    pad(bin_, std::byte{0});
    Json view{{"buffer", 0}, {"byteOffset", bin_.size()}, {"byteLength", bytes.size()}};
    if (target != Target::none) view["target"] = static_cast<int>(target);
    bin_.insert(bin_.end(), bytes.begin(), bytes.end());
    return push("bufferViews", std::move(view));
}

std::uint32_t Document::floats(std::span<const float> values, unsigned components, bool bounds) {
    static constexpr const char* TYPES[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
    Json accessor{{"bufferView", view(std::as_bytes(values), Target::vertices)},
                  {"componentType", static_cast<int>(F32)},
                  {"count", values.size() / components},
                  {"type", TYPES[components]}};
    for (unsigned c = 0; c < components && bounds; ++c) {
        float least = values[c], most = values[c];
        for (std::size_t i = c; i < values.size(); i += components)
            least = std::min(least, values[i]), most = std::max(most, values[i]);
        accessor["min"].push_back(least);
        accessor["max"].push_back(most);
    }
    return push("accessors", std::move(accessor));
}

std::uint32_t Document::indices(std::span<const std::uint32_t> values, std::uint32_t vertex_count) {
    // The largest number of a type restarts a strip and is no index.
    const bool is_short = vertex_count <= std::numeric_limits<std::uint16_t>::max();
    std::vector<std::uint16_t> shorts;
    if (is_short) shorts.assign(values.begin(), values.end());
    const auto bytes = is_short ? std::as_bytes(std::span(shorts)) : std::as_bytes(values);
    return push("accessors", {{"bufferView", view(bytes, Target::indices)},
                              {"componentType", static_cast<int>(is_short ? U16 : U32)},
                              {"count", values.size()},
                              {"type", "SCALAR"}});
}

void Document::uses(std::string_view extension) {
    Json& used = json_["extensionsUsed"];
    if (std::find(used.begin(), used.end(), extension) == used.end()) used.push_back(extension);
}

void Document::warn(std::string_view line) const {
    if (options_.warn) options_.warn(line);
}

std::vector<std::byte> Document::glb() {
    if (json_.contains("extensionsUsed"))
        std::sort(json_["extensionsUsed"].begin(), json_["extensionsUsed"].end());
    pad(bin_, std::byte{0});
    if (!bin_.empty()) json_["buffers"] = Json::array({{{"byteLength", bin_.size()}}});
    // Names come from files and may hold what is no UTF-8.
    const std::string text = json_.dump(-1, ' ', false, Json::error_handler_t::replace);
    std::vector<std::byte> json(text.size());
    std::memcpy(json.data(), text.data(), text.size());
    pad(json, std::byte{' '});
    const std::uint64_t total = 12 + 8 + json.size() + (bin_.empty() ? 0 : 8 + bin_.size());
    if (total > std::numeric_limits<std::uint32_t>::max())
        throw Error(fmt::format("a .glb file holds at most 4 GiB, this would have {} bytes", total));
    std::vector<std::byte> out;
    out.reserve(total);
    put32(out, 0x46546c67); // "glTF"
    put32(out, 2);
    put32(out, total);
    put_chunk(out, json, "JSON");
    if (!bin_.empty()) put_chunk(out, bin_, std::string_view("BIN\0", 4));
    return out;
}

void set_name(Json& object, const std::string& name) {
    if (!name.empty()) object["name"] = name;
}

} // namespace ajar::gltf_out
