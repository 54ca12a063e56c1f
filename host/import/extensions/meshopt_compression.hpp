// EXT_meshopt_compression and the streams of KHR_meshopt_compression that meshoptimizer 0.18 can read.
#pragma once

#include "import/json.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace ajar::gltf {

struct MeshoptHeader {
    std::uint64_t count = 0;
    std::uint64_t stride = 0; // bytes per element, at most 256
    std::string mode;
    std::string filter;
};

// The compression of a buffer view, if it has any.
std::optional<JsonObject> meshopt_extension(const JsonObject& buffer_view);

// Throws Error for sizes that the decoder would not survive.
MeshoptHeader read_meshopt_header(const JsonObject& extension);

// count * stride bytes. Throws Error when the stream is malformed or of a newer version.
std::vector<std::byte> decode_meshopt(const JsonObject& extension, const MeshoptHeader& header,
                                      std::span<const std::byte> stream);

} // namespace ajar::gltf
