// URIs as glTF uses them: base64 or percent-encoded data URIs and relative paths (RFC 2397, RFC 3986, RFC
// 4648).
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ajar::gltf {

bool is_data_uri(std::string_view uri);

// The bytes of a data URI. Throws Error without a place, which the caller adds.
std::vector<std::byte> decode_data_uri(std::string_view uri);

// "a%20b" -> "a b". An incomplete or invalid escape stays as it is.
std::string percent_decode(std::string_view text);

// The file a relative URI means. Throws Error (without a place) for absolute paths and other schemes.
std::filesystem::path resolve_uri(const std::filesystem::path& folder, std::string_view uri);

} // namespace ajar::gltf
