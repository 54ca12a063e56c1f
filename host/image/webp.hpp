// OpenImageIO 2.4 multiplies a WebP image's colours by alpha, whatever it is asked, and so loses them where
// alpha is low. Dropping the alpha from the container (RFC 9649) gives the colours as they are stored.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace ajar {

// A WebP file of the same picture, fully opaque; empty when it has no alpha anyway. Throws Error starting
// with `name` for an animation or a file without image data.
std::vector<std::byte> opaque_webp(std::span<const std::byte> bytes, std::string_view name);

} // namespace ajar
