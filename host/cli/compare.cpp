// ajar compare: measures how two images differ and gives a verdict, in words, as JSON, as a heat map, as exit
// code.
#include "image/compare.hpp"
#include "ajar/save_image.hpp"
#include "base/error.hpp"
#include "cli/command.hpp"
#include "image/read.hpp"

#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>
#include <nlohmann/json.hpp>

namespace ajar::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* EXAMPLES = "  ajar compare out.exr golden.exr\n"
                                 "  ajar compare out.png golden.png --max-flip 0.02 --diff difference.png\n"
                                 "  ajar compare out.exr golden.exr --significance 0.001 --json";

struct Options {
    std::string a, b;
    std::string diff;
    bool json = false;
    CompareOptions compare;
    Limits limits;
    std::optional<double> significance;
    std::optional<std::string> z_scale;
};

std::string channel_name(std::uint32_t channel) { return std::string(1, "RGB"[channel]); }

// JSON has no infinity; the PSNR of equal images is null.
Json finite_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json z_json(const std::optional<ZTest>& z) {
    if (!z) return nullptr;
    return {{"tests", z->tests},
            {"rejected", z->rejected},
            {"p", z->corrected_p},
            {"z", finite_or_null(z->z)},
            {"x", z->x},
            {"y", z->y},
            {"channel", channel_name(z->channel)}};
}

std::string as_json(const Options& o, const Comparison& c, const Verdict& verdict) {
    const Json json{
        {"a", o.a},
        {"b", o.b},
        {"width", c.width},
        {"height", c.height},
        {"same", verdict.same},
        {"reasons", verdict.reasons},
        {"rmse", c.rmse},
        {"relmse", c.relmse},
        {"psnr", finite_or_null(c.psnr)},
        {"flip", c.flip},
        {"flip_kind", c.flip_kind == FlipKind::hdr ? "hdr" : "ldr"},
        {"max_error",
         {{"value", c.max_error}, {"x", c.max_x}, {"y", c.max_y}, {"channel", channel_name(c.max_channel)}}},
        {"significance", c.significance},
        {"z_test",
         {{"image", z_json(c.image_z)}, {"tiles", z_json(c.tile_z)}, {"pixels", z_json(c.pixel_z)}}}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string z_line(const char* name, const std::optional<ZTest>& z) {
    if (!z) return {};
    return fmt::format("z-test {:<8} p = {:.3g} ({} of {} rejected)\n", name, z->corrected_p, z->rejected,
                       z->tests);
}

std::string as_text(const Comparison& c, const Verdict& verdict) {
    std::string text = fmt::format("RMSE            {:.6g}\n"
                                   "relMSE          {:.6g}\n"
                                   "PSNR            {:.2f} dB\n"
                                   "FLIP ({})      {:.6g}\n"
                                   "largest error   {:.6g} at ({}, {}) {}\n",
                                   c.rmse, c.relmse, c.psnr, c.flip_kind == FlipKind::hdr ? "HDR" : "LDR",
                                   c.flip, c.max_error, c.max_x, c.max_y, channel_name(c.max_channel));
    text += z_line("image", c.image_z) + z_line("tiles", c.tile_z) + z_line("pixels", c.pixel_z);
    if (verdict.same) return text + "same\n";
    return text + fmt::format("different: {}\n", fmt::join(verdict.reasons, "; "));
}

// Noise judges unless only limits were asked for.
void choose_tests(Options& o) {
    const Limits& limits = o.limits;
    const bool limited = limits.max_flip || limits.max_rmse || limits.max_relmse || limits.max_error;
    if (o.significance) o.compare.significance = *o.significance;
    if (o.z_scale == "pixels")
        o.limits.z_scales = {ZScale::pixels};
    else if (limited && !o.significance && !o.z_scale)
        o.limits.z_scales = {};
}

int run(Options& o) {
    if (!o.diff.empty()) check_save(o.diff);
    choose_tests(o);
    o.compare.test_name = o.a;
    o.compare.reference_name = o.b;
    const Comparison comparison = compare(read_image(o.a), read_image(o.b), o.compare);
    if ((o.significance || o.z_scale) && !comparison.image_z)
        throw Error(fmt::format("{}: or {}: has no layer 'variance', so that noise cannot be judged (leave "
                                "--significance and --z-scale out)",
                                o.a, o.b));
    const Verdict verdict = judge(comparison, o.limits);
    if (!o.diff.empty()) save_image(o.diff, heat_map(comparison));
    print_result(o.json ? as_json(o, comparison, verdict) : as_text(comparison, verdict));
    return verdict.same ? EXIT_OK : EXIT_DIFFERENT;
}

void declare(CLI::App& app, Options& o) {
    app.add_option("A", o.a, "The image in question")->required();
    app.add_option("B", o.b, "The reference, of the same size")->required();
    const std::string verdict = "Verdict (exit code 0: same, 3: different, 1 or 2: an error)";
    const auto limit = [&](const char* name, std::optional<double>& value, const char* help) {
        app.add_option(name, value, help)->type_name("X")->check(CLI::NonNegativeNumber)->group(verdict);
    };
    limit("--max-flip", o.limits.max_flip, "Largest mean FLIP error that is still the same (0 to 1)");
    limit("--max-rmse", o.limits.max_rmse, "Largest root of the mean squared error");
    limit("--max-relmse", o.limits.max_relmse, "Largest mean of (a - b)^2 / (b^2 + 0.01)");
    limit("--max-error", o.limits.max_error, "Largest error of any value");
    app.add_option(
           "--significance", o.significance,
           "Chance to call two renders of one scene different, where both images carry a layer 'variance' "
           "(default 1e-4). Without any limit this z-test decides, or, without variance, equality; with "
           "limits it counts only where asked for")
        ->type_name("P")
        ->check(CLI::Range(1e-12, 0.5))
        ->group(verdict);
    app.add_option(
           "--z-scale", o.z_scale,
           "What the z-test looks at: the whole image and tiles (default), or single pixels, whose means are "
           "not normal with few samples")
        ->type_name("tiles|pixels")
        ->check(CLI::IsMember({"tiles", "pixels"}).description(""))
        ->group(verdict);
    app.add_option("--diff", o.diff, "Writes the FLIP error per pixel as a heat map")
        ->type_name("FILE.png")
        ->group("Output");
    app.add_flag("--json", o.json, "For machines")->group("Output");
}

} // namespace

Command compare_command(CLI::App& parent) {
    CLI::App* app =
        parent.add_subcommand("compare", "Tells how two images differ, and whether they count as the same");
    app->footer(EXAMPLES);
    const auto options = std::make_shared<Options>();
    declare(*app, *options);
    return {app, [options] { return run(*options); }};
}

} // namespace ajar::cli
