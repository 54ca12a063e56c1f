// What the command says about itself, and what it says to a wrong command line.
#include "cli/run_ajar.hpp"
#include "image/tonemap.hpp"
#include "radiosity/radiosity.hpp"
#include "render/render.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace ajar::test {

namespace {

// One line "ajar: error: ...", exit code 2, a hint where to look.
void expect_usage_error(const std::vector<std::string>& arguments, const std::string& part) {
    const TemporaryFolder folder;
    Surroundings surroundings;
    surroundings.folder = folder.path();
    const Result result = run_ajar(arguments, surroundings);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
    EXPECT_EQ(result.exit_code, 2) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_TRUE(result.err.starts_with("ajar: error: ")) << result.err;
    EXPECT_EQ(lines(result.err).size(), 1u) << result.err;
    EXPECT_NE(result.err.find(part), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("--help)"), std::string::npos) << result.err;
}

} // namespace

TEST(Help, ComesFromEveryCommandWithExamplesFirst) {
    for (const char* command :
         {"render", "radiosity", "bake", "lab", "merge", "compare", "info", "devices"}) {
        const Result result = run_ajar({command, "--help"});
        EXPECT_EQ(result.exit_code, 0) << command;
        EXPECT_EQ(result.err, "") << command;
        const std::size_t examples = result.out.find("\nExamples:\n");
        const std::size_t usage = result.out.find(std::string("\nUsage: ajar ") + command);
        const std::size_t options = result.out.find("  -h, --help");
        EXPECT_LT(examples, usage) << result.out;
        EXPECT_LT(usage, options) << result.out;
        EXPECT_NE(options, std::string::npos) << result.out;
    }
}

TEST(Help, OfTheCommandItselfNamesTheOthers) {
    const Result result = run_ajar({"--help"});
    EXPECT_EQ(result.exit_code, 0);
    for (const char* command : {"\n  render ", "\n  radiosity ", "\n  bake ", "\n  lab ", "\n  merge ",
                                "\n  compare ", "\n  info ", "\n  devices "})
        EXPECT_NE(result.out.find(command), std::string::npos) << command;
}

TEST(Help, FitsEightyColumns) {
    for (const char* command : {"render", "radiosity", "bake", "lab", "merge", "compare", "info", "devices"})
        for (const std::string& line : lines(run_ajar({command, "--help"}).out))
            EXPECT_LE(line.size(), 80u) << line;
}

TEST(Help, ListsEveryRowOfEveryTable) {
    const std::string help = run_ajar({"render", "--help"}).out;
    const auto expect_rows = [&](const auto& rows) {
        for (const auto& row : rows)
            EXPECT_NE(help.find(std::string("  ") + row.name + " = "), std::string::npos) << row.name;
    };
    expect_rows(integrators());
    expect_rows(strategies());
    expect_rows(light_sampler_options());
    expect_rows(samplers());
    expect_rows(naive_samplings());
    expect_rows(shadings());
    expect_rows(radiosity_solvers());
    expect_rows(radiosity_directs());
    expect_rows(environment_samplings());
    expect_rows(pixel_filters());
    expect_rows(tonemap_operators());
}

TEST(Help, VersionIsOneLine) {
    const Result result = run_ajar({"--version"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.out, "ajar " AJAR_VERSION "\n");
}

TEST(Usage, NothingAtAllIsAnError) { expect_usage_error({}, "command is missing"); }

TEST(Usage, AnUnknownCommandIsAnError) { expect_usage_error({"rendr"}, "rendr"); }

TEST(Usage, AnUnknownOptionIsAnError) {
    expect_usage_error({"render", scene_path("cornell-box"), "-o", "x.png", "--sampels", "3"}, "--sampels");
}

TEST(Usage, AMissingSceneIsAnError) { expect_usage_error({"render", "-o", "x.png"}, "SCENE"); }

TEST(Usage, AMissingOutputIsAnError) { expect_usage_error({"render", scene_path("cornell-box")}, "-o FILE"); }

TEST(Usage, NamesOutsideTheTablesAreErrorsThatListThem) {
    for (const char* option : {"--integrator", "--strategy", "--light-sampler", "--sampler",
                               "--naive-sampling", "--env-sampling", "--filter", "--tonemap"})
        expect_usage_error({"render", scene_path("cornell-box"), "-o", "x.png", option, "nonsense"},
                           "nonsense not in {");
    expect_usage_error({"render", scene_path("cornell-box"), "-o", "x.png", "--integrator", "nonsense"},
                       "path");
}

TEST(Usage, BadValuesAreErrors) {
    const std::vector<std::pair<std::string, std::string>> bad{
        {"--size", "100"},           {"--size", "0x10"},         {"--size", "10x10x10"},
        {"--size", "-4x4"},          {"--size", "100000x4"},     {"--samples", "0"},
        {"--samples", "-1"},         {"--samples", "1.5"},       {"--samples", "99999999999"},
        {"--seed", "abc"},           {"--exposure", "nan"},      {"--background", "1,2"},
        {"--background", "1,nan,0"}, {"--background", "-1,0,0"}, {"--time-limit", "-1"},
        {"--backfaces", "maybe"},    {"--progress", "loud"},     {"--max-bounces", ""},
        {"--slice", "inf"},          {"--first-sample", "-1"}};
    for (const auto& [option, value] : bad) {
        SCOPED_TRACE(option + " " + value);
        expect_usage_error({"render", scene_path("cornell-box"), "-o", "x.png", option, value}, option);
    }
}

TEST(Usage, ChoicesThatExcludeEachOtherAreErrors) {
    expect_usage_error({"render", scene_path("cornell-box"), "-o", "x.png", "--strategy", "light",
                        "--env-sampling", "compensated"},
                       "use strategy 'mis', or environment sampling 'radiance'");
    expect_usage_error({"render", scene_path("cornell-box"), "-o", "x.png", "--first-sample", "4294967295",
                        "--samples", "2"},
                       "go beyond 2^32");
}

TEST(Usage, OptionsOfAnEnvironmentNeedOne) {
    expect_usage_error({"render", scene_path("cornell-box"), "-o", "x.png", "--env-rotation", "90"}, "--env");
}

} // namespace ajar::test
