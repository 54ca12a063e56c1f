// What a render tells whoever started it: one line on a terminal that is rewritten, one JSON object a line
// for machines, or nothing. Warnings go to stderr whatever the mode.
#pragma once

#include "base/events.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace ajar::cli {

enum class ProgressMode { none, terminal, json };

// "auto" is `terminal` where stderr is one. Throws nothing: the option's own check has refused other names.
ProgressMode progress_mode(std::string_view name);

class ProgressDisplay {
  public:
    // time_limit in seconds, 0: none; the remaining time heeds it.
    ProgressDisplay(ProgressMode mode, double time_limit) : mode_(mode), time_limit_(time_limit) {}

    void stage(std::string_view name); // "load", "prepare", ...: begins
    void update(const Progress& progress);
    // Work of several steps: which one, the share of all that is done, and seconds since they began.
    void overall(const std::string& step, double share, double seconds);
    void done(bool interrupted); // of such work
    void warning(std::string_view line);
    void notice(std::string_view line); // stderr, even without progress
    void written(const std::string& file);
    void finished(const std::string& files, std::uint32_t samples, double seconds, std::uint64_t rays,
                  bool interrupted);

  private:
    void clear();

    ProgressMode mode_;
    double time_limit_;
    double shown_ = -1; // seconds of the last line
    std::string stage_; // that it was about
    bool line_open_ = false;
};

} // namespace ajar::cli
