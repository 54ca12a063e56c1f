// Which file format some bytes are, and how large a picture they claim to hold, before any decoder sees them:
// decoders allocate by what a header says. Sources: PNG (W3C 2003) 11.2.2, JPEG (ITU T.81) B.2, WebP
// container (RFC 9649), "OpenEXR File Layout", Radiance (Greg Ward).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace ajar {

enum class Format : std::uint8_t { png, jpeg, webp, exr, hdr };

struct Claim {
    Format format = Format::png;
    std::uint64_t width = 0;
    std::uint64_t height = 0;
    bool bounded = true; // no honest file of this kind packs more than about a thousand pixels into a byte
};

// Throws Error starting with `name` when the bytes are of another format, end within the header, claim no
// pixels, or are too few for what they claim (where the format tells).
Claim inspect(std::span<const std::byte> bytes, std::string_view name);

} // namespace ajar
