// ajar lab: which cases options stand for, and what it refuses.
#include "cli/run_ajar.hpp"
#include "cli/small_renders.hpp"
#include "render/render.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace ajar::test {

namespace {

// The names that --dry-run lists.
std::vector<std::string> listed(std::vector<std::string> more) {
    more.emplace_back("--dry-run");
    const Result result = run_ajar(lab("nowhere", more));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    std::vector<std::string> names;
    for (const std::string& line : lines(result.out))
        if (const std::size_t end = line.find(" (--"); end != std::string::npos)
            names.push_back(line.substr(0, end));
    EXPECT_NE(result.out.find(std::to_string(names.size()) + " cases of "), std::string::npos) << result.out;
    return names;
}

void expect_refused(const std::vector<std::string>& more, const std::string& part) {
    const TemporaryFolder folder;
    const Result result = run_ajar(lab((folder / "out").string(), more));
    EXPECT_EQ(result.exit_code, 2) << result.err;
    EXPECT_EQ(lines(result.err).size(), 1u) << result.err;
    EXPECT_NE(result.err.find(part), std::string::npos) << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

} // namespace

TEST(LabCases, AreEveryCombinationOfTheLists) {
    using Names = std::vector<std::string>;
    EXPECT_EQ(listed({}), Names{"path"});
    EXPECT_EQ(listed({"--strategies", "light, mis"}), (Names{"light", "mis"}));
    EXPECT_EQ(listed({"--strategies", "all"}).size(), strategies().size());
    EXPECT_EQ(listed({"--light-samplers", "all"}).size(), light_samplers().size());
    EXPECT_EQ(listed({"--strategies", "mis,light", "--light-samplers", "power,uniform"}),
              (Names{"mis, power", "mis, uniform", "light, power", "light, uniform"}));
}

TEST(LabCases, LeaveOutWhatMakesNoDifference) {
    const std::vector<std::string> names = listed(
        {"--integrators", "naive,path", "--strategies", "bsdf,mis", "--light-samplers", "power,uniform"});
    EXPECT_EQ(names,
              (std::vector<std::string>{"naive", "path, bsdf", "path, mis, power", "path, mis, uniform"}));
}

TEST(LabCases, MayBeNamedSetsOfOptions) {
    const std::vector<std::string> cases{"--case", "no bounces: --max-bounces 0 --strategy light", "--case",
                                         "all of it: "};
    EXPECT_EQ(listed(cases), (std::vector<std::string>{"no bounces", "all of it"}));
    std::vector<std::string> more = cases;
    more.insert(more.end(), {"--strategies", "mis,bsdf"});
    EXPECT_EQ(listed(more).size(), 4u);
}

TEST(LabUsage, WrongListsAndCasesAreErrors) {
    expect_refused({"--strategies", "mis,nonsense"}, "--strategies: 'nonsense' is none of mis, ");
    expect_refused({"--strategies", ""}, "--strategies");
    expect_refused({"--case", "no colon"}, "NAME: --option");
    expect_refused({"--case", ": --max-bounces 0"}, "NAME: --option");
    expect_refused({"--case", "a: --sampels 3"}, "--case 'a': ");
    expect_refused({"--case", "a: --samples 3"}, "--case 'a': ");
    expect_refused({"--case", "a: --strategy nonsense"}, "nonsense not in {");
    expect_refused({"--case", "a: ", "--case", "a: "}, "two cases are named 'a'");
    expect_refused({"--first-sample", "3"}, "--first-sample");
    expect_refused({"--case", "a: --first-sample 3"}, "--case 'a': ");
}

TEST(LabUsage, AnOptionOfRenderThatIsAListHereNamesTheList) {
    expect_refused({"--strategy", "mis"}, "--strategy: a lab compares rows of a list (use --strategies mis)");
    expect_refused({"--light-sampler", "tree"}, "(use --light-samplers tree)");
    expect_refused({"--env-sampling=radiance"}, "(use --env-samplings radiance)");
}

TEST(LabUsage, CasesThatNothingCouldRenderAreErrorsBeforeAnyIsRendered) {
    expect_refused({"--case", "dim: --strategy light --env-sampling compensated"},
                   "dim: environment sampling 'compensated': strategy 'light' would miss");
    expect_refused({"--reference-options", "--max-bounces 2000"}, "--reference-options: max bounces 2000");
    EXPECT_EQ(listed({"--strategies", "light,mis", "--env-samplings", "compensated,radiance"}),
              (std::vector<std::string>{"light", "mis, compensated", "mis, radiance"}));
}

TEST(LabUsage, WrongBudgetsReferencesAndInsetsAreErrors) {
    expect_refused({"--samples", "4", "--seconds", "1"}, "--seconds");
    expect_refused({"--seconds", "0"}, "--seconds");
    expect_refused({"--seconds", "1", "--sheet-samples", "4"}, "--sheet-samples");
    expect_refused({"--samples", "4", "--sheet-samples", "1,8"}, "--sheet-samples");
    expect_refused({"--samples", "4", "--sheet-samples", "1,x"}, "'x' is not a number");
    expect_refused({"--reference", "a.exr", "--reference-samples", "4"}, "--reference");
    expect_refused({"--reference-options", "--nonsense 3"}, "--reference-options: ");
    for (const char* inset :
         {"1,2,3", "0,0,0,1", "0.5,0,0.6,1", "0,0,17,4", "nan,0,1,1", "a,b,c,d", "-1,0,1,1"})
        expect_refused({"--insets", inset}, "--insets: ");
}

} // namespace ajar::test
