// A 128-bit content hash (XXH3, Yann Collet), for manifests and cache keys. Not cryptographic.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace ajar {

// Thirty-two lower-case hexadecimal digits.
std::string content_hash(std::span<const std::byte> bytes);

} // namespace ajar
