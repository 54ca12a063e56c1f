#include "image/format.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstring>
#include <fmt/format.h>
#include <optional>
#include <string>

namespace ajar {
namespace {

// Reads integers at any place; past the end it throws.
class Bytes {
  public:
    Bytes(std::span<const std::byte> bytes, std::string_view name) : bytes_(bytes), name_(name) {}

    std::uint64_t big(std::size_t at, std::size_t count) const {
        std::uint64_t value = 0;
        for (std::size_t i = 0; i < count; ++i) value = value << 8 | byte(at + i);
        return value;
    }
    std::uint64_t little(std::size_t at, std::size_t count) const {
        std::uint64_t value = 0;
        for (std::size_t i = count; i-- > 0;) value = value << 8 | byte(at + i);
        return value;
    }
    bool has(std::size_t at, std::string_view text) const {
        return at <= bytes_.size() && text.size() <= bytes_.size() - at &&
               std::memcmp(bytes_.data() + at, text.data(), text.size()) == 0;
    }
    // The text from `at` up to `end`, which is not part of it.
    std::string_view text(std::size_t at, char end) const {
        const auto* first = reinterpret_cast<const char*>(bytes_.data());
        const std::string_view rest =
            at < bytes_.size() ? std::string_view(first + at, bytes_.size() - at) : "";
        const std::size_t length = rest.find(end);
        if (length == std::string_view::npos) throw_truncated();
        return rest.substr(0, length);
    }
    std::size_t size() const { return bytes_.size(); }

    [[noreturn]] void throw_truncated() const {
        throw Error(fmt::format("{}: ends within the image's header ({} bytes)", name_, bytes_.size()));
    }
    [[noreturn]] void throw_corrupt(std::string_view what) const {
        throw Error(fmt::format("{}: is not a valid image: {}", name_, what));
    }

  private:
    std::uint64_t byte(std::size_t at) const {
        if (at >= bytes_.size()) throw_truncated();
        return std::to_integer<std::uint64_t>(bytes_[at]);
    }

