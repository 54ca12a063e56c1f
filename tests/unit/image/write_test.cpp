// Writing pictures and reading them back, in every format.
#include "base/file.hpp"
#include "folder.hpp"
#include "image/read.hpp"
#include "image/srgb.hpp"
#include "image/write.hpp"
#include "pictures.hpp"

#include <chrono>
#include <cmath>
#include <fstream>
#include <random>
#include <thread>

namespace ajar::test {
namespace {

// A beauty layer of noise over nine decades and three further layers.
Image layered(std::uint32_t width, std::uint32_t height) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> stops(-15, 15);
    Image image{width, height, {}, {{"ajar:seed", "7"}, {"ajar:scene", "a, \"quoted\" name"}}, Range::scene};
    image.add("", {"R", "G", "B", "A"});
    image.add("albedo", {"R", "G", "B"});
    image.add("depth", {"Z"});
    image.add("object_id", {"id"});
    image.add("variance", {"R", "G", "B"});
    for (Layer& layer : image.layers)
        for (float& value : layer.pixels) value = std::exp2(stops(random));
    for (float& value : image.find("object_id")->pixels) value = std::floor(value * 100);
    return image;
}

TEST(EncodePng, TexelsComeBackAsTheyAre) {
    std::mt19937 random(3);
    for (const std::uint32_t channels : {1u, 3u, 4u}) {
        std::vector<std::uint8_t> values(std::size_t{7} * 5 * channels);
        for (std::uint8_t& value : values) value = static_cast<std::uint8_t>(random());
        const std::vector<std::byte> png = encode_png(7, 5, channels, values);
        EXPECT_EQ(encode_png(7, 5, channels, values), png);
        const DecodedImage image = decode_rgba8(png, "png");
        ASSERT_EQ(image.width * image.height, 35u);
        for (std::size_t i = 0; i < 35; ++i)
            for (std::size_t c = 0; c < 4; ++c)
                EXPECT_EQ(image.rgba[4 * i + c], c == 3 && channels < 4 ? 255
                                                 : channels == 1        ? values[i]
                                                                        : values[channels * i + c]);
    }
}

TEST(ExrFile, KeepsEveryLayerAndTheMetadataAt32Bits) {
    const Folder folder;
    const Image image = layered(37, 150); // not a multiple of the bands
    write_image(folder / "a.exr", image, {.exr_floats = ExrFloats::full});
    const Image back = read_image(folder / "a.exr");
    ASSERT_EQ(back.width, 37u);
    ASSERT_EQ(back.height, 150u);
    ASSERT_EQ(back.layers.size(), image.layers.size());
    for (const Layer& layer : image.layers) {
        const Layer* other = back.find(layer.name);
        ASSERT_NE(other, nullptr) << layer.name;
        EXPECT_EQ(other->channel_names, layer.channel_names);
        EXPECT_EQ(other->pixels, layer.pixels) << layer.name;
        EXPECT_EQ(other->rounding, 0x1p-24f);
    }
    for (const auto& entry : image.metadata)
        EXPECT_NE(std::find(back.metadata.begin(), back.metadata.end(), entry), back.metadata.end())
            << entry.first;
    EXPECT_EQ(back.metadata.size(), image.metadata.size());
}

TEST(ExrFile, HalfFloatsAreUsedForColoursOnly) {
    const Folder folder;
    const Image image = layered(20, 20);
    write_image(folder / "a.exr", image);
    const Image back = read_image(folder / "a.exr");
    for (const char* name : {"depth", "object_id", "variance"})
        EXPECT_EQ(back.find(name)->pixels, image.find(name)->pixels) << name;
    for (const char* name : {"", "albedo"}) {
        const Layer &from = *image.find(name), &to = *back.find(name);
        EXPECT_EQ(to.rounding, 0x1p-11f);
        EXPECT_NE(to.pixels, from.pixels);
        for (std::size_t i = 0; i < from.pixels.size(); ++i) // absolute term: half's subnormals
            ASSERT_NEAR(to.pixels[i], from.pixels[i], from.pixels[i] * to.rounding + 0x1p-25f)
                << name << " " << i;
    }
}

TEST(ExrFile, CutsOffBeyondTheRangeOfHalfInsteadOfWritingInfinity) {
    const Folder folder;
    write_image(folder / "a.exr", flat(2, 2, {1e9f, -1e9f, 65504.0f}));
    const Image image = read_image(folder / "a.exr");
    EXPECT_EQ(image.layers[0].pixels[0], 65504.0f);
    EXPECT_EQ(image.layers[0].pixels[1], -65504.0f);
    EXPECT_EQ(image.layers[0].pixels[2], 65504.0f);
}

TEST(ExrFile, HasTheSameBytesAtAnotherTime) {
    const Folder folder;
    const Image image = layered(64, 64);
    write_image(folder / "a.exr", image);
    std::this_thread::sleep_for(std::chrono::milliseconds(1100)); // OpenEXR's dates count seconds
    write_image(folder / "b.exr", image);
    const std::vector<std::byte> bytes = read_file(folder / "a.exr");
    EXPECT_EQ(bytes, read_file(folder / "b.exr"));
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    for (const char* word : {"Software", "OpenImageIO"})
        EXPECT_EQ(text.find(word), std::string_view::npos) << word;
}

class EightBitFile : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Formats, EightBitFile, testing::Values("a.png", "a.jpg", "a.jpeg", "a.JPG"));

