#include "cli/progress.hpp"

#include "cli/command.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace ajar::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr double REDRAW_SECONDS = 0.1;

void print_json(const Json& json) {
    const std::string line = json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
    std::fwrite(line.data(), 1, line.size(), stdout); // a closed pipe is no error of the render
    std::fflush(stdout);
}

std::string clock_time(double seconds) {
    const auto s = static_cast<std::uint64_t>(std::ceil(seconds));
    if (s >= 3600) return fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
    return fmt::format("{}:{:02}", s / 60, s % 60);
}

} // namespace

ProgressMode progress_mode(std::string_view name) {
    if (name == "json") return ProgressMode::json;
    return name == "auto" && isatty(STDERR_FILENO) != 0 ? ProgressMode::terminal : ProgressMode::none;
}

void ProgressDisplay::clear() {
    if (line_open_) print_stderr("\r\x1b[K");
    line_open_ = false;
}

void ProgressDisplay::stage(std::string_view name) {
    shown_ = -1;
    if (mode_ == ProgressMode::json) print_json({{"event", "stage"}, {"stage", name}});
    if (mode_ != ProgressMode::terminal) return;
    print_stderr(fmt::format("\r\x1b[K{} ...", name));
    line_open_ = true;
}

void ProgressDisplay::update(const Progress& p) {
    const bool last = p.done == p.total;
    if (p.stage != stage_) shown_ = -1;
    stage_ = p.stage;
    if (mode_ == ProgressMode::none || (!last && shown_ >= 0 && p.seconds - shown_ < REDRAW_SECONDS)) return;
    shown_ = p.seconds;
    const double rate = p.seconds > 0 ? static_cast<double>(p.done) / p.seconds : 0;
    double left = rate > 0 ? static_cast<double>(p.total - p.done) / rate : -1;
    if (time_limit_ > 0)
        left = std::min(left < 0 ? time_limit_ : left, std::max(time_limit_ - p.seconds, 0.0));
    if (mode_ == ProgressMode::json) {
        Json json{{"event", "progress"}, {"stage", p.stage}, {"done", p.done}, {"total", p.total}};
        json["seconds"] = p.seconds;
        json["rate"] = rate;
        json["left_seconds"] = left < 0 ? Json(nullptr) : Json(left);
        print_json(json);
        return;
    }
    const bool samples = p.stage == "render";
    const double percent = p.total > 0 ? 100 * static_cast<double>(p.done) / static_cast<double>(p.total) : 0;
    std::string line = samples ? fmt::format("\r\x1b[K{}/{} samples", p.done, p.total)
                               : fmt::format("\r\x1b[K{}: {:.0f} %", p.stage, percent);
    if (samples && rate > 0) line += fmt::format("  {:.3g}/s", rate);
    if (left >= 0) line += fmt::format("  {} left", clock_time(left));
    print_stderr(line);
    line_open_ = true;
}

void ProgressDisplay::overall(const std::string& step, double share, double seconds) {
    if (mode_ == ProgressMode::none || (shown_ >= 0 && seconds - shown_ < REDRAW_SECONDS)) return;
    shown_ = seconds;
    const double left = share > 0 ? seconds / share * (1 - share) : -1;
    if (mode_ == ProgressMode::json) {
        Json json{{"event", "progress"}, {"stage", step}, {"share", share}, {"seconds", seconds}};
        json["left_seconds"] = left < 0 ? Json(nullptr) : Json(left);
        print_json(json);
        return;
    }
    std::string line = fmt::format("\r\x1b[K{:3.0f} %  {}", 100 * share, step);
    if (left >= 0 && seconds > 1) line += fmt::format("  {} left", clock_time(left));
    print_stderr(line);
    line_open_ = true;
}

void ProgressDisplay::done(bool interrupted) {
    clear();
    if (mode_ == ProgressMode::json) print_json({{"event", "done"}, {"interrupted", interrupted}});
}

void ProgressDisplay::warning(std::string_view line) {
    clear();
    print_line("warning", line);
    if (mode_ == ProgressMode::json) print_json({{"event", "warning"}, {"message", line}});
}

void ProgressDisplay::notice(std::string_view line) {
    clear();
    print_stderr(fmt::format("ajar: {}\n", line));
    if (mode_ == ProgressMode::json) print_json({{"event", "notice"}, {"message", line}});
}

void ProgressDisplay::written(const std::string& file) {
    if (mode_ == ProgressMode::json) print_json({{"event", "written"}, {"file", file}});
}

void ProgressDisplay::finished(const std::string& files, std::uint32_t samples, double seconds,
                               std::uint64_t rays, bool interrupted) {
    clear();
    const double mrays = seconds > 0 ? static_cast<double>(rays) / seconds * 1e-6 : 0;
    if (mode_ == ProgressMode::terminal)
        print_stderr(fmt::format("{} samples in {:.2f} s, {:.3g} samples/s, {:.3g} Mrays/s: {}\n", samples,
                                 seconds, seconds > 0 ? samples / seconds : 0, mrays, files));
    if (mode_ == ProgressMode::json)
        print_json({{"event", "done"},
                    {"samples", samples},
                    {"seconds", seconds},
                    {"rays", rays},
                    {"mrays_per_second", mrays},
                    {"interrupted", interrupted}});
}

} // namespace ajar::cli
