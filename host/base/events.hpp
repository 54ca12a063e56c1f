// How the library talks to its caller: it never prints, it calls these.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace ajar {

// Receives one line (no newline) about something that was ignored, replaced or approximated.
using WarningSink = std::function<void(std::string_view)>;

// A step of long work. `done` and `total` count units of `stage` (samples, triangles, ...).
struct Progress {
    std::string stage;
    std::uint64_t done = 0;
    std::uint64_t total = 0;
    double seconds = 0; // since the stage began
};

// Return false to stop the work at the next safe point; what is finished is kept.
using ProgressSink = std::function<bool(const Progress&)>;

} // namespace ajar
