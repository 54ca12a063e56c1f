#include "image/image.hpp"

#include "base/error.hpp"

#include <fmt/format.h>

namespace ajar {

const Layer* Image::find(std::string_view name) const {
    for (const Layer& layer : layers)
        if (layer.name == name) return &layer;
    return nullptr;
}

Layer* Image::find(std::string_view name) { return const_cast<Layer*>(std::as_const(*this).find(name)); }

Layer& Image::add(std::string name, std::vector<std::string> channel_names) {
    Layer& layer = layers.emplace_back();
    layer.name = std::move(name);
    layer.channels = static_cast<std::uint32_t>(channel_names.size());
    layer.channel_names = std::move(channel_names);
    layer.pixels.resize(pixel_count() * layer.channels);
    return layer;
}

const Layer& beauty(const Image& image, std::string_view name) {
    const Layer* layer = image.find("");
    if (layer && layer->channels >= 3 && layer->pixels.size() == image.pixel_count() * layer->channels)
        return *layer;
    std::string others;
    for (const Layer& other : image.layers)
        others += fmt::format("{}'{}'", others.empty() ? "" : ", ", other.name);
    throw Error(fmt::format("{}: has no plain R, G, B channels (its layers: {})", name,
                            others.empty() ? "none" : others));
}

} // namespace ajar
