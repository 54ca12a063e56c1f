// ajar radiosity: `ajar render --integrator radiosity` with the options that concern it.
#include "cli/command.hpp"
#include "cli/render.hpp"

namespace ajar::cli {

namespace {

constexpr const char* EXAMPLES =
    "  ajar radiosity scene.glb -o out.png\n"
    "  ajar radiosity scene.glb -o patches.png --shading flat --patches 2000\n"
    "  ajar radiosity scene.glb -o out.exr --shading gather --patch-size 0.05\n"
    "  ajar radiosity scene.glb -o out.png --solver shooting --report out.json\n"
    "  ajar radiosity scene.glb -o out.png --plot convergence.svg --plot-solvers all";

} // namespace

Command radiosity_command(CLI::App& parent) {
    CLI::App* app =
        parent.add_subcommand("radiosity", "Solves a scene's light by finite elements, and shows it");
    app->footer(EXAMPLES);
    const auto options = std::make_shared<RenderOptions>();
    options->settings.integrator = "radiosity";
    declare(*app, *options);
    for (const char* other :
         {"--integrator", "--naive-sampling", "--light-rays", "--max-bounces", "--rr-depth", "--ao-distance"})
        app->remove_option(app->get_option(other));
    return {app, [app, options] { return run_render(*app, *options); }};
}

} // namespace ajar::cli
