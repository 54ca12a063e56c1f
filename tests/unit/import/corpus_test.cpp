// Real files and broken ones, where a folder with them lies beside the project; skipped elsewhere.
#include "base/error.hpp"
#include "import/import.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <vector>

namespace ajar {
namespace {

namespace fs = std::filesystem;

const fs::path CORPUS = fs::path(AJAR_SOURCE_DIR).parent_path() / "shared" / "corpus";

std::vector<fs::path> files_in(const fs::path& folder) {
    std::vector<fs::path> files;
    if (!fs::exists(folder)) return files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".gltf" || entry.path().extension() == ".glb")
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

bool is_hostile(const fs::path& path) { return path.parent_path().filename() == "hostile"; }

TEST(Corpus, EveryRealFileIsRead) {
    const std::vector<fs::path> files = files_in(CORPUS);
    if (files.empty()) GTEST_SKIP() << "no corpus beside the project";
    for (const fs::path& file : files) {
        if (is_hostile(file)) continue;
        SCOPED_TRACE(file.string());
        ImportResult result;
        ASSERT_NO_THROW(result = import_gltf(file));
        EXPECT_FALSE(result.scene.instances.empty());
        EXPECT_FALSE(result.scene.cameras.empty());
        const Bounds bounds = scene_bounds(result.scene);
        EXPECT_GT(glm::length(bounds.upper - bounds.lower), 0.01f);
        EXPECT_LT(glm::length(bounds.upper - bounds.lower), 1e5f);
        for (const Mesh& mesh : result.scene.meshes)
            for (const glm::vec3& n : mesh.normals) ASSERT_NEAR(glm::length(n), 1, 1e-4f);
    }
}

// The file says how many indices each primitive has; lists of triangles must come out whole.
TEST(Corpus, TrianglesAreAllThere) {
    const fs::path file = CORPUS / "morph-stress-test" / "MorphStressTest.gltf";
    if (!fs::exists(file)) GTEST_SKIP() << "no corpus beside the project";
    nlohmann::json json;
    std::ifstream(file) >> json;
    std::size_t expected = 0;
    for (const auto& mesh : json["meshes"])
        for (const auto& primitive : mesh["primitives"])
            expected +=
                json["accessors"][primitive["indices"].get<std::size_t>()]["count"].get<std::size_t>() / 3;
    std::size_t triangles = 0;
    for (const Mesh& mesh : import_gltf(file).scene.meshes) triangles += mesh.triangles.size();
    EXPECT_EQ(triangles, expected);
}

TEST(Corpus, EveryBrokenFileGivesOneLine) {
    const std::vector<fs::path> files = files_in(CORPUS / "hostile");
    if (files.empty()) GTEST_SKIP() << "no corpus beside the project";
    for (const fs::path& file : files) {
        // Its buffer is missing only where the neighbour that has the same name is.
        if (file.filename() == "MissingBin.gltf" && fs::exists(CORPUS / "hostile" / "BoxTextured0.bin"))
            continue;
        SCOPED_TRACE(file.string());
        try {
            import_gltf(file);
            ADD_FAILURE() << "was read";
        } catch (const Error& error) {
            const std::string message = error.what();
            EXPECT_EQ(message.find(file.string() + ": "), 0u) << message;
            EXPECT_EQ(message.find('\n'), std::string::npos);
        }
    }
}

} // namespace
} // namespace ajar
