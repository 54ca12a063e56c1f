#include "import/extensions/meshopt_compression.hpp"

#include <fmt/format.h>
#include <meshoptimizer.h>

namespace ajar::gltf {

namespace {

// A stream's first byte is its kind in the upper half and its version in the lower one.
struct StreamKind {
    std::string_view mode;
    unsigned char kind;
    unsigned char newest_version; // that meshoptimizer 0.18 reads
};
constexpr StreamKind KINDS[] = {{"ATTRIBUTES", 0xa0, 0}, {"TRIANGLES", 0xe0, 1}, {"INDICES", 0xd0, 1}};

void check_stream(const JsonObject& extension, const MeshoptHeader& header,
                  std::span<const std::byte> stream) {
    if (stream.empty()) extension.fail("", "the compressed data is empty");
    const auto first = std::to_integer<unsigned char>(stream[0]);
    for (const StreamKind& kind : KINDS) {
        if (kind.mode != header.mode) continue;
        if ((first & 0xf0) != kind.kind)
            extension.fail("", fmt::format("the data is not a meshopt stream of mode {}", header.mode));
        if ((first & 0x0f) > kind.newest_version)
            extension.fail(
                "", fmt::format("the data is a meshopt stream of version {}, newer than this program reads "
                                "(compress it with EXT_meshopt_compression)",
                                first & 0x0f));
    }
    // The densest stream spends a byte on 16 x 4 zeros, so this refuses a bomb before memory is taken.
    if (header.count * header.stride / 1024 > stream.size())
        extension.fail("", fmt::format("{} bytes of data cannot hold {} elements of {} bytes", stream.size(),
                                       header.count, header.stride));
}

void apply_filter(const JsonObject& extension, const MeshoptHeader& header, std::vector<std::byte>& bytes) {
    const auto wants_stride = [&](bool fits) {
        if (!fits)
            extension.fail("byteStride",
                           fmt::format("{} does not fit the filter {}", header.stride, header.filter));
    };
    if (header.filter == "OCTAHEDRAL") {
        wants_stride(header.stride == 4 || header.stride == 8);
        meshopt_decodeFilterOct(bytes.data(), header.count, header.stride);
    } else if (header.filter == "QUATERNION") {
        wants_stride(header.stride == 8);
        meshopt_decodeFilterQuat(bytes.data(), header.count, header.stride);
    } else if (header.filter == "EXPONENTIAL") {
        wants_stride(header.stride % 4 == 0);
        meshopt_decodeFilterExp(bytes.data(), header.count, header.stride);
    } else if (header.filter != "NONE") {
        extension.fail("filter", fmt::format("'{}' cannot be decoded", header.filter));
    }
}

} // namespace

std::optional<JsonObject> meshopt_extension(const JsonObject& buffer_view) {
    if (auto extension = buffer_view.extension("EXT_meshopt_compression")) return extension;
    return buffer_view.extension("KHR_meshopt_compression");
}

MeshoptHeader read_meshopt_header(const JsonObject& extension) {
    MeshoptHeader header;
    header.count = extension.integer("count");
    header.stride = extension.integer("byteStride");
    header.mode = extension.text("mode");
    header.filter = extension.text("filter", "NONE");
    if (header.count > (std::uint64_t{1} << 32)) extension.fail("count", "is more than 2^32");
    const bool is_index = header.mode == "TRIANGLES" || header.mode == "INDICES";
    if (header.mode == "ATTRIBUTES") {
        if (header.stride == 0 || header.stride > 256 || header.stride % 4 != 0)
            extension.fail("byteStride",
                           fmt::format("must be a multiple of 4 from 4 to 256, is {}", header.stride));
    } else if (!is_index) {
        extension.fail("mode", fmt::format("'{}' is none of ATTRIBUTES, TRIANGLES, INDICES", header.mode));
    } else if (header.stride != 2 && header.stride != 4) {
        extension.fail("byteStride", fmt::format("must be 2 or 4 for indices, is {}", header.stride));
    }
    if (header.mode == "TRIANGLES" && header.count % 3 != 0)
        extension.fail("count", fmt::format("must be a multiple of 3 for triangles, is {}", header.count));
    if (is_index && header.filter != "NONE") extension.fail("filter", "must be NONE for indices");
    return header;
}

std::vector<std::byte> decode_meshopt(const JsonObject& extension, const MeshoptHeader& header,
                                      std::span<const std::byte> stream) {
    check_stream(extension, header, stream);
    std::vector<std::byte> bytes(header.count * header.stride);
    const auto* data = reinterpret_cast<const unsigned char*>(stream.data());
    const std::size_t count = header.count;
    const std::size_t stride = header.stride;
    int failed = 0;
    if (header.mode == "ATTRIBUTES")
        failed = meshopt_decodeVertexBuffer(bytes.data(), count, stride, data, stream.size());
    else if (header.mode == "TRIANGLES")
        failed = meshopt_decodeIndexBuffer(bytes.data(), count, stride, data, stream.size());
    else
        failed = meshopt_decodeIndexSequence(bytes.data(), count, stride, data, stream.size());
    if (failed != 0) extension.fail("", "the compressed data is damaged");
    apply_filter(extension, header, bytes);
    return bytes;
}

} // namespace ajar::gltf