TEST_P(EightBitFile, ShowsTheToneMappedColourWithinOneStep) {
    const Folder folder;
    const glm::vec3 colors[] = {{0, 0, 0}, {0.5f, 0.5f, 0.5f}, {0.18f, 0.2f, 0.16f}, {1, 1, 1}};
    for (const glm::vec3& color : colors) {
        write_image(folder / GetParam(), flat(16, 16, color));
        const Image back = read_image(folder / GetParam());
        EXPECT_EQ(back.range, Range::display);
        for (std::size_t c = 0; c < 3; ++c) // JPEG rounds twice
            ASSERT_NEAR(255 * srgb_encode(back.layers[0].pixels[c]),
                        255 * srgb_encode(color[static_cast<int>(c)]), 2);
        EXPECT_EQ(back.layers[0].pixels[3], 1);
    }
}

TEST(PngFile, ReadsBackTheExactEightBitValues) {
    const Folder folder;
    const Image ramp = make_image(256, 3, [](std::uint32_t x, std::uint32_t y) {
        glm::vec3 color(0);
        color[static_cast<int>(y)] = srgb_decode(static_cast<float>(x) / 255);
        return color;
    });
    write_image(folder / "a.png", ramp);
    const DecodedImage bytes = decode_rgba8(read_file(folder / "a.png"), "a.png");
    for (std::size_t y = 0; y < 3; ++y)
        for (std::size_t x = 0; x < 256; ++x)
            for (std::size_t c = 0; c < 4; ++c)
                ASSERT_EQ(bytes.rgba[4 * (y * 256 + x) + c], c == 3 ? 255 : c == y ? x : 0) << x << " " << y;
}

TEST(PngFile, KeepsStraightAlphaWhenAsked) {
    const Folder folder;
    Image image = flat(1, 1, {0.25f, 0.125f, 0});
    image.layers[0].pixels[3] = 0.5f; // so the straight colour is 0.5, 0.25, 0
    write_image(folder / "a.png", image, {.alpha = Alpha::keep});
    const DecodedImage bytes = decode_rgba8(read_file(folder / "a.png"), "a.png");
    EXPECT_EQ(bytes.rgba,
              (std::vector<std::uint8_t>{188, 137, 0, 128})); // sRGB of 0.5 and 0.25 (IEC 61966-2-1)
    const Image back = read_image(folder / "a.png");
    EXPECT_NEAR(back.layers[0].pixels[0], 0.25f, 0.005f); // multiplied by alpha again
}

