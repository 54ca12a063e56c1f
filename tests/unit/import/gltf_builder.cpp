#include "unit/import/gltf_builder.hpp"

#include "base/error.hpp"
#include "unit/image/png_maker.hpp"

namespace ajar::test {

namespace {

void append_u32(std::vector<std::byte>& to, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) to.push_back(static_cast<std::byte>(value >> shift & 0xff));
}

template <class T>
unsigned add_values(GltfBuilder& b, const std::vector<T>& v, Component component, const char* type) {
    return b.accessor(b.view(v), component, v.size(), type);
}

} // namespace

unsigned GltfBuilder::push(const char* array, nlohmann::json value) {
    json[array].push_back(std::move(value));
    return static_cast<unsigned>(json[array].size() - 1);
}

unsigned GltfBuilder::view_of_bytes(std::span<const std::byte> bytes, unsigned stride) {
    bin.resize((bin.size() + 3) / 4 * 4);
    nlohmann::json view{{"buffer", 0}, {"byteOffset", bin.size()}, {"byteLength", bytes.size()}};
    if (stride != 0) view["byteStride"] = stride;
    bin.insert(bin.end(), bytes.begin(), bytes.end());
    return push("bufferViews", view);
}

unsigned GltfBuilder::accessor(unsigned view, Component component, std::size_t count, const char* type,
                               bool normalized, std::size_t offset) {
    nlohmann::json value{
        {"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}};
    if (normalized) value["normalized"] = true;
    if (offset != 0) value["byteOffset"] = offset;
    return push("accessors", value);
}

unsigned GltfBuilder::add(const std::vector<float>& v) { return add_values(*this, v, F32, "SCALAR"); }
unsigned GltfBuilder::add(const std::vector<glm::vec2>& v) { return add_values(*this, v, F32, "VEC2"); }
unsigned GltfBuilder::add(const std::vector<glm::vec3>& v) { return add_values(*this, v, F32, "VEC3"); }
unsigned GltfBuilder::add(const std::vector<glm::vec4>& v) { return add_values(*this, v, F32, "VEC4"); }
unsigned GltfBuilder::add(const std::vector<glm::mat4>& v) { return add_values(*this, v, F32, "MAT4"); }
unsigned GltfBuilder::add(const std::vector<std::uint16_t>& v) { return add_values(*this, v, U16, "SCALAR"); }
unsigned GltfBuilder::add(const std::vector<std::uint32_t>& v) { return add_values(*this, v, U32, "SCALAR"); }

unsigned GltfBuilder::show(const nlohmann::json& primitive) {
    const unsigned mesh = push("meshes", {{"name", "shape"}, {"primitives", {primitive}}});
    const unsigned node = push("nodes", {{"mesh", mesh}});
    if (!json.contains("scenes")) json["scenes"] = {{{"nodes", nlohmann::json::array()}}};
    json["scenes"][0]["nodes"].push_back(node);
    return mesh;
}

std::vector<std::byte> GltfBuilder::glb() const {
    nlohmann::json whole = json;
    if (!bin.empty() && !whole.contains("buffers")) whole["buffers"] = {{{"byteLength", bin.size()}}};
    std::string text = whole.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::vector<std::byte> padded = bin;
    padded.resize((padded.size() + 3) / 4 * 4);
    std::vector<std::byte> bytes;
    append_u32(bytes, 0x46546c67);
    append_u32(bytes, 2);
    append_u32(bytes,
               static_cast<std::uint32_t>(12 + 8 + text.size() + (bin.empty() ? 0 : 8 + padded.size())));
    append_u32(bytes, static_cast<std::uint32_t>(text.size()));
    append_u32(bytes, 0x4e4f534a);
    const auto characters = std::as_bytes(std::span(text));
    bytes.insert(bytes.end(), characters.begin(), characters.end());
    if (bin.empty()) return bytes;
    append_u32(bytes, static_cast<std::uint32_t>(padded.size()));
    append_u32(bytes, 0x004e4942);
    bytes.insert(bytes.end(), padded.begin(), padded.end());
    return bytes;
}

std::string GltfBuilder::text() const {
    nlohmann::json whole = json;
    if (!bin.empty() && !whole.contains("buffers"))
        whole["buffers"] = {
            {{"byteLength", bin.size()}, {"uri", "data:application/octet-stream;base64," + base64(bin)}}};
    return whole.dump();
}

GltfBuilder triangle() {
    GltfBuilder b;
    const unsigned position = b.add(std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    b.show({{"attributes", {{"POSITION", position}}}});
    return b;
}

GltfBuilder textured_triangle(const nlohmann::json& material) {
    GltfBuilder b;
    const unsigned position = b.add(std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    const unsigned normal = b.add(std::vector<glm::vec3>(3, {0, 0, 1}));
    const unsigned uv = b.add(std::vector<glm::vec2>{{0, 0}, {1, 0}, {0, 1}});
    b.show(
        {{"attributes", {{"POSITION", position}, {"NORMAL", normal}, {"TEXCOORD_0", uv}}}, {"material", 0}});
    b.push("materials", material);
    return b;
}

ImportResult import(const GltfBuilder& builder, const ImportOptions& options) {
    return import_gltf_memory(builder.glb(), {}, options);
}

ImportResult import_text(std::string_view text, const std::filesystem::path& folder) {
    return import_gltf_memory(std::as_bytes(std::span(text)), folder);
}

std::string import_error(const GltfBuilder& builder, const ImportOptions& options) {
    try {
        import(builder, options);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

std::string import_error(std::span<const std::byte> bytes) {
    try {
        import_gltf_memory(bytes, {});
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

std::string base64(std::span<const std::byte> bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (i + k < bytes.size() ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

std::vector<std::byte> one_texel(std::uint8_t r, std::uint8_t g, std::uint8_t b, std::uint8_t a) {
    return make_png({.width = 1, .height = 1, .samples = {r, g, b, a}});
}

} // namespace ajar::test
