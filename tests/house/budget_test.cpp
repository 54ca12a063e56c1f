// How long files and lines may be. An exception is a row with its argument; a row that is not needed fails.
#include "tree.hpp"

#include <gtest/gtest.h>

#include <map>

namespace ajar::test {
namespace {

constexpr std::size_t FILE_LINES = 300;
constexpr std::size_t KERNEL_LINES = 150;
constexpr std::size_t LINE_CHARACTERS = 110;

const std::map<std::string, std::string> LONG_FILES = {};

const std::map<std::string, std::string> LONG_LINES = {};

// UTF-8 code points.
std::size_t characters(const std::string& line) {
    std::size_t count = 0;
    for (const char c : line)
        if ((static_cast<unsigned char>(c) & 0xc0u) != 0x80u) ++count;
    return count;
}

TEST(Budget, FilesFitIntoTheHead) {
    for (const TreeFile& file : read_tree()) {
        const std::size_t limit = file.ends_with(".comp") ? KERNEL_LINES : FILE_LINES;
        if (LONG_FILES.contains(file.path))
            EXPECT_GT(file.lines.size(), limit) << file.path << ": no exception is needed any more";
        else
            EXPECT_LE(file.lines.size(), limit) << file.path << ": split it by what it does";
    }
}

TEST(Budget, LinesFitOntoTheScreen) {
    for (const TreeFile& file : read_tree()) {
        if (file.is_markdown()) continue; // tables and links
        std::size_t longest = 0;
        std::size_t where = 0;
        for (std::size_t i = 0; i < file.lines.size(); ++i)
            if (characters(file.lines[i]) > longest) longest = characters(file.lines[where = i]);
        if (LONG_LINES.contains(file.path))
            EXPECT_GT(longest, LINE_CHARACTERS) << file.path << ": no exception is needed any more";
        else
            EXPECT_LE(longest, LINE_CHARACTERS) << place(file, where + 1) << file.lines[where];
    }
}

TEST(Budget, ExceptionsNameFilesThatExist) {
    for (const auto* exceptions : {&LONG_FILES, &LONG_LINES})
        for (const auto& [path, argument] : *exceptions) {
            EXPECT_TRUE(std::filesystem::exists(tree_root() / path)) << path;
            EXPECT_GT(argument.size(), 20u) << path << ": argue the exception";
        }
}

} // namespace
} // namespace ajar::test
