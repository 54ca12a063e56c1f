#include "import/accessors.hpp"

#include <algorithm>
#include <cstring>
#include <fmt/format.h>
#include <limits>
#include <type_traits>

namespace ajar::gltf {

namespace {

enum ComponentType : std::uint64_t { I8 = 5120, U8 = 5121, I16 = 5122, U16 = 5123, U32 = 5125, F32 = 5126 };

std::size_t component_size(const JsonObject& object) {
    switch (const std::uint64_t type = object.integer("componentType")) {
    case I8:
    case U8: return 1;
    case I16:
    case U16: return 2;
    case U32:
    case F32: return 4;
    default: object.fail("componentType", fmt::format("{} does not exist", type));
    }
}

// Where elements lie: `count` of them from `data` on, `stride` bytes apart, each inside the view.
struct Elements {
    const std::byte* data;
    std::size_t stride;
    std::uint64_t type;
    unsigned components;
    bool normalized;
};

Elements locate(const JsonObject& object, const BufferView& view, std::uint64_t offset, std::uint64_t count,
                unsigned components, bool may_be_strided) {
    const std::size_t size = component_size(object) * components;
    const std::size_t stride = may_be_strided && view.stride != 0 ? view.stride : size;
    if (stride < size)
        object.fail("",
                    fmt::format("elements of {} bytes do not fit the view's byteStride of {}", size, stride));
    const std::size_t available = view.bytes.size();
    if (count != 0 &&
        (offset > available || available - offset < size || (available - offset - size) / stride < count - 1))
        object.fail(
            "", fmt::format("{} elements of {} bytes from byte {} on do not fit a buffer view of {} bytes",
                            count, size, offset, available));
    return {view.bytes.data() + std::min<std::uint64_t>(offset, available), stride,
            object.integer("componentType"), components, false};
}

// glTF 2.0, section 3.6.2.2: c / max, and for signed types no less than -1.
template <class Component, class Scalar> Scalar convert(Component value, bool normalized) {
    if constexpr (std::is_same_v<Scalar, float>) {
        if constexpr (std::is_integral_v<Component>)
            if (normalized)
                return std::max(static_cast<float>(value) /
                                    static_cast<float>(std::numeric_limits<Component>::max()),
                                -1.0f);
        return static_cast<float>(value);
    } else {
        return static_cast<Scalar>(value);
    }
}

template <class Component, class Scalar>
void copy(const Elements& from, std::size_t count, Selection selection, Scalar* out) {
    for (std::size_t i = 0; i < count; ++i) {
        const std::byte* element = from.data + from.stride * (selection.empty() ? i : selection[i]);
        for (unsigned c = 0; c < from.components; ++c) {
            Component value; // the data may lie at any address
            std::memcpy(&value, element + c * sizeof value, sizeof value);
            *out++ = convert<Component, Scalar>(value, from.normalized);
        }
    }
}

template <class Scalar> void copy_any(const JsonObject& object, const Elements& from, std::size_t count,
                                      Selection selection, Scalar* out) {
    switch (from.type) {
    case U8: return copy<std::uint8_t>(from, count, selection, out);
    case U16: return copy<std::uint16_t>(from, count, selection, out);
    case U32: return copy<std::uint32_t>(from, count, selection, out);
    default: break;
    }
    if constexpr (std::is_same_v<Scalar, float>) {
        if (from.type == I8) return copy<std::int8_t>(from, count, selection, out);
        if (from.type == I16) return copy<std::int16_t>(from, count, selection, out);
        return copy<float>(from, count, selection, out);
    } else {
        object.fail("componentType", fmt::format("must be an unsigned integer here, is {}", from.type));
    }
}

template <class T> constexpr unsigned COMPONENTS = sizeof(T) / 4;

} // namespace

Accessors::Accessors(Document& document, Buffers& buffers)
    : document_(document), buffers_(buffers), accessors_(document.root().objects("accessors")) {}

std::uint64_t Accessors::elements(std::uint32_t accessor) const {
    const std::uint64_t count = accessors_[accessor].integer("count");
    if (count > std::numeric_limits<std::uint32_t>::max())
        accessors_[accessor].fail("count", fmt::format("{} is more than this program can hold", count));
    return count;
}

unsigned Accessors::components(std::uint32_t accessor) const {
    const std::string type = accessors_[accessor].text("type");
    if (type == "SCALAR") return 1;
    if (type == "VEC2") return 2;
    if (type == "VEC3") return 3;
    if (type == "VEC4" || type == "MAT2") return 4;
    if (type == "MAT3") return 9;
    if (type == "MAT4") return 16;
    accessors_[accessor].fail("type", fmt::format("'{}' does not exist", type));
}

bool Accessors::normalized(std::uint32_t accessor) const {
    return accessors_[accessor].flag("normalized", false);
}

template <class Scalar>
void Accessors::read_dense(std::uint32_t accessor, Selection selection, std::span<Scalar> out) {
    const JsonObject& object = accessors_[accessor];
    const auto view = object.index("bufferView", buffers_.view_count(), "buffer view");
    if (!view) return; // all zeros
    Elements from = locate(object, buffers_.view(*view), object.integer("byteOffset", 0), elements(accessor),
                           components(accessor), true);
    from.normalized = normalized(accessor);
    copy_any(object, from, out.size() / from.components, selection, out.data());
}

template <class Scalar>
void Accessors::apply_sparse(std::uint32_t accessor, const JsonObject& sparse, std::span<Scalar> out) {
    const std::uint64_t count = sparse.integer("count");
    if (count > elements(accessor))
        sparse.fail("count", fmt::format("is {}, more than the accessor's {}", count, elements(accessor)));
    const auto indices = sparse.object("indices");
    const auto values = sparse.object("values");
    if (!indices || !values) sparse.fail("", "needs both indices and values");
    const auto index_view = indices->index("bufferView", buffers_.view_count(), "buffer view");
    const auto value_view = values->index("bufferView", buffers_.view_count(), "buffer view");
    if (!index_view || !value_view) sparse.fail("", "its indices and values need buffer views");
    const Elements at =
        locate(*indices, buffers_.view(*index_view), indices->integer("byteOffset", 0), count, 1, false);
    // The values have the accessor's own type, so the complaint about them is the accessor's.
    Elements from = locate(accessors_[accessor], buffers_.view(*value_view), values->integer("byteOffset", 0),
                           count, components(accessor), false);
    from.normalized = normalized(accessor);
    std::vector<std::uint32_t> positions(count);
    copy_any(*indices, at, count, {}, positions.data());
    std::vector<Scalar> replacements(count * from.components);
    copy_any(accessors_[accessor], from, count, {}, replacements.data());
    for (std::size_t i = 0; i < count; ++i) {
        if (positions[i] >= out.size() / from.components)
            indices->fail("", fmt::format("index {} is out of range (the accessor has {} elements)",
                                          positions[i], elements(accessor)));
        std::copy_n(replacements.begin() + static_cast<std::ptrdiff_t>(i * from.components), from.components,
                    out.begin() + static_cast<std::ptrdiff_t>(std::size_t{positions[i]} * from.components));
    }
}

template <class Scalar, class T>
std::vector<T> Accessors::read_as(std::uint32_t accessor, Selection selection) {
    const JsonObject& object = accessors_[accessor];
    if (components(accessor) != COMPONENTS<T>)
        object.fail("type",
                    fmt::format("has {} components, {} are needed", components(accessor), COMPONENTS<T>));
    const auto sparse = object.object("sparse");
    const std::uint64_t total = elements(accessor);
    if (!object.has("bufferView"))
        document_.charge(total * sizeof(T), object); // nothing else bounds its count
    // A selection of a sparse accessor is taken afterwards: substitution addresses the whole array.
    const std::size_t size = sparse || selection.empty() ? total : selection.size();
    if (object.has("bufferView")) { // checks the range before allocating
        std::span<Scalar> nothing;
        read_dense<Scalar>(accessor, {}, nothing);
    }
    std::vector<T> result(size);
    const std::span<Scalar> scalars(reinterpret_cast<Scalar*>(result.data()), size * COMPONENTS<T>);
    read_dense<Scalar>(accessor, sparse ? Selection{} : selection, scalars);
    if (!sparse) return result;
    apply_sparse<Scalar>(accessor, *sparse, scalars);
    if (selection.empty()) return result;
    std::vector<T> selected;
    selected.reserve(selection.size());
    for (const std::uint32_t i : selection) selected.push_back(result[i]);
    return selected;
}

template <class T> std::vector<T> Accessors::read(std::uint32_t accessor, Selection selection) {
    return read_as<float, T>(accessor, selection);
}

template <class T> std::vector<T> Accessors::read_integers(std::uint32_t accessor, Selection selection) {
    return read_as<std::uint32_t, T>(accessor, selection);
}

template std::vector<float> Accessors::read(std::uint32_t, Selection);
template std::vector<glm::vec2> Accessors::read(std::uint32_t, Selection);
template std::vector<glm::vec3> Accessors::read(std::uint32_t, Selection);
template std::vector<glm::vec4> Accessors::read(std::uint32_t, Selection);
template std::vector<glm::mat4> Accessors::read(std::uint32_t, Selection);
template std::vector<std::uint32_t> Accessors::read_integers(std::uint32_t, Selection);
template std::vector<glm::uvec4> Accessors::read_integers(std::uint32_t, Selection);

} // namespace ajar::gltf
