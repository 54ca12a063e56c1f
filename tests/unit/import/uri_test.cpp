// URIs: what they decode to and which are refused.
#include "import/uri.hpp"

#include "base/error.hpp"

#include <gtest/gtest.h>

namespace ajar::gltf {
namespace {

std::string text_of(std::string_view uri) {
    std::string text;
    for (const std::byte b : decode_data_uri(uri)) text += static_cast<char>(b);
    return text;
}

TEST(GltfUri, DecodesBase64OfEveryPadding) { // RFC 4648, section 10
    EXPECT_EQ(text_of("data:;base64,"), "");
    EXPECT_EQ(text_of("data:;base64,Zg=="), "f");
    EXPECT_EQ(text_of("data:;base64,Zm8="), "fo");
    EXPECT_EQ(text_of("data:;base64,Zm8"), "fo");
    EXPECT_EQ(text_of("data:application/octet-stream;base64,Zm9vYmFy"), "foobar");
}

TEST(GltfUri, RejectsWhatIsNotBase64) {
    EXPECT_THROW(decode_data_uri("data:;base64,Zm9v!mFy"), Error);
    EXPECT_THROW(decode_data_uri("data:;base64,Zm9vY"), Error);
    EXPECT_THROW(decode_data_uri("data:no comma"), Error);
}

TEST(GltfUri, DecodesPercentEncodedData) { EXPECT_EQ(text_of("data:,a%20b%00c"), std::string("a b\0c", 5)); }

TEST(GltfUri, DecodesPercentEscapesAndLeavesBrokenOnes) {
    EXPECT_EQ(percent_decode("a%20b%C3%A9"), "a b\xc3\xa9");
    EXPECT_EQ(percent_decode("100%"), "100%");
    EXPECT_EQ(percent_decode("50%zz%4"), "50%zz%4");
}

TEST(GltfUri, ResolvesRelativePathsAndParents) {
    EXPECT_EQ(resolve_uri("/scenes/a", "b/c%20d.bin"), "/scenes/a/b/c d.bin");
    EXPECT_EQ(resolve_uri("/scenes/a", "../b.bin").lexically_normal(), "/scenes/b.bin");
}

TEST(GltfUri, RefusesAbsolutePathsSchemesAndNothing) {
    for (const char* uri : {"/etc/passwd", "%2Fetc/passwd", "\\\\server\\share", "http://example.org/a.bin",
                            "file:///etc/passwd", "C:/a.bin", "", "a%00b"})
        EXPECT_THROW(resolve_uri("/scenes", uri), Error) << uri;
}

TEST(GltfUri, NeedsAFolderForFiles) { EXPECT_THROW(resolve_uri("", "a.bin"), Error); }

} // namespace
} // namespace ajar::gltf
