#include "import/buffers.hpp"

#include "import/extensions/meshopt_compression.hpp"

#include <fmt/format.h>

namespace ajar::gltf {

Buffers::Buffers(Document& document)
    : document_(document), buffers_(document.root().objects("buffers")),
      views_(document.root().objects("bufferViews")) {}

std::span<const std::byte> Buffers::buffer(std::uint32_t index) {
    const JsonObject& object = buffers_[index];
    const std::uint64_t length = object.integer("byteLength");
    std::span<const std::byte> bytes;
    if (!object.has("uri")) {
        if (index != 0 || document_.bin().empty())
            object.fail("", "has no uri, and the file has no binary chunk for it");
        bytes = document_.bin();
    } else {
        const auto [entry, is_new] = loaded_buffers_.try_emplace(index);
        if (is_new) entry->second = document_.resource(object);
        bytes = entry->second;
    }
    if (length > bytes.size())
        object.fail("byteLength", fmt::format("is {}, but only {} bytes are there", length, bytes.size()));
    return bytes.first(length);
}

std::span<const std::byte> Buffers::range(const JsonObject& object) {
    const auto index = object.index("buffer", buffers_.size(), "buffer");
    if (!index) object.fail("buffer", "is missing");
    const std::span<const std::byte> bytes = buffer(*index);
    const std::uint64_t offset = object.integer("byteOffset", 0);
    const std::uint64_t length = object.integer("byteLength");
    if (offset > bytes.size() || length > bytes.size() - offset)
        object.fail("", fmt::format("bytes {} to {} lie outside buffer {}, which has {}", offset,
                                    offset + length, *index, bytes.size()));
    return bytes.subspan(offset, length);
}

const BufferView& Buffers::view(std::uint32_t index) {
    const auto found = loaded_views_.find(index);
    if (found != loaded_views_.end()) return found->second;
    return loaded_views_.emplace(index, load(views_[index])).first->second;
}

BufferView Buffers::load(const JsonObject& object) {
    if (const auto compression = meshopt_extension(object)) {
        const MeshoptHeader header = read_meshopt_header(*compression);
        document_.charge(header.count * header.stride, object);
        decompressed_.push_back(decode_meshopt(*compression, header, range(*compression)));
        return {decompressed_.back(), header.stride};
    }
    const std::uint64_t stride = object.integer("byteStride", 0);
    if (stride > 252 || stride % 4 != 0)
        object.fail("byteStride", fmt::format("must be a multiple of 4 from 4 to 252, is {}", stride));
    return {range(object), static_cast<std::size_t>(stride)};
}

} // namespace ajar::gltf
