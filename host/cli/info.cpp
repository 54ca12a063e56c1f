// ajar info: what is in a file and how Ajar understands it, without a device.
#include "import/info.hpp"
#include "cli/command.hpp"
#include "import/import.hpp"

#include <memory>
#include <nlohmann/json.hpp>

namespace ajar::cli {

namespace {

struct Options {
    std::string file;
    bool json = false;
    ImportOptions import;
};

} // namespace

Command info_command(CLI::App& parent) {
    CLI::App* app = parent.add_subcommand("info", "Tells what is in a glTF file");
    app->footer("  ajar info scene.glb\n"
                "  ajar info scene.glb --json");
    const auto options = std::make_shared<Options>();
    app->add_option("FILE", options->file, "A .gltf or .glb file")->required();
    app->add_flag("--json", options->json, "For machines");
    app->add_option("--scene", options->import.scene,
                    "Which of the file's scenes (default: the file's own choice)")
        ->type_name("NAME|INDEX");
    return {app, [options] {
                options->import.warn = [](std::string_view line) { print_line("warning", line); };
                const ImportResult result = import_gltf(options->file, options->import);
                print_result(options->json ? info_json(result).dump(
                                                 2, ' ', false, nlohmann::json::error_handler_t::replace) +
                                                 "\n"
                                           : info_text(result));
                return EXIT_OK;
            }};
}

} // namespace ajar::cli
