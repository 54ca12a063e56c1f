// Buffers and buffer views: bytes that are known to be there. Each is read when first asked for.
#pragma once

#include "import/document.hpp"

#include <optional>
#include <unordered_map>

namespace ajar::gltf {

struct BufferView {
    std::span<const std::byte> bytes;
    std::size_t stride = 0; // 0: elements are packed
};

class Buffers {
  public:
    explicit Buffers(Document& document);
    Buffers(const Buffers&) = delete;
    Buffers& operator=(const Buffers&) = delete;

    std::size_t view_count() const { return views_.size(); }
    // Decompressed where a compression extension asks for it. The bytes live as long as this.
    const BufferView& view(std::uint32_t index);

    // The bytes [byteOffset, byteOffset + byteLength) of the buffer that an object with those three
    // properties names.
    std::span<const std::byte> range(const JsonObject& object);

  private:
    std::span<const std::byte> buffer(std::uint32_t index);
    BufferView load(const JsonObject& object);

    Document& document_;
    std::vector<JsonObject> buffers_;
    std::vector<JsonObject> views_;
    std::unordered_map<std::uint32_t, std::vector<std::byte>> loaded_buffers_;
    std::unordered_map<std::uint32_t, BufferView> loaded_views_;
    std::vector<std::vector<std::byte>> decompressed_;
};

} // namespace ajar::gltf
