// Ctrl-C and SIGTERM as a state that a command asks for. A thread waits for the signals (sigwait), so that no
// handler and no global is needed; the signals must be blocked before other threads start: construct it
// first.
#pragma once

#include <atomic>
#include <csignal>
#include <thread>

namespace ajar::cli {

class Interrupts {
  public:
    enum class Phase {
        preparing, // there is nothing to save: the first signal ends the process with exit code 130
        rendering, // the first one is a request to stop, the second ends the process
        writing,   // files are being written: a request that waits until they are whole
    };

    Interrupts();
    ~Interrupts();
    Interrupts(const Interrupts&) = delete;
    Interrupts& operator=(const Interrupts&) = delete;

    void enter(Phase phase) { phase_ = phase; }
    bool requested() const { return requested_; }

  private:
    void wait();

    sigset_t signals_;
    sigset_t previous_;
    std::atomic<Phase> phase_{Phase::preparing};
    std::atomic<bool> requested_{false};
    std::atomic<bool> ended_{false};
    std::thread thread_;
};

} // namespace ajar::cli
