// What the README promises: its commands run, its program builds against an installed Ajar and makes the
// image, its links lead somewhere; and the set-up script says what it needs where it cannot install.
#include "cli/run_ajar.hpp"
#include "image/read.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <regex>

namespace ajar::test {

namespace {

namespace fs = std::filesystem;

std::string readme() { return read_text(fs::path(AJAR_SOURCE_DIR) / "README.md"); }

// The first block fenced as ```LANGUAGE.
std::string code_block(const std::string& text, const std::string& language) {
    const std::string fence = "```" + language + "\n";
    const std::size_t begin = text.find(fence);
    if (begin == std::string::npos) return {};
    return text.substr(begin + fence.size(), text.find("```", begin + fence.size()) - begin - fence.size());
}

// A folder that looks like the clone that the README speaks of, in which files may be written.
void link_scenes(const TemporaryFolder& folder) {
    fs::create_directory_symlink(fs::path(AJAR_SOURCE_DIR) / "scenes", folder / "scenes");
}

Result expect_success(const std::vector<std::string>& command, const Surroundings& surroundings = {}) {
    Result result = run(command, surroundings);
    EXPECT_EQ(result.exit_code, 0) << command[0] << " " << command[1] << "\n" << result.out << result.err;
    return result;
}

} // namespace

TEST(Readme, EveryCommandRuns) {
    const TemporaryFolder folder;
    link_scenes(folder);
    Surroundings surroundings;
    surroundings.folder = folder.path();
    surroundings.environment["PATH"] =
        fs::path(AJAR_COMMAND).parent_path().string() + ":" + std::getenv("PATH");
    int count = 0;
    for (std::string line : lines(code_block(readme(), "sh"))) {
        const bool solves = line.starts_with("ajar radiosity ");
        const bool shows = solves || line.starts_with("ajar render ");
        if (shows) line += " --size 24x16 --samples 2"; // the last ones count
        if (solves) line += " --patches 100";
        if (line.starts_with("ajar bake ")) line += " --lightmap 64 --samples 2";
        expect_success({"sh", "-c", line}, surroundings);
        ++count;
    }
    EXPECT_GE(count, 5);
}

TEST(Readme, ProgramBuildsOutsideTheTreeAndRenders) {
    const TemporaryFolder folder;
    link_scenes(folder);
    const fs::path prefix = folder / "prefix", project = folder / "project", build = folder / "build";
    expect_success({AJAR_CMAKE, "--install", AJAR_BUILD_DIR, "--prefix", prefix.string()});
    EXPECT_TRUE(fs::exists(prefix / "bin/ajar"));
    EXPECT_EQ(run({(prefix / "bin/ajar").string(), "--version"}).out, "ajar " AJAR_VERSION "\n");

    fs::create_directory(project);
    const std::string program = code_block(readme(), "cpp");
    EXPECT_LE(lines(program).size(), 12u) << "ten lines or so, says the README";
    write_text(project / "program.cpp", program);
    write_text(project / "CMakeLists.txt",
               "cmake_minimum_required(VERSION 3.22)\nproject(outside CXX)\n"
               "set(CMAKE_CXX_EXTENSIONS OFF)\nadd_executable(program program.cpp)\n" +
                   code_block(readme(), "cmake"));
    expect_success({AJAR_CMAKE, "-S", project.string(), "-B", build.string(), "-G", AJAR_GENERATOR,
                    "-DCMAKE_CXX_COMPILER=" AJAR_COMPILER, "-DCMAKE_PREFIX_PATH=" + prefix.string(),
                    "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Wshadow -Wconversion -Werror " AJAR_SANITIZER_FLAGS});
    expect_success({AJAR_CMAKE, "--build", build.string()});

    Surroundings surroundings;
    surroundings.folder = folder.path();
    const Result result = expect_success({(build / "program").string(), ""}, surroundings);
    EXPECT_EQ(result.out + result.err, "") << "the library never prints";
    const Image image = read_image(folder / "box.exr");
    EXPECT_EQ(image.width, 128u);
    EXPECT_NE(image.find("variance"), nullptr);
}

TEST(Readme, InstalledHeadersKnowNeitherVulkanNorGlm) {
    const fs::path headers = fs::path(AJAR_BUILD_DIR) / "include/ajar";
    int count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(headers)) {
        if (!entry.is_regular_file()) continue;
        const std::string text = read_text(entry.path());
        EXPECT_EQ(text.find("#include \""), std::string::npos) << entry.path();
        EXPECT_EQ(text.find("#include <glm"), std::string::npos) << entry.path();
        EXPECT_EQ(text.find("#include <vulkan"), std::string::npos) << entry.path();
        ++count;
    }
    EXPECT_GE(count, 8);
}

TEST(Readme, LinksAndFoldersExist) {
    for (const char* file : {"README.md", "CONTRIBUTING.md"}) {
        const std::string text = read_text(fs::path(AJAR_SOURCE_DIR) / file);
        const std::regex link(R"(\]\(([^):#]+)\))"), room(R"(\n\| `([a-z/]+)` \|)");
        for (const std::regex& pattern : {link, room})
            for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it)
                EXPECT_TRUE(fs::exists(fs::path(AJAR_SOURCE_DIR) / (*it)[1].str()))
                    << file << ": " << (*it)[1];
    }
}

TEST(Setup, WithoutAptItNamesThePackagesAndStops) {
    const TemporaryFolder folder;
    for (const char* tool : {"sh", "dirname", "cat", "id"}) {
        const std::string where = run({"sh", "-c", std::string("command -v ") + tool}).out;
        fs::create_symlink(where.substr(0, where.find('\n')), folder / tool);
    }
    Surroundings elsewhere;
    elsewhere.environment["PATH"] = folder.path().string();
    for (const char* script : {"quickstart", "check"}) {
        const Result result =
            run({"/bin/sh", (fs::path(AJAR_SOURCE_DIR) / "cmake" / script).string()}, elsewhere);
        EXPECT_EQ(result.exit_code, 1) << result.out;
        for (const char* package : {"cmake", "libvulkan-dev", "libdraco-dev", "libopenimageio-dev"})
            EXPECT_NE(result.err.find(package), std::string::npos) << package << "\n" << result.err;
    }
}

} // namespace ajar::test
