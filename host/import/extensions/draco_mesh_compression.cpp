#include "import/extensions/draco_mesh_compression.hpp"

#include <algorithm>
#include <draco/compression/decode.h>
#include <fmt/format.h>
#include <limits>

namespace ajar::gltf {

struct DracoPrimitive::Decoded {
    std::unique_ptr<draco::Mesh> mesh;
    std::vector<std::pair<std::string, const draco::PointAttribute*>> attributes;
};

namespace {

// What an integer of the attribute's type is divided by when normalised; 0 for floating-point types.
float normalisation(draco::DataType type) {
    switch (type) {
    case draco::DT_INT8: return std::numeric_limits<std::int8_t>::max();
    case draco::DT_UINT8: return std::numeric_limits<std::uint8_t>::max();
    case draco::DT_INT16: return std::numeric_limits<std::int16_t>::max();
    case draco::DT_UINT16: return std::numeric_limits<std::uint16_t>::max();
    default: return 0;
    }
}

} // namespace

DracoPrimitive::DracoPrimitive(const JsonObject& extension, Document& document, Buffers& buffers)
    : extension_(extension), decoded_(std::make_unique<Decoded>()) {
    const auto view = extension.index("bufferView", buffers.view_count(), "buffer view");
    if (!view) extension.fail("bufferView", "is missing");
    const std::span<const std::byte> bytes = buffers.view(*view).bytes;
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    draco::Decoder decoder;
    auto result = decoder.DecodeMeshFromBuffer(&buffer);
    if (!result.ok())
        extension.fail("", fmt::format("the Draco data is damaged: {}", result.status().error_msg_string()));
    decoded_->mesh = std::move(result).value();
    document.charge_triangles(decoded_->mesh->num_faces(), extension);
    const auto attributes = extension.object("attributes");
    if (!attributes) extension.fail("attributes", "is missing");
    for (const std::string& name : attributes->keys()) {
        const std::uint64_t id = attributes->integer(name);
        const draco::PointAttribute* attribute =
            id > std::numeric_limits<std::uint32_t>::max()
                ? nullptr
                : decoded_->mesh->GetAttributeByUniqueId(static_cast<std::uint32_t>(id));
        if (!attribute) attributes->fail(name, fmt::format("the Draco data has no attribute {}", id));
        decoded_->attributes.emplace_back(name, attribute);
    }
}

DracoPrimitive::~DracoPrimitive() = default;

std::uint64_t DracoPrimitive::vertex_count() const { return decoded_->mesh->num_points(); }

std::vector<std::uint32_t> DracoPrimitive::indices() const {
    std::vector<std::uint32_t> result;
    result.reserve(std::size_t{3} * decoded_->mesh->num_faces());
    for (draco::FaceIndex f(0); f < decoded_->mesh->num_faces(); ++f)
        for (const draco::PointIndex& point : decoded_->mesh->face(f)) result.push_back(point.value());
    return result;
}

bool DracoPrimitive::has(std::string_view attribute) const {
    return std::any_of(decoded_->attributes.begin(), decoded_->attributes.end(),
                       [&](const auto& entry) { return entry.first == attribute; });
}

void DracoPrimitive::read(std::string_view name, bool normalized, std::span<float> out) const {
    const auto entry = std::find_if(decoded_->attributes.begin(), decoded_->attributes.end(),
                                    [&](const auto& e) { return e.first == name; });
    const draco::PointAttribute& attribute = *entry->second;
    const std::size_t components = out.size() / std::max<std::size_t>(vertex_count(), 1);
    if (static_cast<std::size_t>(attribute.num_components()) != components)
        extension_.fail("attributes", fmt::format("{} has {} components, {} are needed", name,
                                                  static_cast<int>(attribute.num_components()), components));
    const float divisor = normalisation(attribute.data_type());
    for (draco::PointIndex p(0); p < decoded_->mesh->num_points(); ++p) {
        const draco::AttributeValueIndex value = attribute.mapped_index(p);
        float* to = out.data() + p.value() * components;
        std::int32_t integers[4] = {};
        if (value.value() >= attribute.size()) extension_.fail("", "the Draco data is damaged");
        if (divisor == 0) {
            attribute.ConvertValue<float>(value, static_cast<std::int8_t>(components), to);
            continue;
        }
        attribute.ConvertValue<std::int32_t>(value, static_cast<std::int8_t>(components), integers);
        for (std::size_t c = 0; c < components; ++c)
            to[c] = normalized ? std::max(static_cast<float>(integers[c]) / divisor, -1.0f)
                               : static_cast<float>(integers[c]);
    }
}

} // namespace ajar::gltf
