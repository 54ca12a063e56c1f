// What main and the commands share: a command declares its options on a CLI11 subcommand and says how to run.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace ajar::cli {

// Exit codes, for scripts.
inline constexpr int EXIT_OK = 0;
inline constexpr int EXIT_WORLD = 1;     // a file, the scene or the driver is wrong
inline constexpr int EXIT_USAGE = 2;     // the command line is wrong
inline constexpr int EXIT_DIFFERENT = 3; // ajar compare: the images differ
inline constexpr int EXIT_INTERRUPTED = 130;

// Thrown by a command for options that do not go together; main adds where help is.
class UsageError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

struct Command {
    CLI::App* app;
    std::function<int()> run; // returns the exit code; owns the values that the options are parsed into
};

Command render_command(CLI::App& parent);
Command radiosity_command(CLI::App& parent);
Command bake_command(CLI::App& parent);
Command compare_command(CLI::App& parent);
Command lab_command(CLI::App& parent);
Command merge_command(CLI::App& parent);
Command info_command(CLI::App& parent);
Command devices_command(CLI::App& parent);

// To stderr as it is; a closed stderr is no reason to fail.
void print_stderr(std::string_view text);
// "ajar: KIND: MESSAGE" on stderr, as one line.
void print_line(std::string_view kind, std::string_view message);
// A command's result, to stdout. Throws Error when it cannot be written (a full disk behind a redirection).
void print_result(std::string_view text);

} // namespace ajar::cli
