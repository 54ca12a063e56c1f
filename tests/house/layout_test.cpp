// What belongs where, what must be beside it, and what must not be anywhere.
#include "tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>

namespace ajar::test {
namespace {

namespace fs = std::filesystem;

// Expects that no line of the files that `concerns` picks matches. This folder names what it forbids.
template <class Concerns> void expect_nowhere(const std::regex& pattern, Concerns concerns, const char* why) {
    for (const TreeFile& file : read_tree()) {
        if (file.under("tests/house") || !concerns(file)) continue;
        for (std::size_t i = 0; i < file.lines.size(); ++i)
            EXPECT_FALSE(std::regex_search(file.lines[i], pattern))
                << place(file, i + 1) << why << file.lines[i];
    }
}

bool any_file(const TreeFile&) { return true; }

TEST(Layout, TheRootHasItsPages) {
    for (const char* name :
         {"README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "CHANGELOG.md", "LICENSE", "CMakeLists.txt",
          "CMakePresets.json", ".ci/run", "cmake/quickstart", "cmake/check"})
        EXPECT_TRUE(fs::is_regular_file(tree_root() / name)) << name;
    EXPECT_FALSE(fs::exists(tree_root() / "docs")) << "a room's chapter is its README.md";
}

TEST(Layout, EveryRoomHasItsChapter) {
    for (const char* name : {"host", "shaders", "scenes", "tests"})
        EXPECT_TRUE(fs::is_regular_file(tree_root() / name / "README.md")) << name;
    for (const fs::directory_entry& room : fs::directory_iterator(tree_root() / "host"))
        if (room.is_directory()) {
            EXPECT_TRUE(fs::is_regular_file(room.path() / "README.md")) << room.path();
        }
}

TEST(Layout, AFileOpensWithWhatItIsFor) {
    // A .cpp beside a header of the same name leaves that to the header.
    const std::vector<TreeFile> tree = read_tree();
    std::set<std::string> headers;
    for (const TreeFile& file : tree)
        if (file.ends_with(".hpp")) headers.insert(file.path.substr(0, file.path.size() - 4));
    for (const TreeFile& file : tree) {
        if (!file.is_cpp() && !file.is_shader()) continue;
        if (file.ends_with(".cpp") && headers.contains(file.path.substr(0, file.path.size() - 4))) continue;
        ASSERT_FALSE(file.lines.empty()) << file.path;
        EXPECT_TRUE(file.lines[0].starts_with("// ")) << file.path << " opens with: " << file.lines[0];
    }
}

TEST(Layout, HeadersAreGuarded) {
    const auto is_guard = [](const std::string& line) { return line.starts_with("#ifndef AJAR_"); };
    for (const TreeFile& file : read_tree()) {
        if (file.ends_with(".hpp")) {
            EXPECT_EQ(std::count(file.lines.begin(), file.lines.end(), "#pragma once"), 1) << file.path;
        }
        if (file.ends_with(".glsl") || file.ends_with(".glsl.h")) {
            EXPECT_TRUE(std::any_of(file.lines.begin(), file.lines.end(), is_guard)) << file.path;
        }
    }
}

TEST(Layout, NamesSayWhatIsInside) {
    static const std::regex empty_words(
        "(^|_)(util|utils|utility|helper|helpers|manager|misc|common|stuff)(_|$)");
    static const std::regex snake_case("[a-z0-9_]+");
    for (const TreeFile& file : read_tree()) {
        EXPECT_FALSE(std::regex_search(file.stem(), empty_words)) << file.path;
        if (file.is_cpp() || file.is_shader()) {
            EXPECT_TRUE(std::regex_match(file.stem(), snake_case)) << file.path;
        }
    }
}

TEST(Layout, NothingIsLeftForLater) {
    expect_nowhere(std::regex(R"(\b(TODO|FIXME|XXX|HACK)\b)"), any_file, "");
}

TEST(Layout, NoFileKnowsAPlaceOfOneMachine) {
    expect_nowhere(std::regex(R"((^|[^\w.])/(work|tmp|root|mnt|Users)/\w)"), any_file,
                   "a path of one machine: ");
}

std::string upper_camel(const std::string& snake) {
    std::string camel;
    bool up = true;
    for (const char c : snake) {
        if (c != '_') camel += up ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
        up = c == '_';
    }
    return camel;
}

TEST(Layout, AKernelIsItsCodeAndItsArguments) {
    const std::vector<TreeFile> tree = read_tree();
    std::map<std::string, const TreeFile*> arguments;
    std::set<std::string> kernels;
    for (const TreeFile& file : tree)
        if (file.under("shaders/kernels")) {
            if (file.ends_with(".glsl.h")) arguments[file.stem()] = &file;
            if (file.ends_with(".comp")) kernels.insert(file.stem());
        }
    EXPECT_GE(kernels.size(), 5u);
    for (const std::string& kernel : kernels) {
        ASSERT_TRUE(arguments.contains(kernel)) << kernel << ".comp has no " << kernel << ".glsl.h beside it";
        const std::string name = "struct " + upper_camel(kernel) + "Args {";
        const std::vector<std::string>& lines = arguments[kernel]->lines;
        EXPECT_TRUE(std::find(lines.begin(), lines.end(), name) != lines.end())
            << kernel << ".glsl.h: no " << name;
    }
    for (const auto& [stem, file] : arguments)
        EXPECT_TRUE(kernels.contains(stem)) << file->path << " has no kernel";
}

TEST(Layout, KernelsHaveNoVariantsButDebug) {
    static const std::regex directive(R"(^\s*#\s*(if|ifdef|ifndef|elif)\b\s*(.*))");
    for (const TreeFile& file : read_tree()) {
        if (!file.under("shaders") || !(file.ends_with(".comp") || file.ends_with(".glsl"))) continue;
        bool guard_seen = file.ends_with(".comp");
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            std::smatch match;
            if (!std::regex_match(file.lines[i], match, directive)) continue;
            if (!guard_seen && match[1] == "ifndef") {
                guard_seen = true;
                continue;
            }
            // AJAR_SUBGROUP: an #extension cannot be specialised; only what stands in for it may ask.
            const bool subgroup = match[2] == "AJAR_SUBGROUP" && !file.ends_with(".comp");
            EXPECT_TRUE(match[2] == "AJAR_DEBUG" || subgroup)
                << place(file, i + 1) << "variants are specialization constants: " << file.lines[i];
        }
    }
}

TEST(Layout, ASharedStructIsWrittenOnceAndItsSizeStated) {
    static const std::regex structure(R"(^struct (\w+) \{)");
    static const std::regex any_definition(R"(^\s*(struct|class) (\w+)\b[^;]*\{?\s*$)");
    const std::vector<TreeFile> tree = read_tree();
    std::map<std::string, std::string> shared;
    for (const TreeFile& file : tree) {
        if (!file.under("shaders") || !file.ends_with(".glsl.h")) continue;
        std::string text;
        for (const std::string& line : file.lines) text += line + "\n";
        for (const std::string& line : file.lines) {
            std::smatch match;
            if (!std::regex_search(line, match, structure)) continue;
            EXPECT_TRUE(shared.emplace(match[1], file.path).second)
                << match[1] << " is in " << file.path << " and in " << shared[match[1]];
            EXPECT_NE(text.find("DUAL_SIZE(" + match[1].str() + ","), std::string::npos)
                << file.path << ": no DUAL_SIZE for " << match[1];
        }
    }
    EXPECT_GT(shared.size(), 15u);
    for (const TreeFile& file : tree) {
        if (!file.under("host") && !file.under("shaders")) continue;
        if (file.is_markdown() || file.ends_with(".glsl.h")) continue;
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            std::smatch match;
            if (std::regex_match(file.lines[i], match, any_definition)) {
                EXPECT_FALSE(shared.contains(match[2]))
                    << place(file, i + 1) << "second definition of " << match[2];
            }
        }
    }
}

} // namespace
} // namespace ajar::test
