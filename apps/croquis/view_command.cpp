// croquis view: a window to look at models in techniques, and to tune these.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>

#include "base/error.h"
#include "base/log.h"
#include "built_in_model.h"
#include "commands.h"
#include "parse.h"
#include "viewer/settings.h"
#include "window.h"

namespace croquis::app {
namespace {

struct ViewCommand {
    Common common;
    std::vector<std::string> files;
    std::string technique;
    std::string size;
    std::string settings_file;
    double ui_scale = 0;
};

// A window that was made next to nothing would not be found next time.
constexpr Window::Size least_remembered{200, 150};

std::filesystem::path settings_path(const ViewCommand& options) {
    return options.settings_file.empty() ? viewer::Settings::default_path()
                                         : std::filesystem::path(options.settings_file);
}

viewer::Settings starting_settings(const ViewCommand& options) {
    viewer::Settings settings = viewer::Settings::load(settings_path(options));
    if (!options.size.empty()) {
        const Size size = parse_size(options.size, "--size");
        settings.window_width = size.width;
        settings.window_height = size.height;
    }
    if (!options.technique.empty()) settings.technique = options.technique;
    if (options.ui_scale != 0 && !(options.ui_scale >= Window::least_scale && options.ui_scale <= Window::most_scale)) {
        fail("--ui-scale: expected a number from {} to {}, found {}", Window::least_scale, Window::most_scale,
             options.ui_scale);
    }
    return settings;
}

// A configuration folder that cannot be written to is a pity and no failure.
void remember(const viewer::Settings& settings, const std::filesystem::path& path) {
    if (path.empty()) return;
    try {
        settings.save(path);
    } catch (const Error& error) {
        warn(error.what());
    }
}

int run(const ViewCommand& options) {
    const viewer::Settings start = starting_settings(options);
    const double scale = options.ui_scale != 0 ? options.ui_scale : start.ui_scale;  // one of this time alone
    Window window(start.window_width, start.window_height, scale);
    Renderer renderer = Renderer::in_current_context(options.common.data_folders);
    viewer::Application application(renderer, start, Window::wake);
    const bool has_model = std::any_of(options.files.begin(), options.files.end(), viewer::Application::is_model);
    if (!has_model) application.open(built_in_model_path(options.common));
    application.open(options.files);
    window.run(application);
    viewer::Settings settings = application.settings();
    const Window::Size size = window.size();
    if (size.width >= least_remembered.width && size.height >= least_remembered.height) {
        settings.window_width = size.width;
        settings.window_height = size.height;
    }
    remember(settings, settings_path(options));
    // What cannot be stopped, a parser that is not ours or a picture of millions of triangles, ends with the program.
    if (!application.stop(std::chrono::milliseconds(300))) std::quick_exit(0);
    return 0;
}

}  // namespace

void add_view_command(CLI::App& program, Commands& commands) {
    CLI::App* command = program.add_subcommand("view", "Opens a window to look at models and tune techniques");
    const auto options = std::make_shared<ViewCommand>();
    command->add_option(
        "files", options->files,
        "Models, .technique files, images as texture of the model; a built-in teapot where none is named");
    command->add_option("-t,--technique", options->technique,
                        "Name of a technique; that of last time where none is named");
    command->add_option("--size", options->size, "Of the window, WIDTHxHEIGHT; that of last time where none is named");
    command->add_option("--ui-scale", options->ui_scale, "How large texts and panels are; what the display asks for")
        ->check(check_number);
    command->add_option("--settings", options->settings_file, "File of what is remembered, in place of the user's own");
    // What a window draws with is the display's choice: no --gl and no --device here.
    command->add_option("--data", options->common.data_folders,
                        "A folder of your own components, techniques, shaders and textures");
    command->add_flag_callback(
        "--verbose", [] { set_verbose(); }, "Say more on standard error");
    commands[command] = [options] { return run(*options); };
}

}  // namespace croquis::app
