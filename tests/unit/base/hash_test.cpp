// content_hash against the values that XXH3's author publishes, and its sensitivity.
#include "base/hash.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string_view>
#include <vector>

namespace ajar {
namespace {

std::string hash_of(std::string_view text) { return content_hash(std::as_bytes(std::span(text))); }

TEST(ContentHash, OfNothingIsXxh3sOwn) {
    // XXH3_128bits of no bytes with seed 0, as `xxh128sum /dev/null` prints it.
    EXPECT_EQ(hash_of(""), "99aa06d3014798d86001c324468d497f");
}

TEST(ContentHash, IsThirtyTwoLowerCaseDigits) {
    for (const char* text : {"", "a", "Ajar", "a somewhat longer text, beyond sixteen bytes"}) {
        EXPECT_EQ(hash_of(text).size(), 32u);
        EXPECT_EQ(hash_of(text).find_first_not_of("0123456789abcdef"), std::string::npos) << hash_of(text);
    }
}

TEST(ContentHash, ChangesWithEveryBitAndWithTheLength) {
    // The lengths where XXH3 changes its method, and their neighbours.
    std::set<std::string> seen;
    std::size_t count = 0;
    for (const std::size_t length : {1u, 3u, 8u, 9u, 16u, 17u, 128u, 129u, 240u, 241u, 1025u}) {
        std::vector<std::byte> bytes(length);
        seen.insert(content_hash(bytes));
        ++count;
        for (std::size_t i = 0; i < length; i += 7) {
            for (unsigned bit = 0; bit < 8; ++bit) {
                bytes[i] = std::byte(1u << bit);
                seen.insert(content_hash(bytes));
                ++count;
            }
            bytes[i] = std::byte(0);
        }
    }
    EXPECT_EQ(seen.size(), count);
}

} // namespace
} // namespace ajar
