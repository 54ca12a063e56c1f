// Doors between rooms: who may include whom, and which room alone knows a third-party library.
#include "tree.hpp"

#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>

namespace ajar::test {
namespace {

namespace fs = std::filesystem;

// A room under host/ and the rooms whose headers it may include, besides its own. Arrows go down only.
const std::map<std::string, std::set<std::string>> DOORS = {
    {"base", {}},
    {"image", {"base"}},
    {"scene", {"base"}},
    {"bvh", {"base"}},
    {"gpu", {"base"}},
    {"import", {"scene", "image", "base"}},
    {"export", {"scene", "image", "base"}},
    {"render", {"bvh", "gpu", "scene", "image", "base"}},
    {"radiosity", {"render", "bvh", "gpu", "scene", "image", "base"}},
    {"bake", {"radiosity", "render", "gpu", "scene", "image", "base"}},
    {"ajar",
     {"import", "export", "bake", "radiosity", "render", "bvh", "gpu", "scene", "image", "base"}},
    {"cli", {"ajar", "import", "bake", "radiosity", "render", "scene", "image", "base"}},
    {"serve", {"ajar", "import", "radiosity", "render", "scene", "image", "base"}},
};

std::string first_component(const std::string& path) { return path.substr(0, path.find('/')); }

std::string room_of(const TreeFile& file) {
    return first_component(file.path.substr(std::string("host/").size()));
}

TEST(Doors, RoomsIncludeOnlyWhatTheTableAllows) {
    std::size_t seen = 0;
    for (const TreeFile& file : read_tree()) {
        if (!file.under("host") || !file.is_cpp()) continue;
        const std::string room = room_of(file);
        ASSERT_TRUE(DOORS.contains(room)) << file.path << ": a room that the table of doors lacks";
        for (const Include& include : includes_of(file)) {
            const std::string target = first_component(include.name);
            if (include.system || !DOORS.contains(target) || include.name.find('/') == std::string::npos)
                continue;
            ++seen;
            EXPECT_TRUE(target == room || DOORS.at(room).contains(target))
                << place(file, include.line) << room << " may not include " << include.name;
        }
    }
    EXPECT_GT(seen, 100u) << "this test no longer finds the includes";
}

TEST(Doors, RoomsIncludeByRoomAndName) {
    // "room/name.hpp", so that a reader and a grep know the room. Headers that the build writes have no room.
    for (const TreeFile& file : read_tree()) {
        if (!file.under("host") || !file.is_cpp()) continue;
        for (const Include& include : includes_of(file)) {
            if (include.system || include.name.find('/') == std::string::npos) continue;
            const fs::path from = include.name.starts_with("shaders/") ? tree_root() : tree_root() / "host";
            if (!DOORS.contains(first_component(include.name)) && from != tree_root())
                continue; // a library's
            EXPECT_TRUE(fs::exists(from / include.name)) << place(file, include.line) << include.name;
        }
    }
}

TEST(Doors, TheHostSeesOnlySharedStructsAndKernelArguments) {
    static const std::regex allowed(R"(shaders/(shared|kernels)/\w+\.glsl\.h)");
    std::size_t seen = 0;
    for (const TreeFile& file : read_tree()) {
        if (!file.under("host") || !file.is_cpp()) continue;
        for (const Include& include : includes_of(file)) {
            if (include.name.find("shaders/") == std::string::npos) continue;
            ++seen;
            EXPECT_TRUE(std::regex_match(include.name, allowed)) << place(file, include.line) << include.name;
        }
    }
    EXPECT_GT(seen, 10u) << "this test no longer finds the includes";
}

TEST(Doors, ShadersIncludeOnlyShaders) {
    std::size_t seen = 0;
    for (const TreeFile& file : read_tree()) {
        if (!file.under("shaders") || !file.is_shader()) continue;
        for (const Include& include : includes_of(file)) {
            ++seen;
            // dual.glsl.h gives C++ its integers and vectors; nothing else knows of C++.
            if (include.system && file.path == "shaders/shared/dual.glsl.h") continue;
            const fs::path target = (fs::path(file.folder()) / include.name).lexically_normal();
            EXPECT_TRUE(!include.system && *target.begin() == "shaders" && fs::exists(tree_root() / target))
                << place(file, include.line) << include.name << " is no shader";
        }
    }
    EXPECT_GT(seen, 100u) << "this test no longer finds the includes";
}

TEST(Doors, SharedHeadersIncludeOnlySharedHeaders) {
    for (const TreeFile& file : read_tree()) {
        if (!file.under("shaders/shared") || !file.is_shader()) continue;
        for (const Include& include : includes_of(file))
            EXPECT_TRUE(include.system || include.name.find('/') == std::string::npos)
                << place(file, include.line) << include.name;
    }
}

struct Library {
    const char* name;
    const char* include; // as a pattern
    std::vector<std::string> rooms;
};

// Where a library may be included; its room's own tests may too.
const Library LIBRARIES[] = {
    {"Vulkan", "(vulkan|vk_video)/.*", {"host/gpu"}},
    {"glslang", "(glslang|SPIRV|spirv-tools)/.*", {"host/gpu"}},
    {"OpenImageIO", "(OpenImageIO|OpenEXR|Imath)/.*", {"host/image", "tests/unit/image"}},
    {"libpng and libwebp", "(png|webp/.*)\\.h", {"host/image", "tests/unit/image"}},
    {"tinygltf", "tiny_gltf\\.h", {"host/import"}},
    {"Draco", "draco/.*", {"host/import", "tests/unit/import"}},
    {"meshoptimizer", "meshoptimizer\\.h", {"host/import", "tests/unit/import"}},
    {"oneTBB", "(tbb|oneapi)/.*", {"host/bvh", "host/render", "tests/unit/bvh", "tests/unit/render"}},
    {"CLI11", "CLI/.*", {"host/cli", "tests/bench"}},
    {"cpp-httplib", "httplib\\.h", {"host/serve"}},
    {"Embree", "embree[34]?/.*", {"tests/bench"}},
    {"Google Benchmark", "benchmark/.*", {"tests/bench"}},
    {"XXH3", "xxhash\\.h", {"host/base"}},
};

TEST(Doors, ALibraryIsKnownInItsRoomAlone) {
    const std::vector<TreeFile> tree = read_tree();
    for (const Library& library : LIBRARIES) {
        const std::regex pattern(library.include);
        for (const TreeFile& file : tree) {
            if (!file.is_cpp()) continue;
            for (const Include& include : includes_of(file)) {
                if (!std::regex_match(include.name, pattern)) continue;
                bool allowed = false;
                for (const std::string& room : library.rooms) allowed = allowed || file.under(room);
                EXPECT_TRUE(allowed) << place(file, include.line) << library.name << " outside its room";
            }
        }
    }
}

TEST(Doors, VulkanStaysInTheGpuRoom) {
    const std::regex vulkan(R"(\bvk::|\bvk[A-Z]\w*\(|\bVk[A-Z])");
    std::size_t inside = 0;
    for (const TreeFile& file : read_tree()) {
        if (!file.is_cpp()) continue;
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            if (!std::regex_search(file.lines[i], vulkan)) continue;
            if (file.under("host/gpu")) ++inside;
            if (file.under("tests/house")) continue; // this pattern
            EXPECT_TRUE(file.under("host/gpu")) << place(file, i + 1) << file.lines[i];
        }
    }
    EXPECT_GT(inside, 20u) << "this test no longer finds Vulkan";
}

TEST(Doors, TheLibraryNeverPrintsExitsOrReadsTheEnvironment) {
    const std::regex forbidden(R"(std::(cout|cerr|clog|exit|abort|quick_exit|getenv)\b|fmt::print\b)"
                               R"(|\b(f?printf|puts|getenv|setenv|exit|_exit)\()");
    std::size_t in_programs = 0;
    for (const TreeFile& file : read_tree()) {
        if (!file.under("host") || !file.is_cpp()) continue;
        const bool program = file.under("host/cli") || file.under("host/serve");
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            const std::string code = file.lines[i].substr(0, file.lines[i].find("//"));
            if (!std::regex_search(code, forbidden)) continue;
            if (program) ++in_programs;
            EXPECT_TRUE(program) << place(file, i + 1) << file.lines[i];
        }
    }
    EXPECT_GT(in_programs, 0u) << "even main is silent: this test no longer finds prints";
}

} // namespace
} // namespace ajar::test
