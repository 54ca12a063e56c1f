#include "import/document.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "import/uri.hpp"

#include <algorithm>
#include <cstring>
#include <fmt/format.h>

namespace ajar::gltf {

namespace {

constexpr std::uint32_t GLB_MAGIC = 0x46546c67; // "glTF"
constexpr std::uint32_t CHUNK_JSON = 0x4e4f534a;
constexpr std::uint32_t CHUNK_BIN = 0x004e4942;
constexpr std::size_t GLB_HEADER = 12;
constexpr std::size_t CHUNK_HEADER = 8;

std::uint32_t read_u32(std::span<const std::byte> bytes, std::size_t offset) {
    std::uint32_t value;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

} // namespace

Document::Document(std::span<const std::byte> bytes, std::string file, std::filesystem::path folder,
                   const ImportOptions& options)
    : options_(options), folder_(std::move(folder)) {
    info_.file = std::move(file);
    info_.bytes_read = bytes.size();
    read_container(bytes);
    root_ = std::make_unique<JsonObject>(json_, info_.file + ": ");
    read_asset();
}

void Document::read_container(std::span<const std::byte> bytes) {
    if (bytes.empty()) throw Error(fmt::format("{}: is empty", file()));
    if (bytes.size() < 4 || read_u32(bytes, 0) != GLB_MAGIC) {
        json_ = parse_json(bytes, file());
        return;
    }
    if (bytes.size() < GLB_HEADER + CHUNK_HEADER) throw Error(fmt::format("{}: the GLB is cut off", file()));
    if (const std::uint32_t version = read_u32(bytes, 4); version != 2)
        throw Error(fmt::format("{}: is a GLB of version {} (only 2 can be read)", file(), version));
    const std::size_t length = read_u32(bytes, 8);
    if (length > bytes.size())
        throw Error(
            fmt::format("{}: the GLB is cut off: {} of {} bytes are there", file(), bytes.size(), length));
    std::size_t offset = GLB_HEADER;
    for (std::size_t chunk = 0; length >= offset + CHUNK_HEADER; ++chunk) {
        const std::size_t size = read_u32(bytes, offset);
        const std::uint32_t type = read_u32(bytes, offset + 4);
        offset += CHUNK_HEADER;
        if (size > length - offset)
            throw Error(fmt::format("{}: GLB chunk {} has {} bytes, {} are left", file(), chunk, size,
                                    length - offset));
        const std::span<const std::byte> content = bytes.subspan(offset, size);
        if (chunk == 0 && type != CHUNK_JSON)
            throw Error(fmt::format("{}: the GLB's first chunk is not JSON", file()));
        if (chunk == 0) json_ = parse_json(content, file());
        if (chunk == 1 && type == CHUNK_BIN) bin_ = content;
        offset += std::min((size + 3) / 4 * 4, length - offset); // the padding may be missing at the end
    }
    if (json_.is_null()) throw Error(fmt::format("{}: the GLB has no JSON chunk", file()));
}

void Document::read_asset() {
    const auto asset = root_->object("asset");
    if (!asset) throw Error(fmt::format("{}: is not a glTF file: it has no \"asset\"", file()));
    info_.version = asset->text("version");
    const std::string needed = asset->text("minVersion", info_.version);
    if (!needed.starts_with("2.") || (asset->has("minVersion") && needed != "2.0"))
        throw Error(
            fmt::format("{}: is glTF {} (only 2.0 can be read)", file(), needed.empty() ? "?" : needed));
    info_.generator = asset->text("generator");
    info_.copyright = asset->text("copyright");
}

std::size_t Document::count(std::string_view key) const {
    const auto it = json_.find(key);
    if (it == json_.end()) return 0;
    if (!it->is_array()) root_->fail(key, "must be an array");
    return it->size();
}

std::vector<std::byte> Document::resource(const JsonObject& object) {
    const std::string uri = object.text("uri");
    std::vector<std::byte> bytes;
    if (is_data_uri(uri)) {
        try {
            return decode_data_uri(uri); // its bytes are the JSON's, which were counted
        } catch (const Error& error) {
            object.fail("uri", error.what());
        }
    }
    try {
        bytes = read_file(resolve_uri(folder_, uri), options_.limits.max_file_bytes);
    } catch (const Error& error) {
        object.fail("uri", error.what());
    }
    info_.bytes_read += bytes.size();
    return bytes;
}

void Document::warn(std::string_view message) {
    std::string line = fmt::format("{}: {}", file(), message);
    std::replace_if(
        line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
    if (options_.warn) options_.warn(line);
    info_.warnings.push_back(std::move(line));
}

void Document::charge(std::uint64_t bytes, const JsonObject& cause) {
    const ImportLimits& limits = options_.limits;
    const std::uint64_t allowed = std::min(
        limits.max_decoded_bytes, limits.decoded_slack_bytes + limits.decoded_ratio * info_.bytes_read);
    if (bytes > allowed || decoded_ > allowed - bytes)
        cause.fail("", fmt::format("would make {} MiB out of a file of {} bytes (the limit is {} MiB)",
                                   (decoded_ + std::min(bytes, UINT64_MAX - decoded_)) >> 20,
                                   info_.bytes_read, allowed >> 20));
    decoded_ += bytes;
}

void Document::charge_triangles(std::uint64_t count, const JsonObject& cause) {
    triangles_ += count;
    if (triangles_ > options_.limits.max_triangles)
        cause.fail(
            "", fmt::format("brings the file past {} triangles (the limit)", options_.limits.max_triangles));
}

} // namespace ajar::gltf
