// croquis doctor: what this machine draws with, where the data is, and what is missing.
#include <fmt/format.h>

#include <filesystem>

#include "commands.h"

namespace croquis::app {
namespace {

// Opens every technique, as a driver may refuse a shader that another takes; the number of those that fail.
int report_broken(Renderer& renderer) {
    int broken = 0;
    for (const std::string& name : renderer.technique_names()) {
        try {
            (void)renderer.open_technique(name);
        } catch (const Error& error) {
            fmt::print("broken         technique {} on {}: {}\n", name, renderer.info().api, error.what());
            ++broken;
        }
    }
    return broken;
}

// One API's lines; true when it can draw. Adds to the number of techniques that it cannot open.
bool report_api(const Common& common, const std::string& api, int& broken) {
    Renderer::Choice choice = common.choice();
    choice.api = api;
    try {
        Renderer renderer = Renderer::headless(choice);
        const RendererInfo info = renderer.info();
        fmt::print("{:14} works: {} through {}{}\n", info.api, info.renderer, info.platform,
                   info.is_software ? " (software: no GPU found)" : "");
        fmt::print("{:14} {}\n", "", info.version);
        broken += report_broken(renderer);
        return true;
    } catch (const Error& error) {
        fmt::print("{:14} fails: {}\n", api == "gl" ? "OpenGL 3.3" : "OpenGL ES 3.0", error.what());
        return false;
    }
}

int run(const Common& common) {
    fmt::print("croquis {}\n", CROQUIS_VERSION);
    int broken = 0;
    const bool gl = report_api(common, "gl", broken);
    const bool gles = report_api(common, "gles", broken);
    if (!gl && !gles) {
        fmt::print("missing        an OpenGL driver with EGL (on Debian: libegl1 and libgl1-mesa-dri)\n");
        return 1;
    }
    Renderer::Choice choice = common.choice();
    if (choice.api.empty() && !gl) choice.api = "gles";
    Renderer renderer = Renderer::headless(choice);
    const RendererInfo info = renderer.info();
    fmt::print("chosen         {} on {} (--gl and --device, or CROQUIS_GL and CROQUIS_DEVICE, change it)\n", info.api,
               info.renderer);
    for (const std::string& folder : info.data_folders) {
        fmt::print("data folder    {}\n", std::filesystem::absolute(folder).lexically_normal().string());
    }
    fmt::print("techniques     {} found, {} broken\n", renderer.technique_names().size(), broken);
    std::string endings;
    for (const std::string& ending : Model::readable_endings()) endings += (endings.empty() ? "" : " ") + ending;
    fmt::print("models         {}\n", endings);
    if (broken == 0 && gl && gles) fmt::print("nothing is missing\n");
    return broken == 0 ? 0 : 1;
}

}  // namespace

void add_doctor_command(CLI::App& program, Commands& commands) {
    CLI::App* command = program.add_subcommand("doctor", "Says what this machine draws with and what is missing");
    const auto common = std::make_shared<Common>();
    common->add_to(*command);
    commands[command] = [common] { return run(*common); };
}

}  // namespace croquis::app
