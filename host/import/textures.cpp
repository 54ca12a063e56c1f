#include "import/textures.hpp"

#include "base/error.hpp"
#include "image/read.hpp"
#include "import/extensions/texture_transform.hpp"
#include "import/extensions/texture_webp.hpp"

#include <fmt/format.h>

namespace ajar::gltf {

namespace {

constexpr std::uint64_t NEAREST = 9728;
constexpr std::uint64_t REPEAT = 10497;
constexpr std::uint64_t CLAMP_TO_EDGE = 33071;
constexpr std::uint64_t MIRRORED_REPEAT = 33648;

Wrap read_wrap(const JsonObject& sampler, std::string_view key) {
    switch (const std::uint64_t mode = sampler.integer(key, REPEAT)) {
    case REPEAT: return Wrap::repeat;
    case CLAMP_TO_EDGE: return Wrap::clamp;
    case MIRRORED_REPEAT: return Wrap::mirror;
    default: sampler.fail(key, fmt::format("{} is no wrapping mode", mode));
    }
}

} // namespace

Textures::Textures(Document& document, Buffers& buffers, Scene& scene)
    : document_(document), buffers_(buffers), scene_(scene), textures_(document.root().objects("textures")),
      images_(document.root().objects("images")), samplers_(document.root().objects("samplers")) {}

TextureUse Textures::use(const std::optional<JsonObject>& texture_info) {
    TextureUse result;
    if (!texture_info) return result;
    const auto index = texture_info->index("index", textures_.size(), "texture");
    if (!index) texture_info->fail("index", "is missing");
    result.uv_set =
        static_cast<std::uint32_t>(std::min<std::uint64_t>(texture_info->integer("texCoord", 0), 1000));
    read_texture_transform(*texture_info, result);
    if (result.uv_set > 1) {
        document_.warn(fmt::format(
            "a texture is ignored: it uses TEXCOORD_{}, and only sets 0 and 1 are read", result.uv_set));
        return {};
    }
    result.texture = texture(*index);
    return result.used() ? result : TextureUse{};
}

std::uint32_t Textures::texture(std::uint32_t index) {
    const auto found = scene_textures_.find(index);
    if (found != scene_textures_.end()) return found->second;
    const JsonObject& object = textures_[index];
    auto source = webp_source(object, images_.size());
    if (!source) source = object.index("source", images_.size(), "image");
    std::uint32_t result = NO_INDEX;
    if (source) {
        Texture texture;
        texture.name = object.text("name");
        texture.image = image(*source);
        read_sampler(object, texture);
        result = static_cast<std::uint32_t>(scene_.textures.size());
        scene_.textures.push_back(std::move(texture));
    } else {
        document_.warn(
            fmt::format("texture {} is ignored: it has no image that this program can read", index));
    }
    scene_textures_.emplace(index, result);
    return result;
}

void Textures::read_sampler(const JsonObject& texture, Texture& result) {
    const auto index = texture.index("sampler", samplers_.size(), "sampler");
    if (!index) return;
    const JsonObject& sampler = samplers_[*index];
    result.wrap_u = read_wrap(sampler, "wrapS");
    result.wrap_v = read_wrap(sampler, "wrapT");
    // A path tracer looks at texels from near: what counts is how the file wants them magnified.
    if (sampler.integer("magFilter", 0) == NEAREST) result.filter = TextureFilter::nearest;
}

std::uint32_t Textures::image(std::uint32_t index) {
    const auto found = scene_images_.find(index);
    if (found != scene_images_.end()) return found->second;
    const JsonObject& object = images_[index];
    const auto view = object.index("bufferView", buffers_.view_count(), "buffer view");
    if (!view && !object.has("uri")) object.fail("", "has neither a uri nor a bufferView");
    std::vector<std::byte> file;
    if (!view) file = document_.resource(object);
    const std::span<const std::byte> bytes =
        view ? buffers_.view(*view).bytes : std::span<const std::byte>(file);
    const std::string name = object.text("name", object.text("uri").substr(0, 80));
    DecodedImage decoded;
    try {
        decoded = decode_rgba8(bytes, name);
    } catch (const Error& error) {
        object.fail("", error.what());
    }
    document_.charge(decoded.rgba.size(), object);
    TextureImage image;
    image.name = object.text("name", object.text("uri").starts_with("data:") ? "" : object.text("uri"));
    image.width = decoded.width;
    image.height = decoded.height;
    image.rgba = std::move(decoded.rgba);
    const auto result = static_cast<std::uint32_t>(scene_.images.size());
    scene_.images.push_back(std::move(image));
    scene_images_.emplace(index, result);
    return result;
}

} // namespace ajar::gltf
