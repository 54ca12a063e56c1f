// Files and bytes that other programs made, or broke: textures of every PNG kind, WebP, lies, bombs and
// stumps.
#include "base/file.hpp"
#include "folder.hpp"
#include "image/read.hpp"
#include "image/write.hpp"
#include "pictures.hpp"
#include "png_maker.hpp"

#include <chrono>
#include <cmath>

namespace ajar::test {
namespace {

using Rgba = std::vector<std::uint8_t>;

Rgba decode(const Bytes& bytes) { return decode_rgba8(bytes, "texture").rgba; }

TEST(TextureDecoding, LeavesColourUnmultipliedByAlpha) {
    const Rgba pixels{200, 100, 50, 0, 201, 101, 51, 1, 202, 102, 52, 128, 203, 103, 53, 255};
    EXPECT_EQ(decode(make_png({.width = 2, .height = 2, .samples = pixels})), pixels);
}

TEST(TextureDecoding, RoundsSixteenBitsToEight) {
    const auto rounded = [](std::uint32_t value) { // value / 257, to nearest
        const std::uint8_t high = static_cast<std::uint8_t>(value >> 8),
                           low = static_cast<std::uint8_t>(value & 255);
        return decode(
            make_png({.width = 1, .height = 1, .depth = 16, .color_type = 0, .samples = {high, low}}))[0];
    };
    EXPECT_EQ(rounded(0), 0);
    EXPECT_EQ(rounded(128), 0);
    EXPECT_EQ(rounded(129), 1);
    EXPECT_EQ(rounded(100 * 257 + 128), 100);
    EXPECT_EQ(rounded(100 * 257 + 129), 101);
    EXPECT_EQ(rounded(65535), 255);
}

TEST(TextureDecoding, SpreadsGreyAndPaletteToRgba) {
    EXPECT_EQ(decode(make_png({.width = 2, .height = 1, .color_type = 0, .samples = {7, 250}})),
              (Rgba{7, 7, 7, 255, 250, 250, 250, 255}));
    EXPECT_EQ(decode(make_png({.width = 2, .height = 1, .color_type = 4, .samples = {7, 9, 250, 0}})),
              (Rgba{7, 7, 7, 9, 250, 250, 250, 0}));
    EXPECT_EQ(decode(make_png({.width = 1, .height = 1, .color_type = 2, .samples = {1, 2, 3}})),
              (Rgba{1, 2, 3, 255}));
    const Png palette{.width = 3,
                      .height = 1,
                      .depth = 8,
                      .color_type = 3,
                      .samples = {1, 0, 1},
                      .palette = {10, 20, 30, 40, 50, 60},
                      .transparency = {0, 77}};
    EXPECT_EQ(decode(make_png(palette)), (Rgba{40, 50, 60, 77, 10, 20, 30, 0, 40, 50, 60, 77}));
    EXPECT_EQ(decode(make_png(
                  {.width = 8, .height = 1, .depth = 1, .color_type = 0, .samples = {0b10010000}}))[4 * 3],
              255);
}

TEST(TextureDecoding, ReadsLosslessWebp) {
    // 2 x 2 pixels written by cwebp 1.2.4 -lossless -exact: (200 100 50 128) (10 20 30 255) / (0 0 0 0) (255
    // 255 255 64).
    const std::uint8_t webp[] = {
        0x52, 0x49, 0x46, 0x46, 0x40, 0x00, 0x00, 0x00, 0x57, 0x45, 0x42, 0x50, 0x56, 0x50, 0x38,
        0x4c, 0x33, 0x00, 0x00, 0x00, 0x2f, 0x01, 0x40, 0x00, 0x10, 0x1f, 0x20, 0x10, 0x20, 0x4c,
        0xf8, 0xf2, 0x3f, 0x63, 0x43, 0x48, 0x40, 0xe8, 0xfe, 0xdf, 0x71, 0x8d, 0x90, 0x80, 0x30,
        0x42, 0xf7, 0x7f, 0x25, 0x81, 0x00, 0x21, 0xcd, 0x9a, 0x32, 0x6b, 0x01, 0xf0, 0xab, 0x5d,
        0x06, 0xb2, 0x01, 0xca, 0x54, 0x61, 0x13, 0xd1, 0xff, 0xf8, 0x00, 0x00,
    };
    const auto bytes = std::as_bytes(std::span(webp));
    const DecodedImage image = decode_rgba8(bytes, "webp");
    ASSERT_EQ(image.width, 2u);
    ASSERT_EQ(image.height, 2u);
    EXPECT_EQ(image.rgba, (Rgba{200, 100, 50, 128, 10, 20, 30, 255, 0, 0, 0, 0, 255, 255, 255, 64}));
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_NE(error_of([&] { decode_rgba8(bytes.first(size), "webp"); }), "") << size;
}

TEST(TextureDecoding, RefusesEveryTruncationOfAPngAndAJpeg) {
    const Folder folder;
    const Image image =
        make_image(24, 24, [](std::uint32_t x, std::uint32_t y) { return glm::vec3(x, y, x ^ y) / 32.0f; });
    for (const char* name : {"a.png", "a.jpg"}) {
        write_image(folder / name, image);
        const Bytes whole = read_file(folder / name);
        EXPECT_EQ(decode_rgba8(whole, name).rgba.size(), 24u * 24 * 4);
        // The last bytes of a PNG are IEND's, which no pixel needs.
        const std::size_t needed = whole.size() - (std::string_view(name) == "a.png" ? 20 : 0);
        for (std::size_t size = 0; size < needed; ++size) {
            const std::string error = error_of([&] { decode_rgba8(std::span(whole).first(size), "stump"); });
            ASSERT_EQ(error.substr(0, 6), "stump:") << name << " cut to " << size << " of " << whole.size();
        }
    }
}

TEST(TextureDecoding, RefusesAnImageWithoutPixelsOrOfAnotherKind) {
    const Folder folder;
    EXPECT_NE(error_of([] { decode(make_png({.width = 0, .height = 1, .samples = {}})); }), "");
    EXPECT_NE(error_of([] { decode({}); }), "");
    EXPECT_NE(error_of([] { decode(Bytes(100, std::byte{'x'})); }), "");
    write_image(folder / "a.exr", flat(4, 4, {1, 1, 1}));
    EXPECT_NE(error_of([&] { decode(read_file(folder / "a.exr")); }).find("PNG"), std::string::npos);
}

// A claim of 60000 x 60000 pixels in a progressive JPEG, whose decoder holds the whole image, with nothing
// behind it.
Bytes jpeg_bomb() {
    Bytes out;
    put(out, 0xffd8ffc2, 4);         // start of image, progressive frame
    put(out, 0x001108, 3);           // length 17, 8 bits
    put(out, 0xea60ea60, 4);         // height, width
    put(out, 0x0301110002110003, 8); // three components...
    put(out, 0x1100, 2);
    put(out, 0xffda000c03010002, 8); // a scan
    put(out, 0x000300003f00, 6);
    out.resize(200);
    put(out, 0xffd9, 2); // end of image
    return out;
}

Bytes webp_bomb() {
    Bytes out;
    for (const char c : std::string_view("RIFF\x2a\0\0\0WEBPVP8L\x1d\0\0\0\x2f\xff\xff\xff\x0f", 25))
        out.push_back(static_cast<std::byte>(c));
    out.resize(60);
    return out;
}

TEST(TextureDecoding, RefusesABombByItsHeaderAtOnce) {
    Bytes png = make_png({.width = 60000, .height = 60000, .samples = {}});
    png.resize(100);
    const auto start = std::chrono::steady_clock::now();
    for (const Bytes& bomb : {png, jpeg_bomb(), webp_bomb()}) {
        const std::string error = error_of([&] { decode(bomb); });
        EXPECT_TRUE(error.find("60000 x 60000") != std::string::npos ||
                    error.find("16384 x 16384") != std::string::npos)
            << error;
    }
    const std::string small = error_of(
        [&] { decode_rgba8(make_png({.width = 4, .height = 4, .samples = Rgba(64)}), "texture", 15); });
    EXPECT_NE(small.find("4 x 4"), std::string::npos) << small;
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
}

TEST(TextureDecoding, RefusesASizeThatSoFewBytesCannotHold) {
    // Below the limit of pixels, but deflate cannot pack 192 MB into the few bytes there are.
    const Bytes png = make_png({.width = 8000, .height = 8000, .color_type = 2, .samples = {}});
    const std::string error = error_of([&] { decode(png); });
    EXPECT_NE(error.find("cannot hold"), std::string::npos) << error;
}

TEST(ImageFile, GivesOneLineForWhatIsNoFile) {
    const Folder folder;
    write_file(folder / "empty.exr", "");
    write_file(folder / "text.png", "hello");
    EXPECT_NE(error_of([&] { read_image(folder / "missing.exr"); }).find("no such file"), std::string::npos);
    EXPECT_NE(error_of([&] { read_image(folder.path()); }).find("folder"), std::string::npos);
    EXPECT_NE(error_of([&] { read_image(folder / "empty.exr"); }).find("empty"), std::string::npos);
    EXPECT_NE(error_of([&] { read_image(folder / "text.png"); }).find("text.png"), std::string::npos);
}

TEST(ImageFile, RefusesTruncatedExrAndHdr) {
    const Folder folder;
    const Image image = make_image(50, 50, [](std::uint32_t x, std::uint32_t y) {
        return glm::vec3(glm::dvec3(std::sin(12.9 * x + 78.2 * y) + 1));
    });
    for (const char* name : {"a.exr", "a.hdr"}) {
        write_image(folder / name, image);
        const Bytes whole = read_file(folder / name);
        for (std::size_t size = 1; size < whole.size(); size += size < 50 ? 1 : 29) {
            write_file(folder / "stump", std::span(whole).first(size));
            ASSERT_NE(error_of([&] { read_image(folder / "stump"); }), "") << name << " cut to " << size;
        }
    }
}

TEST(ImageFile, SurvivesFlippedBytes) {
    const Folder folder;
    const Image image = flat(20, 20, {1, 2, 3});
    for (const char* name : {"a.exr", "a.hdr", "a.png", "a.jpg"}) {
        write_image(folder / name, image);
        const Bytes whole = read_file(folder / name);
        constexpr std::byte flips[] = {std::byte{0xff}, std::byte{0x01}, std::byte{0x80}};
        for (std::size_t at = 0; at < std::min<std::size_t>(whole.size(), 700); at += at < 50 ? 1 : 4) {
            Bytes broken = whole;
            broken[at] ^= flips[at % 3];
            write_file(folder / "broken", broken);
            error_of([&] { read_image(folder / "broken"); }); // an Error or pixels, nothing else
        }
    }
}

TEST(ImageFile, RefusesAHugeExrByItsHeaderAtOnce) {
    const Folder folder;
    write_image(folder / "a.exr", flat(4, 4, {1, 1, 1}));
    Bytes bytes = read_file(folder / "a.exr");
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    for (const char* window : {"dataWindow", "displayWindow"}) {
        const std::size_t at = text.find(window) + std::strlen(window) + 1 + std::strlen("box2i") + 1 + 4;
        const std::int32_t corner[] = {0, 0, 2000000000, 2000000000};
        std::memcpy(bytes.data() + at, corner, sizeof corner);
    }
    write_file(folder / "bomb.exr", bytes);
    const auto start = std::chrono::steady_clock::now();
    EXPECT_NE(error_of([&] { read_image(folder / "bomb.exr"); }).find("2000000001 x 2000000001"),
              std::string::npos);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
}

TEST(EnvironmentFile, ClearsNegativeAndRefusesUnboundedRadiance) {
    const Folder folder;
    Image image = flat(3, 2, {1, -2, 3});
    write_image(folder / "a.exr", image);
    const EnvironmentImage environment = read_environment(folder / "a.exr");
    EXPECT_EQ(environment.width, 3u);
    EXPECT_EQ(environment.height, 2u);
    EXPECT_EQ(environment.radiance, std::vector<glm::vec3>(6, glm::vec3(1, 0, 3)));
    for (const float bad : {NAN, INFINITY}) {
        image.layers[0].pixels[4 * 5 + 1] = bad;
        write_image(folder / "b.exr", image, {.exr_floats = ExrFloats::full});
        EXPECT_NE(error_of([&] { read_environment(folder / "b.exr"); }).find("(2, 1)"), std::string::npos);
    }
    write_image(folder / "a.png", flat(2, 2, {1, 1, 1}));
    EXPECT_NE(error_of([&] { read_environment(folder / "a.png"); }).find(".hdr"), std::string::npos);
}

} // namespace
} // namespace ajar::test
