#include "import/primitives.hpp"

#include "import/extensions/draco_mesh_compression.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>

namespace ajar::gltf {

namespace {

enum Mode : std::uint64_t { TRIANGLES = 4, TRIANGLE_STRIP = 5, TRIANGLE_FAN = 6 };

std::uint64_t read_mode(const JsonObject& primitive) {
    const std::uint64_t mode = primitive.integer("mode", TRIANGLES);
    if (mode > TRIANGLE_FAN) primitive.fail("mode", fmt::format("{} does not exist", mode));
    return mode;
}

// Where a primitive's attributes come from: accessors or a Draco stream, which wins where it has the
// attribute.
class Attributes {
  public:
    Attributes(const JsonObject& primitive, PrimitiveReader& reader)
        : primitive_(primitive), accessors_(reader.accessors), attributes_(primitive.object("attributes")) {
        if (!attributes_) primitive.fail("attributes", "is missing");
        if (const auto extension = primitive.extension("KHR_draco_mesh_compression"))
            draco_ = std::make_unique<DracoPrimitive>(*extension, reader.document, reader.buffers);
    }

    const DracoPrimitive* draco() const { return draco_.get(); }
    std::optional<std::uint32_t> accessor(std::string_view name) const {
        return attributes_->index(name, accessors_.count(), "accessor");
    }
    bool has(std::string_view name) const { return attributes_->has(name); }

    std::uint64_t vertex_count() const {
        const auto position = accessor("POSITION");
        if (!position) primitive_.fail("attributes", "has no POSITION");
        return draco_ ? draco_->vertex_count() : accessors_.elements(*position);
    }

    template <class T>
    std::vector<T> floats(std::string_view name, std::uint64_t count, Selection selection) {
        const auto index = accessor(name);
        if (!index) return {};
        if (draco_ && draco_->has(name)) {
            std::vector<T> values(count);
            draco_->read(name, accessors_.normalized(*index),
                         {reinterpret_cast<float*>(values.data()), count * sizeof(T) / sizeof(float)});
            return values;
        }
        check_count(*index, count, name);
        return accessors_.read<T>(*index, selection);
    }

    std::vector<glm::uvec4> joints(std::string_view name, std::uint64_t count, Selection selection) {
        if (!draco_ || !draco_->has(name)) {
            const auto index = accessor(name);
            check_count(*index, count, name);
            return accessors_.read_integers<glm::uvec4>(*index, selection);
        }
        std::vector<glm::uvec4> result;
        for (const glm::vec4& v : floats<glm::vec4>(name, count, {}))
            result.emplace_back(glm::clamp(v, 0.0f, 65535.0f));
        return result;
    }

    std::vector<glm::vec4> colors(std::uint64_t count, Selection selection) {
        const auto index = accessor("COLOR_0");
        if (!index) return {};
        if (accessors_.components(*index) == 4) return floats<glm::vec4>("COLOR_0", count, selection);
        std::vector<glm::vec4> result;
        for (const glm::vec3& c : floats<glm::vec3>("COLOR_0", count, selection)) result.emplace_back(c, 1);
        return result;
    }

    void check_count(std::uint32_t index, std::uint64_t count, std::string_view name) const {
        const std::uint64_t elements = accessors_.elements(index);
        if (elements != count)
            primitive_.fail("attributes",
                            fmt::format("{} has {} elements for {} positions", name, elements, count));
    }