    std::span<const std::byte> bytes_;
    std::string_view name_;
};

Claim inspect_png(const Bytes& bytes) {
    if (!bytes.has(12, "IHDR")) bytes.throw_corrupt("PNG without IHDR");
    return {Format::png, bytes.big(16, 4), bytes.big(20, 4)};
}

// Walks the marker segments up to the frame header (SOF), then checks that an end of image (EOI) follows the
// scan: decoders fill what is missing with grey.
Claim inspect_jpeg(const Bytes& bytes) {
    std::optional<Claim> claim;
    for (std::size_t at = 2;;) {
        if (bytes.big(at, 1) != 0xff) bytes.throw_corrupt("JPEG marker expected");
        const std::uint64_t marker = bytes.big(at + 1, 1);
        if (marker == 0xff) { // fill byte
            ++at;
            continue;
        }
        const bool frame =
            marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
        if (frame) claim = {Format::jpeg, bytes.big(at + 7, 2), bytes.big(at + 5, 2)};
        const std::uint64_t length = bytes.big(at + 2, 2);
        if (length < 2) bytes.throw_corrupt("JPEG segment without length");
        at += 2 + length;
        if (marker != 0xda) continue;
        if (!claim) bytes.throw_corrupt("JPEG scan without frame header");
        for (std::size_t end = bytes.size(); end >= at + 2; --end)
            if (bytes.has(end - 2, "\xff\xd9")) return *claim;
        bytes.throw_corrupt("JPEG data ends before the image does");
    }
}

Claim inspect_webp(const Bytes& bytes) {
    if (bytes.little(4, 4) + 8 > bytes.size()) bytes.throw_corrupt("WebP data ends before the image does");
    if (bytes.has(12, "VP8X")) return {Format::webp, bytes.little(24, 3) + 1, bytes.little(27, 3) + 1, false};
    if (bytes.has(12, "VP8L")) {
        const std::uint64_t bits = bytes.little(21, 4);
        return {Format::webp, (bits & 0x3fff) + 1, (bits >> 14 & 0x3fff) + 1, false};
    }
    if (bytes.has(12, "VP8 "))
        return {Format::webp, bytes.little(26, 2) & 0x3fff, bytes.little(28, 2) & 0x3fff, false};
    bytes.throw_corrupt("WebP without image data");
}

// Attributes: name, type (both ending in 0), size, value. The first header's dataWindow is the image.
Claim inspect_exr(const Bytes& bytes) {
    Claim claim{Format::exr, 0, 0};
    for (std::size_t at = 8;;) {
        const std::string_view attribute = bytes.text(at, '\0');
        if (attribute.empty()) return claim;
        at += attribute.size() + 1;
        at += bytes.text(at, '\0').size() + 1;
        const std::uint64_t size = bytes.little(at, 4);
        at += 4;
        // PIZ, DWAA and DWAB pack an empty block of any width into a few bytes.
        if (attribute == "compression") {
            const std::uint64_t method = bytes.little(at, 1);
            claim.bounded = method != 4 && method < 8;
        }
        if (attribute != "dataWindow") {
            at += size;
            continue;
        }
        std::int64_t corner[4];
        for (std::size_t i = 0; i < 4; ++i)
            corner[i] = static_cast<std::int32_t>(static_cast<std::uint32_t>(bytes.little(at + 4 * i, 4)));
        const std::int64_t width = corner[2] - corner[0] + 1, height = corner[3] - corner[1] + 1;
        if (width <= 0 || height <= 0) bytes.throw_corrupt("OpenEXR with an empty dataWindow");
        claim.width = static_cast<std::uint64_t>(width);
        claim.height = static_cast<std::uint64_t>(height);
        at += size;
    }
}

// Text lines up to an empty one, then "-Y height +X width" (any signs, either order).
Claim inspect_hdr(const Bytes& bytes) {
    std::size_t at = 0;
    while (!bytes.text(at, '\n').empty()) at += bytes.text(at, '\n').size() + 1;
    const std::string_view line = bytes.text(at + 1, '\n');
    Claim claim{Format::hdr, 0, 0};
    for (const char axis : {'X', 'Y'}) {
        const std::size_t place = line.find(axis);
        if (place == std::string_view::npos) bytes.throw_corrupt("Radiance header without a size");
        const std::string_view digits = line.substr(std::min(place + 2, line.size()));
        auto& extent = axis == 'X' ? claim.width : claim.height;
        std::from_chars(digits.data(), digits.data() + digits.size(), extent);
    }
    return claim;
}

} // namespace

Claim inspect(std::span<const std::byte> data, std::string_view name) {
    const Bytes bytes(data, name);
    if (data.empty()) throw Error(fmt::format("{}: is empty", name));
    Claim claim;
    if (bytes.has(0, "\x89PNG\r\n\x1a\n"))
        claim = inspect_png(bytes);
    else if (bytes.has(0, "\xff\xd8\xff"))
        claim = inspect_jpeg(bytes);
    else if (bytes.has(0, "RIFF") && bytes.has(8, "WEBP"))
        claim = inspect_webp(bytes);
    else if (bytes.has(0, "\x76\x2f\x31\x01"))
        claim = inspect_exr(bytes);
    else if (bytes.has(0, "#?RADIANCE") || bytes.has(0, "#?RGBE"))
        claim = inspect_hdr(bytes);
    else
        throw Error(fmt::format("{}: is not a PNG, JPEG, WebP, OpenEXR or Radiance HDR image", name));
    if (claim.width == 0 || claim.height == 0)
        throw Error(fmt::format("{}: has no pixels ({} x {})", name, claim.width, claim.height));
    // Deflate packs at best 258 bytes into 2 bits (RFC 1951), 1032 to 1; a JPEG holds at most 64 pixels in a
    // bit, HDR's run lengths 16 in a byte. A one-bit PNG packs eight pixels into each of those bytes.
    const std::uint64_t most = data.size() * 1032 * (claim.format == Format::png ? 8 : 1);
    if (claim.bounded && claim.height > most / claim.width)
        throw Error(fmt::format("{}: claims {} x {} pixels, which its {} bytes cannot hold", name,
                                claim.width, claim.height, data.size()));
    return claim;
}

} // namespace ajar
