// Each scene is complete, small, says what its right answer is, and is what the generator writes.
#include "support/temporary_folder.hpp"
#include "tree.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

namespace ajar::test {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t SCENE_BYTES = 300'000;

std::string bytes_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    EXPECT_TRUE(file) << path;
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::vector<fs::path> scene_folders() {
    std::vector<fs::path> folders;
    for (const fs::directory_entry& entry : fs::directory_iterator(tree_root() / "scenes"))
        if (entry.is_directory() && entry.path().filename() != "__pycache__") folders.push_back(entry.path());
    return folders;
}

TEST(Scenes, AreCompleteAndSmall) {
    static const std::regex uri(R"re("uri":\s*"([^"]+)")re");
    EXPECT_GE(scene_folders().size(), 5u);
    for (const fs::path& folder : scene_folders()) {
        const std::string name = folder.filename().string();
        const std::string gltf = bytes_of(folder / (name + ".gltf"));
        const std::string readme = bytes_of(folder / "README.md");
        std::set<std::string> known = {name + ".gltf", "README.md"};
        for (std::sregex_iterator match(gltf.begin(), gltf.end(), uri), end; match != end; ++match) {
            const std::string file = (*match)[1];
            if (file.starts_with("data:")) continue;
            known.insert(file);
            EXPECT_TRUE(fs::is_regular_file(folder / file)) << folder << " lacks " << file;
        }
        std::uintmax_t total = 0;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
            const std::string file = entry.path().filename().string();
            total += entry.file_size();
            EXPECT_TRUE(known.contains(file) || readme.find(file) != std::string::npos)
                << entry.path() << ": neither scene nor README speaks of it";
        }
        EXPECT_LE(total, SCENE_BYTES) << folder;
    }
}

TEST(Scenes, SayWhatIsRight) {
    for (const fs::path& folder : scene_folders()) {
        const std::string readme = bytes_of(folder / "README.md");
        for (const char* part : {"# ", "**Right answer:**", "**Made by**", "**Licence:**"})
            EXPECT_NE(readme.find(part), std::string::npos) << folder << ": its README lacks " << part;
    }
    const std::string index = bytes_of(tree_root() / "scenes" / "README.md");
    for (const fs::path& folder : scene_folders()) {
        std::string link("](");
        link.append(folder.filename().string()).append(")");
        EXPECT_NE(index.find(link), std::string::npos)
            << "scenes/README.md does not list " << folder.filename();
    }
}

TEST(Scenes, AreWhatTheGeneratorWrites) {
    if (std::system("command -v python3 >/dev/null 2>&1") != 0) GTEST_SKIP() << "no python3 here";
    const TemporaryFolder fresh;
    const std::string command = "python3 '" + (tree_root() / "scenes" / "generate.py").string() +
                                "' --into '" + fresh.path().string() + "'";
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
    std::size_t compared = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(fresh.path())) {
        if (!entry.is_regular_file()) continue;
        const fs::path name = entry.path().lexically_relative(fresh.path());
        EXPECT_TRUE(bytes_of(entry.path()) == bytes_of(tree_root() / "scenes" / name))
            << name << " differs: run scenes/generate.py and commit both";
        ++compared;
    }
    EXPECT_GE(compared, 3 * scene_folders().size());
}

} // namespace
} // namespace ajar::test
