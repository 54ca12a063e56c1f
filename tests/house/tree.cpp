#include "tree.hpp"

#include <algorithm>
#include <fstream>
#include <regex>
#include <stdexcept>

namespace ajar::test {

namespace fs = std::filesystem;

namespace {

bool is_text(const fs::path& path) {
    const std::string extension = path.extension().string();
    for (const char* known : {".cpp", ".hpp", ".h", ".comp", ".glsl", ".cmake", ".py", ".md", ".txt"})
        if (extension == known) return true;
    const std::string parent = path.parent_path().filename().string();
    return extension.empty() && (parent == "cmake" || parent == ".ci"); // scripts
}

TreeFile read(const fs::path& path) {
    TreeFile file;
    file.path = path.lexically_relative(tree_root()).generic_string();
    std::ifstream stream(path);
    if (!stream) throw std::runtime_error("cannot read " + path.string());
    for (std::string line; std::getline(stream, line);) file.lines.push_back(line);
    return file;
}

} // namespace

bool TreeFile::under(std::string_view folder) const {
    return path.size() > folder.size() && path.compare(0, folder.size(), folder) == 0 &&
           path[folder.size()] == '/';
}

std::string TreeFile::stem() const {
    const std::string name = fs::path(path).filename().string();
    return name.substr(0, name.find('.'));
}

std::string TreeFile::folder() const { return fs::path(path).parent_path().generic_string(); }

fs::path tree_root() { return AJAR_SOURCE_DIR; }

std::vector<TreeFile> read_tree() {
    std::vector<TreeFile> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(tree_root()))
        if (entry.is_regular_file() && is_text(entry.path())) files.push_back(read(entry.path()));
    for (const char* folder : {"host", "shaders", "scenes", "tests", "cmake", ".ci"}) {
        if (!fs::is_directory(tree_root() / folder)) continue;
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(tree_root() / folder))
            if (entry.is_regular_file() && is_text(entry.path())) files.push_back(read(entry.path()));
    }
    std::sort(files.begin(), files.end(),
              [](const TreeFile& a, const TreeFile& b) { return a.path < b.path; });
    return files;
}

std::vector<Include> includes_of(const TreeFile& file) {
    static const std::regex directive(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
    std::vector<Include> includes;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
        std::smatch match;
        if (std::regex_search(file.lines[i], match, directive))
            includes.push_back({match[2].str(), i + 1, match[1].str() == "<"});
    }
    return includes;
}

std::string place(const TreeFile& file, std::size_t line) {
    return file.path + ":" + std::to_string(line) + ": ";
}

} // namespace ajar::test
