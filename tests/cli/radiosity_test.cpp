// ajar radiosity from outside: pictures, report, plots, what it refuses, and what ends it early.
#include "cli/run_ajar.hpp"
#include "cli/small_renders.hpp"
#include "image/read.hpp"
#include "render/render.hpp"
#include "support/temporary_folder.hpp"

#include <cmath>
#include <csignal>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace ajar::test {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

// A tiny Cornell box of a few patches.
std::vector<std::string> radiosity(std::vector<std::string> more) {
    std::vector<std::string> arguments{
        "radiosity", scene_path("cornell-box"), "--size", "24x16", "--samples", "2", "--patches",
        "100",       "--shadow-samples",        "16"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

double mean_of(const fs::path& file) {
    const Image image = read_image(file);
    const Layer& pixels = beauty(image, file.string());
    double sum = 0;
    for (const float value : pixels.pixels) sum += value;
    EXPECT_TRUE(std::isfinite(sum));
    return sum / static_cast<double>(pixels.pixels.size());
}

void expect_refused(const std::vector<std::string>& arguments, const std::string& part, int exit_code) {
    const TemporaryFolder folder;
    Surroundings surroundings;
    surroundings.folder = folder.path();
    const Result result = run_ajar(arguments, surroundings);
    EXPECT_EQ(result.exit_code, exit_code) << result.err;
    EXPECT_NE(result.err.find(part), std::string::npos) << result.err;
    EXPECT_TRUE(lines(result.err).back().starts_with("ajar: error: ")) << result.err;
    EXPECT_TRUE(fs::is_empty(folder.path())) << "half an output";
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

} // namespace

TEST(Radiosity, WritesEveryShading) {
    const TemporaryFolder folder;
    std::vector<double> means;
    for (const Choice& shading : shadings()) {
        const fs::path file = folder / (std::string(shading.name) + ".exr");
        const Result result = run_ajar(radiosity({"-o", file.string(), "--shading", shading.name, "--aov"}));
        ASSERT_EQ(result.exit_code, 0) << result.err;
        EXPECT_NE(read_image(file).find("albedo"), nullptr);
        means.push_back(mean_of(file));
    }
    for (const double mean : means) EXPECT_NEAR(mean / means[0], 1, 0.1) << "the same light";
    const fs::path traced = folder / "path.exr";
    ASSERT_EQ(run_ajar(tiny({"-o", traced.string(), "--samples", "64"})).exit_code, 0);
    EXPECT_NEAR(means[0] / mean_of(traced), 1, 0.1) << "two algorithms";
}

TEST(Radiosity, IsAnIntegratorOfRender) {
    const TemporaryFolder folder;
    const fs::path one = folder / "a.exr", other = folder / "b.exr";
    ASSERT_EQ(run_ajar(radiosity({"-o", one.string()})).exit_code, 0);
    ASSERT_EQ(run_ajar(tiny({"-o", other.string(), "--integrator", "radiosity", "--patches", "100",
                             "--shadow-samples", "16"}))
                  .exit_code,
              0);
    EXPECT_TRUE(read_text(one) == read_text(other));
}

TEST(Radiosity, ReportsWhatItSolved) {
    const TemporaryFolder folder;
    const fs::path file = folder / "a.json", plot = folder / "a.svg", image = folder / "a.exr";
    const Result result = run_ajar(radiosity({"-o", image.string(), "--report", file.string(), "--plot",
                                              plot.string(), "--solver", "jacobi", "--progress", "json"}));
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const Json report = Json::parse(read_text(file));
    EXPECT_EQ(report["settings"]["integrator"], "radiosity");
    EXPECT_EQ(report["settings"]["biased_by"], Json::array({"radiosity"}));
    const Json& solved = report["radiosity"];
    EXPECT_EQ(solved["settings"]["solver"], "jacobi");
    EXPECT_GE(solved["patches"], 100);
    EXPECT_LE(solved["patches"], 110);
    EXPECT_EQ(solved["converged"], true);
    ASSERT_GE(solved["history"].size(), 3u);
    EXPECT_GT(solved["history"][0]["error"], solved["history"].back()["error"]);
    EXPECT_LE(solved["history"].back()["error"], 1e-4);
    for (const auto& [name, value] : read_image(image).metadata)
        if (name == "ajar:settings") {
            EXPECT_EQ(Json::parse(value)["radiosity"]["patches"], 100);
            EXPECT_EQ(value.find("memory"), std::string::npos) << "decides nothing";
        }
    EXPECT_EQ(count(read_text(plot), "<svg"), 1u);
    EXPECT_NE(read_text(plot).find("greatest change"), std::string::npos);

    std::vector<std::string> stages;
    for (const std::string& line : lines(result.out)) {
        const Json event = Json::parse(line);
        if (event["event"] != "progress") continue;
        if (stages.empty() || stages.back() != event["stage"]) stages.push_back(event["stage"]);
    }
    EXPECT_EQ(stages,
              (std::vector<std::string>{"materials", "form factors", "direct light", "solve", "render"}));
}

TEST(Radiosity, PlotsSolversTogether) {
    const TemporaryFolder folder;
    const fs::path plot = folder / "a.svg";
    const Result result = run_ajar(
        radiosity({"-o", (folder / "a.png").string(), "--plot", plot.string(), "--plot-solvers", "all"}));
    ASSERT_EQ(result.exit_code, 0) << result.err;
    for (const char* solver : {"jacobi", "gauss-seidel", "shooting"})
        EXPECT_NE(read_text(plot).find(solver), std::string::npos) << solver;
}

TEST(Radiosity, IsTheSameWhateverTheMemory) {
    const TemporaryFolder folder;
    const fs::path one = folder / "a.exr", other = folder / "b.exr";
    ASSERT_EQ(run_ajar(radiosity({"-o", one.string()})).exit_code, 0);
    ASSERT_EQ(run_ajar(radiosity({"-o", other.string(), "--memory", "0"})).exit_code, 0);
    EXPECT_TRUE(read_text(one) == read_text(other));
}

TEST(Radiosity, RefusesWhatItCannotDo) {
    const std::string box = scene_path("cornell-box");
    for (const auto& [option, value] :
         std::vector<std::pair<std::string, std::string>>{{"--patches", "0"},
                                                          {"--patches", "99999999"},
                                                          {"--patch-size", "0"},
                                                          {"--patch-size", "-1"},
                                                          {"--rays", "100"},
                                                          {"--rays", "2"},
                                                          {"--solver", "luck"},
                                                          {"--direct", "never"},
                                                          {"--shading", "glossy"},
                                                          {"--tolerance", "0"},
                                                          {"--memory", "-1"},
                                                          {"--refine", "-1"},
                                                          {"--max-iterations", "0"},
                                                          {"--integrator", "path"}}) {
        SCOPED_TRACE(option + " " + value);
        expect_refused({"radiosity", box, "-o", "a.png", option, value}, option, 2);
    }
    expect_refused({"radiosity", box, "-o", "a.png", "--plot-solvers", "all"}, "--plot", 2);
    expect_refused({"radiosity", box, "-o", "a.png", "--plot", "a.svg", "--plot-solvers", "jacobi,luck"},
                   "'luck' is none of", 2);
    expect_refused({"radiosity", box}, "-o FILE", 2);
    for (const char* option : {"--patches", "--tolerance", "--rays"})
        expect_refused({"render", box, "-o", "a.png", option, "16"}, option, 2);
    expect_refused({"render", box, "-o", "a.png", "--shading", "flat"}, "only integrator radiosity", 2);
    expect_refused({"radiosity", box, "-o", "a.png", "--patch-size", "1e-5"}, "choose a larger one", 1);
    expect_refused({"radiosity", box, "-o", "a.png", "--plot", "nowhere/a.svg"}, "nowhere/a.svg", 1);
}

TEST(Radiosity, SaysThatThereIsNothingToSolveFor) {
    const TemporaryFolder folder;
    const std::string scene = (folder / "empty.gltf").string();
    write_text(scene, R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[]}]})");
    expect_refused({"radiosity", scene, "-o", "a.png", "--background", "1,1,1"}, "no triangle with an area",
                   1);
}

