#include "cli/help.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <sstream>
#include <vector>

namespace ajar::cli {

namespace {

constexpr std::size_t COLUMN = 26; // where descriptions begin
constexpr std::size_t WIDTH = 80;

// Appends `text` word by word, beginning at column `at`; lines after the first are indented to `column`. A
// newline in the text is kept, and its line's own leading spaces with it.
void wrap(std::string& out, const std::string& text, std::size_t at, std::size_t column) {
    std::istringstream lines(text);
    std::string line;
    for (bool first = true; std::getline(lines, line); first = false) {
        if (!first) out += '\n' + std::string(column, ' '), at = column;
        const std::size_t indent = line.find_first_not_of(' ');
        const std::size_t hang = column + (indent == std::string::npos || indent == 0 ? 0 : indent + 2);
        if (indent != std::string::npos && indent > 0) out += std::string(indent, ' '), at += indent;
        std::istringstream words(line);
        std::string word;
        for (bool begin = true; words >> word; begin = false) {
            if (!begin && at + 1 + word.size() > WIDTH) {
                out += '\n' + std::string(hang, ' ');
                at = hang;
            } else if (!begin) {
                out += ' ', ++at;
            }
            out += word, at += word.size();
        }
    }
    out += '\n';
}

std::string option_names(const CLI::Option& option) {
    std::string names;
    for (const std::string& name : option.get_snames()) names += (names.empty() ? "-" : ", -") + name;
    for (const std::string& name : option.get_lnames()) names += (names.empty() ? "    --" : ", --") + name;
    if (!option.get_type_name().empty()) names += ' ' + option.get_type_name();
    return names;
}

void add_entry(std::string& out, const std::string& head, const std::string& description) {
    out += "  " + head;
    std::size_t at = 2 + head.size();
    if (at + 2 > COLUMN) out += '\n', at = 0;
    out += std::string(COLUMN - at, ' ');
    wrap(out, description, COLUMN, COLUMN);
}

// The group that CLI11 puts --help into comes last.
void add_options(std::string& out, const CLI::App* app) {
    std::vector<std::string> groups = app->get_groups();
    std::stable_partition(groups.begin(), groups.end(), [](const std::string& g) { return g != "Options"; });
    for (const std::string& group : groups) {
        const auto options = app->get_options([&](const CLI::Option* o) {
            return !group.empty() && o->get_group() == group && o->nonpositional();
        });
        if (options.empty()) continue;
        out += fmt::format("\n{}:\n", group);
        for (const CLI::Option* option : options)
            add_entry(out, option_names(*option), option->get_description());
    }
}

} // namespace

std::string HelpFormatter::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode) const {
    std::string out;
    wrap(out, app->get_description(), 0, 0);
    if (!app->get_footer().empty()) out += fmt::format("\nExamples:\n{}\n", app->get_footer());
    const auto positionals = app->get_options([](const CLI::Option* o) { return o->get_positional(); });
    const auto commands = app->get_subcommands([](const CLI::App* a) { return !a->get_name().empty(); });
    out += fmt::format("\nUsage: {}{}", name, commands.empty() ? "" : " COMMAND");
    for (const CLI::Option* option : positionals) out += ' ' + option->get_name(true);
    out += " [OPTIONS]\n";
    if (!positionals.empty()) out += '\n';
    for (const CLI::Option* option : positionals)
        add_entry(out, option->get_name(true), option->get_description());
    if (!commands.empty()) out += "\nCommands:\n";
    for (const CLI::App* command : commands) add_entry(out, command->get_name(), command->get_description());
    add_options(out, app);
    return out;
}

} // namespace ajar::cli
