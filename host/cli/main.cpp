// The `ajar` command: parses, runs one command, and turns every failure into one line and an exit code.
#include "ajar/version.hpp"
#include "base/error.hpp"
#include "cli/command.hpp"
#include "cli/help.hpp"

#include <algorithm>
#include <csignal>
#include <fmt/format.h>
#include <new>
#include <vector>

namespace ajar::cli {

namespace {

int usage_error(std::string_view message, const std::string& command) {
    print_line("error", fmt::format("{} (see {} --help)", message, command));
    return EXIT_USAGE;
}

int run(int argc, char** argv) {
    CLI::App app(
        "Ajar renders glTF scenes by path tracing and radiosity on any Vulkan device, and compares images.",
        "ajar");
    app.formatter(std::make_shared<HelpFormatter>());
    app.footer("  ajar render scene.glb -o out.png\n"
               "  ajar radiosity scene.glb -o out.png --shading gather\n"
               "  ajar bake scene.glb -o baked.glb\n"
               "  ajar lab scene.glb --strategies all\n"
               "  ajar compare out.exr golden.exr\n"
               "  ajar render --help");
    app.set_version_flag("--version", fmt::format("ajar {}", version()), "Print the version");
    app.set_help_flag("-h,--help", "Print this help");
    app.require_subcommand(0, 1);
    app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    const std::vector<Command> commands{render_command(app), radiosity_command(app), bake_command(app),
                                        lab_command(app),    merge_command(app),     compare_command(app),
                                        info_command(app),   devices_command(app)};
    const auto chosen = [&] {
        return std::find_if(commands.begin(), commands.end(),
                            [](const Command& c) { return c.app->parsed(); });
    };
    const auto chosen_name = [&] {
        return chosen() == commands.end() ? std::string("ajar") : "ajar " + chosen()->app->get_name();
    };
    try {
        app.parse(argc, argv);
        if (chosen() == commands.end())
            throw UsageError(
                "a command is missing: render, radiosity, bake, lab, merge, compare, info or devices");
        return chosen()->run();
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success))
            return app.exit(error); // --help
        return usage_error(error.what(), chosen_name());
    } catch (const UsageError& error) {
        return usage_error(error.what(), chosen_name());
    }
}

} // namespace

} // namespace ajar::cli

int main(int argc, char** argv) {
    std::signal(SIGPIPE, SIG_IGN); // a reader of --progress json that went away must not end a render
    try {
        return ajar::cli::run(argc, argv);
    } catch (const ajar::Error& error) {
        ajar::cli::print_line("error", error.what());
    } catch (const std::bad_alloc&) {
        ajar::cli::print_line("error",
                              "out of memory (a smaller --size, fewer --aov layers or a smaller scene help)");
    } catch (const std::exception& error) {
        ajar::cli::print_line("error", fmt::format("unexpected: {}", error.what()));
    }
    return ajar::cli::EXIT_WORLD;
}
