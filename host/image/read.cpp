#include "image/read.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "image/decoder.hpp"
#include "image/srgb.hpp"
#include "image/webp.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <limits>
#include <map>

namespace ajar {
namespace {

constexpr std::uint64_t max_pixels = (std::uint64_t{1} << 28) - 1;
constexpr std::uint64_t max_values = std::uint64_t{1} << 32;

// Where a channel of the file goes.
struct Place {
    std::string layer, channel;
};

// "albedo.R" is channel R of layer albedo. Of the unnamed channels R, G, B, A and Y are the beauty's; Z is
// depth, and any other is a layer of its own.
Place place(const std::string& file_channel) {
    const std::size_t dot = file_channel.rfind('.');
    if (dot != std::string::npos) return {file_channel.substr(0, dot), file_channel.substr(dot + 1)};
    if (file_channel == "Z") return {"depth", "Z"};
    const bool color =
        file_channel.size() == 1 && std::string_view("RGBAY").find(file_channel) != std::string::npos;
    return {color ? "" : file_channel, file_channel};
}

// R, G, B, A and X, Y, Z in this order, others behind.
std::size_t rank(const std::string& channel) {
    return channel.size() == 1 ? std::string_view("RGBAXYZ").find(channel[0]) : std::string_view::npos;
}

// One channel of the file and the layer and channel of the image that it fills.
struct Route {
    std::size_t layer = 0;
    std::uint32_t channel = 0;
    float scale = 1;
};

std::vector<Route> plan_layers(const OIIO::ImageSpec& spec, Image& image) {
    std::map<std::string, std::vector<std::pair<std::string, std::size_t>>>
        found; // layer: channels, place in file
    for (std::size_t c = 0; c < spec.channelnames.size(); ++c) {
        const Place to = place(spec.channelnames[c]);
        found[to.layer].emplace_back(to.channel, c);
    }
    std::vector<Route> routes(spec.channelnames.size());
    for (auto& [name, channels] : found) {
        std::stable_sort(channels.begin(), channels.end(),
                         [](const auto& a, const auto& b) { return rank(a.first) < rank(b.first); });
        Layer& layer = image.layers.emplace_back();
        layer.name = name;
        for (const auto& [channel, source] : channels) {
            const OIIO::TypeDesc type = spec.channelformat(static_cast<int>(source));
            if (type == OIIO::TypeDesc::HALF) layer.rounding = 0x1p-11f;
            // OpenImageIO maps unsigned integers to [0, 1]; ids are wanted as they are.
            const float scale = type == OIIO::TypeDesc::UINT ? 4294967295.0f : 1.0f;
            routes[source] = {image.layers.size() - 1, layer.channels++, scale};
            layer.channel_names.push_back(channel);
        }
    }
    return routes;
}

void append_rows(Image& image, const std::vector<Route>& routes, std::uint32_t rows,
                 std::span<const float> values) {
    const std::size_t count = std::size_t{rows} * image.width;
    for (Layer& layer : image.layers) layer.pixels.resize(layer.pixels.size() + count * layer.channels);
    for (std::size_t c = 0; c < routes.size(); ++c) {
        Layer& layer = image.layers[routes[c].layer];
        float* to = layer.pixels.data() + layer.pixels.size() - count * layer.channels + routes[c].channel;
        for (std::size_t i = 0; i < count; ++i)
            to[i * layer.channels] = values[i * routes.size() + c] * routes[c].scale;
    }
}

// Grey to R, G, B; a missing alpha to 1.
void complete_beauty(Image& image) {
    Layer* layer = image.find("");
    if (!layer) return;
    const auto& names = layer->channel_names;
    const auto index = [&](const char* name) {
        return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
    };
    const std::array<std::size_t, 4> from = index("R") < names.size()
                                                ? std::array{index("R"), index("G"), index("B"), index("A")}
                                                : std::array{index("Y"), index("Y"), index("Y"), index("A")};
    if (std::any_of(from.begin(), from.begin() + 3, [&](std::size_t c) { return c == names.size(); })) {
        layer->name = "(incomplete)"; // an R without G, for example: no beauty to speak of
        return;
    }
    std::vector<float> pixels(image.pixel_count() * 4);
    for (std::size_t i = 0; i < image.pixel_count(); ++i)
        for (std::size_t c = 0; c < 4; ++c)
            pixels[4 * i + c] = from[c] < names.size() ? layer->pixels[i * layer->channels + from[c]] : 1.0f;
    layer->pixels = std::move(pixels);
    layer->channels = 4;
    layer->channel_names = {"R", "G", "B", "A"};
}

void read_metadata(const OIIO::ImageSpec& spec, Image& image) {
    for (const OIIO::ParamValue& attribute : spec.extra_attribs) {
        const std::string key = attribute.name().string();
        const bool own = key.starts_with("oiio:") || key.starts_with("openexr:") || key == "compression" ||
                         key == "DateTime"; // empty in this room's files
        if (attribute.type() == OIIO::TypeDesc::STRING && !own)
            image.metadata.emplace_back(key, attribute.get_string());
    }
}

Image read_scene(Decoder& decoder, const std::string& name) {
    Image image{decoder.width(), decoder.height(), {}, {}, Range::scene};
    if (image.pixel_count() > max_values / decoder.channels())
        throw Error(fmt::format("{}: {} x {} pixels of {} channels are too many", name, image.width,
                                image.height, decoder.channels()));
    const std::vector<Route> routes = plan_layers(decoder.spec(), image);
    const std::uint32_t width = image.width * decoder.channels();
    decoder.read<float>([&](std::uint32_t, std::span<const float> values) {
        append_rows(image, routes, static_cast<std::uint32_t>(values.size() / width), values);
    });
    complete_beauty(image);
    read_metadata(decoder.spec(), image);
    return image;
}

// Spreads the one to four channels of a PNG, JPEG or WebP pixel to RGBA.
template <class T> std::array<T, 4> spread(const T* values, std::uint32_t channels, T opaque) {
    switch (channels) {
    case 1: return {values[0], values[0], values[0], opaque};
    case 2: return {values[0], values[0], values[0], values[1]};
    case 3: return {values[0], values[1], values[2], opaque};
    default: return {values[0], values[1], values[2], values[3]};
    }
}

// Undoes the sRGB curve and multiplies by alpha.
void append_display(Layer& layer, const std::array<float, 4>& encoded) {
    for (std::size_t c = 0; c < 3; ++c) layer.pixels.push_back(srgb_decode(encoded[c]) * encoded[3]);
    layer.pixels.push_back(encoded[3]);
}

Image read_display(Decoder& decoder) {
    Image image{decoder.width(), decoder.height(), {}, {}, Range::display};
    Layer& layer = image.layers.emplace_back(Layer{"", 4, {"R", "G", "B", "A"}, {}});
    const std::uint32_t channels = decoder.channels();
    decoder.read<float>([&](std::uint32_t, std::span<const float> values) {
        for (std::size_t i = 0; i < values.size(); i += channels)
            append_display(layer, spread(values.data() + i, channels, 1.0f));
    });
    return image;
}

Image read_webp(std::span<const std::byte> bytes, const std::string& name) {
    const DecodedImage decoded = decode_rgba8(bytes, name, max_pixels);
    Image image{decoded.width, decoded.height, {}, {}, Range::display};
    Layer& layer = image.layers.emplace_back(Layer{"", 4, {"R", "G", "B", "A"}, {}});
    for (std::size_t i = 0; i < decoded.rgba.size(); i += 4) {
        std::array<float, 4> encoded{};
        for (std::size_t c = 0; c < 4; ++c) encoded[c] = static_cast<float>(decoded.rgba[i + c]) / 255;
        append_display(layer, encoded);
    }
    return image;
}

bool is_scene(Format format) { return format == Format::exr || format == Format::hdr; }

DecodedImage decode_with(Decoder& decoder) {
    DecodedImage image{decoder.width(), decoder.height(), {}};
    const std::uint32_t channels = decoder.channels();
    const auto append = [&]<class T>(std::span<const T> values) {
        constexpr std::uint32_t top = std::numeric_limits<T>::max();
        for (std::size_t i = 0; i < values.size(); i += channels)
            for (const std::uint32_t value : spread<T>(values.data() + i, channels, top))
                image.rgba.push_back(static_cast<std::uint8_t>((value * 255 + top / 2) / top));
    };
    if (decoder.spec().format == OIIO::TypeDesc::UINT16)
        decoder.read<std::uint16_t>([&](std::uint32_t, std::span<const std::uint16_t> v) { append(v); });
    else
        decoder.read<std::uint8_t>([&](std::uint32_t, std::span<const std::uint8_t> v) { append(v); });
    return image;
}

} // namespace

Image read_image(const std::filesystem::path& path) {
    const std::string name = path.string();
    Image image;
    guard_decoding(name, [&] {
        const std::vector<std::byte> bytes = read_file(path);
        if (inspect(bytes, name).format == Format::webp) {
            image = read_webp(bytes, name);
            return;
        }
        Decoder decoder(bytes, name, max_pixels);
        image = is_scene(decoder.format()) ? read_scene(decoder, name) : read_display(decoder);
    });
    return image;
}

DecodedImage decode_rgba8(std::span<const std::byte> bytes, const std::string& name, std::uint64_t limit) {
    DecodedImage image;
    guard_decoding(name, [&] {
        Decoder decoder(bytes, name, limit);
        if (is_scene(decoder.format()))
            throw Error(fmt::format("{}: is not a PNG, JPEG or WebP image", name));
        image = decode_with(decoder);
        if (decoder.format() != Format::webp) return;
        const std::vector<std::byte> opaque = opaque_webp(bytes, name);
        if (opaque.empty()) return;
        Decoder colors_decoder(opaque, name, limit);
        const DecodedImage colors = decode_with(colors_decoder);
        if (colors.rgba.size() != image.rgba.size())
            throw Error(fmt::format("{}: corrupt WebP: two sizes in one file", name));
        for (std::size_t i = 0; i < image.rgba.size(); ++i)
            if (i % 4 != 3) image.rgba[i] = colors.rgba[i];
    });
    return image;
}

EnvironmentImage read_environment(const std::filesystem::path& path) {
    const std::string name = path.string();
    const Image image = read_image(path);
    if (image.range != Range::scene)
        throw Error(fmt::format("{}: is not an .hdr or .exr file, so it holds no radiance", name));
    const Layer& layer = beauty(image, name);
    EnvironmentImage environment{image.width, image.height, {}};
    environment.radiance.reserve(image.pixel_count());
    for (std::size_t i = 0; i < image.pixel_count(); ++i) {
        const float* pixel = layer.pixels.data() + i * layer.channels;
        const glm::vec3 color(pixel[0], pixel[1], pixel[2]);
        if (!std::isfinite(color.x) || !std::isfinite(color.y) || !std::isfinite(color.z))
            throw Error(fmt::format("{}: pixel ({}, {}) is not a finite number", name, i % image.width,
                                    i / image.width));
        environment.radiance.push_back(glm::max(color, 0.0f));
    }
    return environment;
}

} // namespace ajar