TEST(Radiosity, LightsADarkSceneByAStudio) {
    const TemporaryFolder folder;
    const fs::path scene = folder / "triangle.gltf", image = folder / "a.exr";
    write_triangle(scene);
    const Result result = run_ajar({"radiosity", scene.string(), "-o", image.string(), "--size", "16x16",
                                    "--samples", "2", "--patches", "9"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.err.find("soft grey studio"), std::string::npos) << result.err;
    EXPECT_GT(mean_of(image), 0.05);
}

TEST(Radiosity, CtrlCShowsTheSolutionSoFar) {
    const TemporaryFolder folder;
    const fs::path image = folder / "a.exr", report = folder / "a.json";
    // Rows that are computed again and again.
    Process process(ajar_command(
        radiosity({"-o", image.string(), "--report", report.string(), "--progress", "json", "--memory", "0",
                   "--patches", "3000", "--rays", "1024", "--tolerance", "1e-7", "--solver", "jacobi"})));
    bool solving = false;
    for (std::string line = process.read_line(); !line.empty() && !solving; line = process.read_line()) {
        const Json event = Json::parse(line);
        solving = event["event"] == "progress" && event["stage"] == "solve" && event["done"] > 0;
    }
    ASSERT_TRUE(solving) << process.finish().err;
    process.send(SIGINT);
    const Result result = process.finish();
    EXPECT_EQ(result.exit_code, 130) << result.err;
    EXPECT_NE(result.err.find("interrupted: the solution after "), std::string::npos) << result.err;
    EXPECT_GT(mean_of(image), 0.01);
    const Json json = Json::parse(read_text(report));
    EXPECT_EQ(json["radiosity"]["interrupted"], true);
    EXPECT_EQ(json["radiosity"]["converged"], false);
    EXPECT_EQ(Json::parse(lines(result.out).back())["interrupted"], true);
}

TEST(Radiosity, IsACaseOfTheLab) {
    const TemporaryFolder folder;
    const fs::path out = folder / "lab";
    const Result result =
        run_ajar(lab(out.string(), {"--samples", "4", "--patches", "60", "--shadow-samples", "4",
                                    "--integrators", "path,radiosity", "--shadings", "flat,gather"}));
    ASSERT_EQ(result.exit_code, 0) << result.err;
    for (const char* name : {"| path ", "| radiosity, flat ", "| radiosity, gather "})
        EXPECT_NE(result.out.find(name), std::string::npos) << result.out;
}

} // namespace ajar::test
