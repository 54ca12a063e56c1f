#include "cli/lab/report.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace ajar::cli {

namespace {

using Json = nlohmann::ordered_json;
using Row = std::vector<std::string>;

const Row HEAD{"case", "samples",     "seconds", "relMSE", "efficiency",
               "gain", "lights seen", "Mrays",   "slope",  "mean"};

std::string lights_seen(const RenderResult& r) {
    if (r.shadow_rays == 0) return "-";
    return fmt::format("{:.1f} %",
                       100 * static_cast<double>(r.shadow_rays_open) / static_cast<double>(r.shadow_rays));
}

const char* slope_word(const SlopeFit& fit) {
    switch (judge(fit)) {
    case SlopeVerdict::steeper: return "steeper than -1/2: stratified";
    case SlopeVerdict::flatter: return "flatter than -1/2: heavy tails or bias";
    case SlopeVerdict::undecided: return "too scattered to tell: heavy tails";
    default: return "-1/2 as expected";
    }
}

std::string slope_text(const Measured& m) {
    if (!m.slope) return "too few points";
    return fmt::format("{:.2f} ± {:.2f}, {}", m.slope->slope, m.slope->standard_error, slope_word(*m.slope));
}

std::string mean_text(const Measured& m) {
    if (!m.mean) return fmt::format("{:+.2f} %, not tested", 100 * m.mean_shift);
    if (m.mean->same) return "agrees";
    return fmt::format("{:+.2f} %: biased or blind to some light", 100 * m.mean_shift);
}

Row row_of(const Measured& m, const Measured& first) {
    const double gain = first.efficiency() > 0 ? m.efficiency() / first.efficiency() : 0;
    return {m.name,
            fmt::format("{}", m.last().samples),
            fmt::format("{:.2f}", m.last().seconds),
            fmt::format("{:.4g}", m.last().relmse),
            fmt::format("{:.4g}", m.efficiency()),
            fmt::format("{:.3g}", gain),
            lights_seen(m.totals),
            fmt::format("{:.1f}", static_cast<double>(m.totals.rays) * 1e-6),
            slope_text(m),
            mean_text(m)};
}

std::size_t letters(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0u) != 0x80u; }));
}

// A bar inside of a cell would end it.
std::string markdown_cell(const std::string& text) {
    std::string out;
    for (const char c : text) out += c == '|' ? std::string("\\|") : std::string(1, c == '\n' ? ' ' : c);
    return out;
}

std::string aligned(const std::vector<Row>& rows) {
    std::vector<std::size_t> widths(rows.front().size(), 3);
    for (const Row& row : rows)
        for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], letters(row[c]));
    const auto is_number = [](std::size_t c) { return c > 0 && c < 8; };
    std::string text;
    for (std::size_t r = 0; r < rows.size(); ++r) {
        for (std::size_t c = 0; c < widths.size(); ++c) {
            const std::string spare(widths[c] - letters(rows[r][c]), ' ');
            text += "| " + (is_number(c) ? spare + rows[r][c] : rows[r][c] + spare) + ' ';
        }
        text += "|\n";
        if (r > 0) continue;
        for (std::size_t c = 0; c < widths.size(); ++c)
            text += '|' + std::string(widths[c] + 1, '-') + (is_number(c) ? ':' : '-');
        text += "|\n";
    }
    return text;
}

std::string budget_text(const Budget& budget) {
    return budget.samples > 0 ? fmt::format("equal samples, {} per pixel", budget.samples)
                              : fmt::format("equal time, {:g} seconds", budget.seconds);
}

std::string reference_text(const Reference& r) {
    if (r.given) return fmt::format("reference {}", r.file.string());
    return fmt::format("reference of {} samples{}, itself off by a relMSE of {:.2g}", r.samples,
                       r.found == r.samples ? " (kept from an earlier run)" : "", r.noise);
}

Json checkpoints_json(const Measured& m) {
    Json list = Json::array();
    for (const Checkpoint& c : m.checkpoints)
        list.push_back({{"samples", c.samples}, {"seconds", c.seconds}, {"relmse", c.relmse}});
    return list;
}

