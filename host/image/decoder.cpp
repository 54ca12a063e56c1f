#include "image/decoder.hpp"

#include "base/error.hpp"
#include "image/png.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <new>

namespace ajar {
namespace {

const char* plugin(Format format) {
    switch (format) {
    case Format::png: return "png";
    case Format::jpeg: return "jpeg";
    case Format::webp: return "webp";
    case Format::exr: return "openexr";
    case Format::hdr: return "hdr";
    }
    return "";
}

Claim inspect_below(std::span<const std::byte> bytes, std::string_view name, std::uint64_t max_pixels) {
    const Claim claim = inspect(bytes, name);
    if (claim.width > INT32_MAX || claim.height > max_pixels / claim.width)
        throw Error(fmt::format("{}: claims {} x {} pixels, the limit here is {} in all", name, claim.width,
                                claim.height, max_pixels));
    return claim;
}

} // namespace

Decoder::Decoder(std::span<const std::byte> bytes, std::string name, std::uint64_t max_pixels)
    : name_(std::move(name)), claim_(inspect_below(bytes, name_, max_pixels)),
      png_(claim_.format == Format::png ? essential_png(bytes, name_) : std::vector<std::byte>{}),
      source_(png_.empty() ? bytes.data() : png_.data(), png_.empty() ? bytes.size() : png_.size()) {
    // By format, never by name: OpenImageIO would try every plugin it has on a file that one of them refuses.
    input_ = OIIO::ImageInput::create(plugin(claim_.format));
    if (!input_) {
        OIIO::geterror();
        throw Error(
            fmt::format("{}: this build of OpenImageIO cannot read {} files", name_, plugin(claim_.format)));
    }
    OIIO::ImageSpec hints;
    hints.attribute("oiio:UnassociatedAlpha", 1);
    if (!input_->set_ioproxy(&source_) || !input_->open(name_, spec_, hints)) fail();
    const bool as_claimed =
        spec_.width == static_cast<int>(width()) && spec_.height == static_cast<int>(height());
    if (!as_claimed || spec_.nchannels <= 0 || spec_.depth > 1 || spec_.deep)
        throw Error(fmt::format("{}: is not a flat two-dimensional image", name_));
}

Decoder::~Decoder() {
    if (input_) input_->geterror(); // OpenImageIO prints a message that nobody fetched
}

void Decoder::fail() const {
    std::string message = input_->geterror();
    while (!message.empty() && (message.back() == '\n' || message.back() == ' ')) message.pop_back();
    std::replace(message.begin(), message.end(), '\n', ' ');
    throw Error(
        fmt::format("{}: cannot be decoded: {}", name_, message.empty() ? "corrupt or truncated" : message));
}

std::uint32_t Decoder::band_height() const {
    const std::uint32_t tile = static_cast<std::uint32_t>(std::max(1, spec_.tile_height));
    return spec_.tile_width > 0 ? tile : 64; // OpenEXR's ZIP packs 16 rows, DWAA 32, PIZ 32
}

void Decoder::read_band(std::uint32_t begin, std::uint32_t end, OIIO::TypeDesc type, void* values) {
    const int first = spec_.y + static_cast<int>(begin), last = spec_.y + static_cast<int>(end);
    const bool good =
        spec_.tile_width > 0
            ? input_->read_tiles(0, 0, spec_.x, spec_.x + spec_.width, first, last, spec_.z, spec_.z + 1, 0,
                                 spec_.nchannels, type, values)
            : input_->read_scanlines(0, 0, first, last, spec_.z, 0, spec_.nchannels, type, values);
    if (!good) fail();
}

void guard_decoding(const std::string& name, const std::function<void()>& body) {
    try {
        body();
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw Error(fmt::format("{}: is too large for the memory of this machine", name));
    } catch (const std::exception& error) {
        std::string message = error.what();
        std::replace(message.begin(), message.end(), '\n', ' ');
        throw Error(fmt::format("{}: cannot be decoded: {}", name, message));
    }
}

} // namespace ajar