  private:
    const JsonObject& primitive_;
    Accessors& accessors_;
    std::optional<JsonObject> attributes_;
    std::unique_ptr<DracoPrimitive> draco_;
};

std::vector<std::uint32_t> read_corners(const JsonObject& primitive, PrimitiveReader& reader,
                                        const Attributes& from, std::uint64_t vertex_count) {
    const auto index = primitive.index("indices", reader.accessors.count(), "accessor");
    std::vector<std::uint32_t> corners;
    if (from.draco()) {
        corners = from.draco()->indices();
    } else if (index) {
        reader.document.charge_triangles(reader.accessors.elements(*index) / 3, primitive);
        corners = reader.accessors.read_integers<std::uint32_t>(*index);
    } else {
        reader.document.charge_triangles(vertex_count / 3, primitive);
        reader.document.charge(vertex_count * sizeof(std::uint32_t), primitive);
        corners.resize(vertex_count);
        std::iota(corners.begin(), corners.end(), 0u);
    }
    for (const std::uint32_t corner : corners)
        if (corner >= vertex_count)
            primitive.fail("indices", fmt::format("vertex index {} is out of range (there are {} vertices)",
                                                  corner, vertex_count));
    return corners;
}

std::vector<glm::uvec3> assemble(std::span<const std::uint32_t> c, std::uint64_t mode) {
    std::vector<glm::uvec3> triangles;
    if (mode == TRIANGLES) {
        triangles.reserve(c.size() / 3);
        for (std::size_t i = 0; i + 2 < c.size(); i += 3) triangles.emplace_back(c[i], c[i + 1], c[i + 2]);
        return triangles;
    }
    // Strips repeat a vertex to jump; the triangles that this makes have no area.
    for (std::size_t i = 0; i + 2 < c.size(); ++i) {
        const std::size_t odd = i % 2;
        const glm::uvec3 t = mode == TRIANGLE_FAN ? glm::uvec3(c[i + 1], c[i + 2], c[0])
                                                  : glm::uvec3(c[i], c[i + 1 + odd], c[i + 2 - odd]);
        if (t.x != t.y && t.y != t.z && t.z != t.x) triangles.push_back(t);
    }
    return triangles;
}

// Some exporters let hundreds of primitives share one array of vertices. Keeps the used ones, in order, and
// renumbers the triangles; empty where most vertices are used anyway.
std::vector<std::uint32_t> select_used(std::vector<glm::uvec3>& triangles, std::uint64_t vertex_count) {
    if (vertex_count <= 3 * std::uint64_t{triangles.size()}) return {};
    std::vector<std::uint32_t> used;
    used.reserve(triangles.size() * 3);
    for (const glm::uvec3& t : triangles) used.insert(used.end(), {t.x, t.y, t.z});
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    for (glm::uvec3& t : triangles)
        for (int k = 0; k < 3; ++k)
            t[k] =
                static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), t[k]) - used.begin());
    return used;
}

} // namespace

bool has_no_triangles(const JsonObject& primitive) { return read_mode(primitive) < TRIANGLES; }

Primitive PrimitiveReader::read(const JsonObject& primitive, bool is_skinned) {
    Attributes from(primitive, *this);
    const std::uint64_t count = from.vertex_count();
    Primitive result;
    result.file_vertices = count;
    result.triangles = assemble(read_corners(primitive, *this, from, count), read_mode(primitive));
    if (result.triangles.empty()) return result;
    if (!from.draco()) result.selection = select_used(result.triangles, count);
    const Selection selection = result.selection;
    const std::uint64_t kept = selection.empty() ? count : selection.size();
    document.charge(kept * sizeof(glm::vec4) * 5 + result.triangles.size() * sizeof(glm::uvec4), primitive);
    result.positions = from.floats<glm::vec3>("POSITION", count, selection);
    for (const glm::vec3& p : result.positions)
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
            primitive.fail("attributes.POSITION", "a position is not finite");
    result.normals = from.floats<glm::vec3>("NORMAL", count, selection);
    if (!result.normals.empty()) result.tangents = from.floats<glm::vec4>("TANGENT", count, selection);
    result.uv[0] = from.floats<glm::vec2>("TEXCOORD_0", count, selection);
    result.uv[1] = from.floats<glm::vec2>("TEXCOORD_1", count, selection);
    result.colors = from.colors(count, selection);
    for (int set = 0; is_skinned; ++set) {
        const std::string joints = fmt::format("JOINTS_{}", set);
        const std::string weights = fmt::format("WEIGHTS_{}", set);
        if (!from.has(joints) || !from.has(weights)) break;
        document.charge(kept * sizeof(glm::vec4) * 2, primitive);
        result.influences.push_back(
            {from.joints(joints, count, selection), from.floats<glm::vec4>(weights, count, selection)});
    }
    return result;
}

} // namespace ajar::gltf
