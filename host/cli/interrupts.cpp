#include "cli/interrupts.hpp"

#include "cli/command.hpp"

#include <unistd.h>

namespace ajar::cli {

namespace {

// A shell that starts a job in the background of a script lets it ignore SIGINT; that stays so.
void add_unless_ignored(sigset_t& set, int signal) {
    struct sigaction action = {};
    sigaction(signal, nullptr, &action);
    if (action.sa_handler != SIG_IGN) sigaddset(&set, signal);
}

} // namespace

Interrupts::Interrupts() {
    sigemptyset(&signals_);
    add_unless_ignored(signals_, SIGINT);
    sigaddset(&signals_, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &signals_, &previous_);
    thread_ = std::thread([this] { wait(); });
}

Interrupts::~Interrupts() {
    ended_ = true;
    pthread_kill(thread_.native_handle(), SIGTERM); // wakes the thread, which alone waits for it
    thread_.join();
    pthread_sigmask(SIG_SETMASK, &previous_, nullptr);
}

void Interrupts::wait() {
    while (true) {
        int signal = 0;
        sigwait(&signals_, &signal);
        if (ended_) return;
        const Phase phase = phase_;
        if (phase == Phase::preparing || (phase == Phase::rendering && requested_)) {
            print_stderr("\najar: interrupted: nothing was written\n");
            _exit(EXIT_INTERRUPTED);
        }
        requested_ = true;
        if (phase == Phase::rendering)
            print_stderr("\najar: stopping after the samples under way (again: at once, without saving)\n");
    }
}

} // namespace ajar::cli