TEST(PngFile, IsOpaqueOverBlackByDefault) {
    const Folder folder;
    Image image = flat(1, 1, {0.25f, 0.25f, 0.25f});
    image.layers[0].pixels[3] = 0.5f;
    write_image(folder / "a.png", image);
    EXPECT_EQ(decode_rgba8(read_file(folder / "a.png"), "a.png").rgba,
              (std::vector<std::uint8_t>{137, 137, 137, 255}));
}

TEST(PngFile, HasTheSameBytesAtAnotherTime) {
    const Folder folder;
    for (const char* name : {"a.png", "a.jpg", "a.hdr"}) write_image(folder / name, layered(16, 16));
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    for (const char* name : {"a.png", "a.jpg", "a.hdr"}) {
        const std::vector<std::byte> before = read_file(folder / name);
        write_image(folder / name, layered(16, 16));
        EXPECT_EQ(before, read_file(folder / name)) << name;
    }
}

TEST(HdrFile, KeepsRadianceToTheEightBitsOfItsMantissa) {
    const Folder folder;
    const Image image = layered(40, 70);
    write_image(folder / "a.hdr", image);
    const Image back = read_image(folder / "a.hdr");
    const Layer &from = image.layers[0], &to = back.layers[0];
    for (std::size_t i = 0; i < image.pixel_count(); ++i) {
        const float peak = std::max({from.pixels[4 * i], from.pixels[4 * i + 1], from.pixels[4 * i + 2]});
        for (std::size_t c = 0; c < 3; ++c) // a step of the shared exponent is at most peak / 128
            ASSERT_NEAR(to.pixels[4 * i + c], from.pixels[4 * i + c], peak / 128) << i;
    }
}

TEST(HdrFile, TurnsWhatItCannotHoldIntoWhatItCan) {
    const Folder folder;
    write_image(folder / "a.hdr", flat(16, 2, {-1, NAN, INFINITY}));
    const Image back = read_image(folder / "a.hdr");
    EXPECT_EQ(back.layers[0].pixels[0], 0);
    EXPECT_EQ(back.layers[0].pixels[1], 0);
    EXPECT_GT(back.layers[0].pixels[2], 1e37f);
    EXPECT_TRUE(std::isfinite(back.layers[0].pixels[2]));
}

TEST(OutputName, IsRefusedBeforeTheWorkIsDone) {
    const Folder folder;
    std::filesystem::create_directory(folder / "folder.png");
    EXPECT_EQ(error_of([&] { check_output_name(folder / "a.png"); }), "");
    EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
    EXPECT_TRUE(std::filesystem::is_empty(folder / "folder.png"));
    const std::string unknown = error_of([&] { check_output_name(folder / "a.tiff"); });
    for (const char* known : {".tiff", ".exr", ".png", ".jpg", ".jpeg", ".hdr"})
        EXPECT_NE(unknown.find(known), std::string::npos) << unknown;
    EXPECT_NE(error_of([&] { check_output_name(folder / "a"); }), "");
    EXPECT_NE(error_of([&] { check_output_name(folder / "none/a.png"); }).find("none"), std::string::npos);
    EXPECT_NE(error_of([&] { check_output_name(folder / "folder.png"); }).find("folder"), std::string::npos);
}

TEST(OutputFile, SurvivesAFailedWriteOverIt) {
    const Folder folder;
    write_image(folder / "a.png", flat(4, 4, {1, 0, 0}));
    const std::vector<std::byte> before = read_file(folder / "a.png");
    Image no_beauty{4, 4, {}, {}, Range::scene};
    no_beauty.add("albedo", {"R", "G", "B"});
    EXPECT_NE(error_of([&] { write_image(folder / "a.png", no_beauty); }).find("'albedo'"),
              std::string::npos);
    EXPECT_EQ(read_file(folder / "a.png"), before);
    EXPECT_NE(error_of([&] { write_image(folder / "empty.exr", Image{}); }), "");
    EXPECT_FALSE(std::filesystem::exists(folder / "empty.exr"));
}

} // namespace
} // namespace ajar::test
