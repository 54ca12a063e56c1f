// The source tree as the house's tests see it: every text file that people write, in lines.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ajar::test {

struct TreeFile {
    std::string path; // from the root of the tree, with '/'
    std::vector<std::string> lines;

    bool under(std::string_view folder) const; // "host/gpu": anywhere below it
    bool ends_with(std::string_view suffix) const { return std::string_view(path).ends_with(suffix); }
    bool is_cpp() const { return ends_with(".cpp") || ends_with(".hpp"); }
    bool is_shader() const { return ends_with(".comp") || ends_with(".glsl") || ends_with(".glsl.h"); }
    bool is_markdown() const { return ends_with(".md"); }
    std::string stem() const; // name up to its first dot
    std::string folder() const;
};

std::filesystem::path tree_root();

// Files of the house's folders and of its root: C++, GLSL, CMake, Python, scripts, Markdown. Sorted by path.
std::vector<TreeFile> read_tree();

// What a file includes: as written, with the line. `system`: in angle brackets.
struct Include {
    std::string name;
    std::size_t line = 0;
    bool system = false;
};
std::vector<Include> includes_of(const TreeFile& file);

// "path:line: ", as compilers print it.
std::string place(const TreeFile& file, std::size_t line);

} // namespace ajar::test
