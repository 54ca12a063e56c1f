#include "image/write.hpp"

#include "base/error.hpp"
#include "base/file.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <span>

namespace ajar {
namespace {

struct Target {
    const char* extension;
    const char* plugin;
};

constexpr std::array targets{Target{".exr", "openexr"}, Target{".png", "png"}, Target{".jpg", "jpeg"},
                             Target{".jpeg", "jpeg"}, Target{".hdr", "hdr"}};

const Target& find_target(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    std::string known;
    for (const Target& target : targets) {
        if (extension == target.extension) return target;
        known += fmt::format("{}{}", known.empty() ? "" : " ", target.extension);
    }
    throw Error(fmt::format("{}: cannot be written: the extension '{}' is none of {}", path.string(),
                            extension, known));
}

// In memory, so that a full disk is noticed by one writer, write_file. `name`: begins the errors' lines.
std::vector<unsigned char> encoded(const std::string& name, const char* plugin, const OIIO::ImageSpec& spec,
                                   OIIO::TypeDesc type, const void* values) {
    OIIO::Filesystem::IOVecOutput bytes;
    const auto output = OIIO::ImageOutput::create(plugin);
    if (!output) throw Error(fmt::format("{}: this build of OpenImageIO cannot write {}", name, plugin));
    const bool good = output->set_ioproxy(&bytes) && output->open(name, spec) &&
                      output->write_image(type, values) && output->close();
    std::string message = output->geterror();
    std::replace(message.begin(), message.end(), '\n', ' ');
    if (!good) throw Error(fmt::format("{}: cannot be encoded: {}", name, message));
    return bytes.buffer();
}

void encode(const std::filesystem::path& path, const char* plugin, const OIIO::ImageSpec& spec,
            OIIO::TypeDesc type, const void* values) {
    const std::vector<unsigned char> bytes = encoded(path.string(), plugin, spec, type, values);
    write_file(path, std::as_bytes(std::span(bytes)));
}

bool needs_full_floats(std::string_view layer) {
    constexpr std::array names{"variance", "position", "depth", "samples"};
    return layer.ends_with("_id") || std::find(names.begin(), names.end(), layer) != names.end();
}

void write_exr(const std::filesystem::path& path, const Image& image, const WriteOptions& options) {
    OIIO::ImageSpec spec(static_cast<int>(image.width), static_cast<int>(image.height), 0,
                         OIIO::TypeDesc::FLOAT);
    for (const Layer& layer : image.layers)
        for (const std::string& channel : layer.channel_names) {
            const bool full = options.exr_floats == ExrFloats::full || needs_full_floats(layer.name);
            spec.channelnames.push_back(layer.name.empty() ? channel : layer.name + "." + channel);
            spec.channelformats.push_back(full ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::HALF);
        }
    const std::size_t channels = spec.channelnames.size();
    spec.nchannels = static_cast<int>(channels);
    spec.attribute("compression", "zip");
    for (const auto& [key, value] : image.metadata) spec.attribute(key, value);
    spec.attribute("DateTime", ""); // OpenImageIO writes the time of day where there is none

    std::vector<float> values(image.pixel_count() * channels);
    std::size_t to = 0;
    for (const Layer& layer : image.layers)
        for (std::size_t c = 0; c < layer.channels; ++c, ++to) {
            const bool half = spec.channelformats[to] == OIIO::TypeDesc::HALF;
            for (std::size_t i = 0; i < image.pixel_count(); ++i) {
                const float value = layer.pixels[i * layer.channels + c];
                // Beyond half's range lies infinity, and a comparison would refuse the file. A NaN stays one.
                values[i * channels + to] = half ? std::clamp(value, -65504.0f, 65504.0f) : value;
            }
        }
    encode(path, "openexr", spec, OIIO::TypeDesc::FLOAT, values.data());
}

std::uint8_t to_byte(float value) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0f, 1.0f)));
}

void write_display(const std::filesystem::path& path, const char* plugin, const Image& image,
                   const WriteOptions& options) {
    const Layer& layer = beauty(image, path.string());
    const bool png = std::string_view(plugin) == "png";
    const bool with_alpha = png && options.alpha == Alpha::keep && layer.channels >= 4;
    const int channels = with_alpha ? 4 : 3;
    OIIO::ImageSpec spec(static_cast<int>(image.width), static_cast<int>(image.height), channels,
                         OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("oiio:UnassociatedAlpha", 1);
    if (!png) {
        spec.attribute("Compression", fmt::format("jpeg:{}", options.jpeg_quality));
        spec.attribute("jpeg:subsampling", "4:4:4");
    }
    std::vector<std::uint8_t> values;
    values.reserve(image.pixel_count() * static_cast<std::size_t>(channels));
    for (std::size_t i = 0; i < image.pixel_count(); ++i) {
        const float* pixel = layer.pixels.data() + i * layer.channels;
        const float alpha = with_alpha ? pixel[3] : 1;
        const float scale = alpha > 0 ? 1 / alpha : 1;
        const glm::vec3 color = options.tonemap(glm::vec3(pixel[0], pixel[1], pixel[2]) * scale);
        for (int c = 0; c < 3; ++c) values.push_back(to_byte(color[c]));
        if (with_alpha) values.push_back(to_byte(alpha > 0 ? alpha : 0));
    }
    encode(path, plugin, spec, OIIO::TypeDesc::UINT8, values.data());
}

void write_hdr(const std::filesystem::path& path, const Image& image) {
    const Layer& layer = beauty(image, path.string());
    // RGBE's exponent ends at 2^127; it has no sign, no NaN and no infinity.
    constexpr float most = 0x1.fep126f;
    std::vector<float> values;
    values.reserve(image.pixel_count() * 3);
    for (std::size_t i = 0; i < image.pixel_count(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const float value = layer.pixels[i * layer.channels + c];
            values.push_back(value > 0 ? std::min(value, most) : 0.0f);
        }
    const OIIO::ImageSpec spec(static_cast<int>(image.width), static_cast<int>(image.height), 3,
                               OIIO::TypeDesc::FLOAT);
    encode(path, "hdr", spec, OIIO::TypeDesc::FLOAT, values.data());
}

} // namespace

void write_image(const std::filesystem::path& path, const Image& image, const WriteOptions& options) {
    const Target& target = find_target(path);
    if (image.pixel_count() == 0 || image.layers.empty())
        throw Error(fmt::format("{}: cannot be written: the image is empty", path.string()));
    const std::string_view plugin = target.plugin;
    if (plugin == "openexr")
        write_exr(path, image, options);
    else if (plugin == "hdr")
        write_hdr(path, image);
    else
        write_display(path, target.plugin, image, options);
}

std::vector<std::byte> encode_png(std::uint32_t width, std::uint32_t height, std::uint32_t channels,
                                  std::span<const std::uint8_t> values) {
    OIIO::ImageSpec spec(static_cast<int>(width), static_cast<int>(height), static_cast<int>(channels),
                         OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:UnassociatedAlpha", 1); // else colours are divided by alpha
    const auto bytes = encoded("texture.png", "png", spec, OIIO::TypeDesc::UINT8, values.data());
    const auto whole = std::as_bytes(std::span(bytes));
    return {whole.begin(), whole.end()};
}

void check_output_name(const std::filesystem::path& path) {
    find_target(path);
    const PendingFile checks_the_folder(path); // creates nothing
}

} // namespace ajar
