// The text of --help: what the command does, examples, usage, then options by group, wrapped at 80 columns.
// CLI11's own formatter puts the examples last and changed its wrapping between the versions that
// distributions ship.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace ajar::cli {

// An App's footer holds its examples.
class HelpFormatter : public CLI::FormatterBase {
  public:
    std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
};

// "HEAD: a: help of a; b: help of b." from the rows of a table that have `name` and `help`.
template <class Rows> std::string help_from(std::string_view head, const Rows& rows) {
    std::string text(head);
    char separator = ':';
    for (const auto& row : rows) {
        text += separator;
        text += std::string("\n  ") + row.name + " = " + row.help;
        separator = ',';
    }
    return text;
}

// Refuses, as CLI11 does for its own checks, what is no row's name.
template <class Rows> CLI::Validator one_of(const Rows& rows) {
    std::vector<std::string> names;
    for (const auto& row : rows) names.emplace_back(row.name);
    return CLI::IsMember(names).description("");
}

} // namespace ajar::cli
