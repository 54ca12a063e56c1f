#include "cli/lab/pictures.hpp"

#include "image/contact_sheet.hpp"
#include "image/plot.hpp"
#include "image/tonemap.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace ajar::cli {

namespace {

std::vector<Region> regions(const LabResults& results, const LabPlan& plan, const Tonemap& tonemap) {
    const Image& reference = results.reference.image;
    std::vector<Region> insets;
    const auto pixels = [](double part, std::uint32_t size) {
        return static_cast<std::uint32_t>(std::lround(part * size));
    };
    for (const auto& r : plan.insets)
        insets.push_back({pixels(r[0], reference.width), pixels(r[1], reference.height),
                          pixels(r[2], reference.width), pixels(r[3], reference.height)});
    if (!plan.automatic_insets) return insets;
    // Two of three quarters their width, a sixth of the picture wide: magnified threefold below it.
    const std::uint32_t width = reference.width / 6, height = std::min(width * 3 / 4, reference.height);
    if (width < 4) return insets;
    std::vector<const Image*> images;
    for (const Measured& m : results.cases) images.push_back(&m.pictures.back());
    return choose_insets(images, reference, tonemap, width, height, 2);
}

std::string figures(const Checkpoint& c) {
    return fmt::format("relMSE {:.3g}   {} spp   {:.2f} s", c.relmse, c.samples, c.seconds);
}

SheetCell reference_cell(const LabResults& results) {
    const Reference& r = results.reference;
    SheetCell cell{"reference", r.given ? r.file.filename().string() : fmt::format("{} spp", r.samples),
                   &r.image, true};
    return cell;
}

LogPlot plot(const LabResults& results, const char* x_label, double (*x)(const Checkpoint&)) {
    LogPlot p;
    p.title = results.title;
    p.x_label = x_label;
    p.y_label = "error (root of relMSE)";
    p.guide_exponent = -0.5;
    for (const Measured& m : results.cases) {
        PlotLine& line = p.lines.emplace_back();
        line.name = m.name;
        for (const Checkpoint& c : m.checkpoints) line.points.push_back({x(c), std::sqrt(c.relmse)});
    }
    return p;
}

} // namespace

Image lab_sheet(const LabResults& results, const LabPlan& plan, const SaveOptions& options) {
    ContactSheet sheet;
    sheet.tonemap.op = &find_tonemap(options.tonemap);
    sheet.tonemap.exposure = options.exposure;
    sheet.title = results.title;
    sheet.insets = regions(results, plan, sheet.tonemap);
    std::vector<SheetCell> all{reference_cell(results)};
    for (const Measured& m : results.cases) {
        if (plan.stops.empty()) {
            all.push_back({m.name, figures(m.last()), &m.pictures.back(), false});
            continue;
        }
        sheet.rows.push_back({reference_cell(results)});
        std::size_t shown = 0;
        for (const Checkpoint& c : m.checkpoints) {
            if (std::find(plan.stops.begin(), plan.stops.end(), c.samples) == plan.stops.end()) continue;
            const std::string title = fmt::format("{}, {} spp", m.name, c.samples);
            sheet.rows.back().push_back({title, figures(c), &m.pictures[shown++], false});
        }
    }
    if (plan.stops.empty()) sheet.rows = flow(std::move(all), sheet);
    return contact_sheet(sheet);
}

std::string plot_over_samples(const LabResults& results) {
    return log_log_svg(plot(results, "samples per pixel",
                            [](const Checkpoint& c) { return static_cast<double>(c.samples); }));
}

std::string plot_over_seconds(const LabResults& results) {
    return log_log_svg(plot(results, "seconds of rendering", [](const Checkpoint& c) { return c.seconds; }));
}

} // namespace ajar::cli
