// Wall-clock time for reports and progress; nothing that decides an image reads it.
#pragma once

#include <chrono>

namespace ajar {

using Clock = std::chrono::steady_clock;

inline double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

} // namespace ajar
