// A command buffer: record dispatches, submit, wait. Times each kernel by timestamps.
#pragma once

#include "gpu/bindings.hpp"

#include <map>

namespace ajar::gpu {

// Device time by kernel label.
struct KernelTime {
    double seconds = 0;
    std::uint64_t dispatches = 0;
};
using Profile = std::map<std::string, KernelTime>;

class Commands {
  public:
    explicit Commands(const Device& device);
    ~Commands();
    Commands(const Commands&) = delete;
    Commands& operator=(const Commands&) = delete;

    // The bindings of the dispatches that follow.
    void bind(const Bindings& bindings);
    // Runs what was recorded, waits, adds its times to profile(), and begins anew. Returns device seconds
    // (wall time where there are no timestamps). Throws Error on a lost device or out of memory.
    double submit();
    // Forgets what was recorded; the bindings stay.
    void reset();

    const Profile& profile() const;

    struct Impl;
    Impl& impl() const { return *impl_; }

  private:
    std::unique_ptr<Impl> impl_;
};

} // namespace ajar::gpu
