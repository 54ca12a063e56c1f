// The three ways in which a command says something.
#include "base/error.hpp"
#include "cli/command.hpp"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>

namespace ajar::cli {

void print_stderr(std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stderr);
    std::fflush(stderr);
}

void print_line(std::string_view kind, std::string_view message) {
    std::string line = fmt::format("ajar: {}: {}", kind, message);
    std::replace(line.begin(), line.end(), '\n', ' ');
    print_stderr(line + '\n');
}

void print_result(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
        throw Error("standard output: cannot be written");
}

} // namespace ajar::cli