Json case_json(const Measured& m, const Measured& first) {
    const RenderResult& t = m.totals;
    Json settings = Json::parse(t.manifest)["settings"];
    settings.erase("first_sample"); // of the last range
    settings["samples"] = m.last().samples;
    Json json{{"name", m.name},
              {"settings", settings},
              {"samples", m.last().samples},
              {"seconds", m.last().seconds},
              {"relmse", m.last().relmse},
              {"efficiency", m.efficiency()},
              {"gain", first.efficiency() > 0 ? m.efficiency() / first.efficiency() : 0},
              {"rays", t.rays},
              {"shadow_rays", t.shadow_rays},
              {"shadow_rays_open", t.shadow_rays_open},
              {"invalid_samples", t.invalid_samples},
              {"mean_shift", m.mean_shift}};
    if (m.slope)
        json["slope"] = {{"value", m.slope->slope},
                         {"standard_error", m.slope->standard_error},
                         {"verdict", slope_word(*m.slope)}};
    else
        json["slope"] = nullptr;
    json["mean"] = m.mean ? Json{{"agrees", m.mean->same}, {"p", m.mean->p}} : Json(nullptr);
    json["checkpoints"] = checkpoints_json(m);
    return json;
}

Json reference_json(const Reference& r) {
    return {{"file", r.file.filename().string()}, {"given", r.given},     {"samples", r.samples},
            {"samples_found", r.found},           {"seconds", r.seconds}, {"noise_relmse", r.noise}};
}

} // namespace

std::string as_markdown(const LabResults& results) {
    std::vector<Row> rows{HEAD};
    for (const Measured& m : results.cases) rows.push_back(row_of(m, results.cases.front()));
    for (Row& row : rows)
        for (std::string& cell : row) cell = markdown_cell(cell);
    return fmt::format(
        "{}: {}; {}{}\n\n{}", results.title, budget_text(results.budget), reference_text(results.reference),
        results.interrupted ? "; interrupted, these are the finished cases" : "", aligned(rows));
}

std::string as_csv(const LabResults& results) {
    std::string text = "case,samples,seconds,relmse,efficiency,rays,shadow_rays,shadow_rays_open\n";
    for (const Measured& m : results.cases) {
        std::string name;
        for (const char c : m.name) name += c == '"' ? std::string("\"\"") : std::string(1, c);
        for (const Checkpoint& c : m.checkpoints) {
            const bool last = &c == &m.checkpoints.back();
            const double cost = c.relmse * c.seconds;
            text += fmt::format("\"{}\",{},{},{},{}", name, c.samples, c.seconds, c.relmse,
                                cost > 0 ? 1 / cost : 0);
            text += last ? fmt::format(",{},{},{}\n", m.totals.rays, m.totals.shadow_rays,
                                       m.totals.shadow_rays_open)
                         : ",,,\n";
        }
    }
    return text;
}

std::string as_json(const LabResults& results) {
    Json json{{"title", results.title}, {"scene_file", results.scene}};
    json["equal"] = results.budget.samples > 0 ? Json{{"samples", results.budget.samples}}
                                               : Json{{"seconds", results.budget.seconds}};
    json["interrupted"] = results.interrupted;
    json["reference"] = reference_json(results.reference);
    if (!results.cases.empty()) {
        const Json manifest = Json::parse(results.cases.front().totals.manifest);
        for (const char* part : {"ajar", "scene", "device", "shaders"}) json[part] = manifest[part];
    }
    json["cases"] = Json::array();
    for (const Measured& m : results.cases) json["cases"].push_back(case_json(m, results.cases.front()));
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::optional<std::string> reference_warning(const LabResults& results) {
    double least = INFINITY;
    for (const Measured& m : results.cases) least = std::min(least, m.last().relmse);
    const double noise = results.reference.noise;
    if (!(noise > least / 10)) return std::nullopt;
    return fmt::format("the reference's own error, a relMSE of {:.2g}, is more than a tenth of the smallest, "
                       "{:.2g}, which is therefore overstated (--reference-samples, --reference-options)",
                       noise, least);
}

} // namespace ajar::cli
