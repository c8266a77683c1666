#include "orientation_table.h"

#include <fmt/format.h>

#include "commands.h"
#include "view_options.h"

namespace croquis::app {

void print_orientation_table(const Model& model, const FaceOrientationOptions& options) {
    const double faces = double(model.triangle_count());
    fmt::print("{:22} {:>10} {:>7} {:>9} {:>12}\n", "method", "faces", "share", "holes", "us a view");
    for (const FaceOrientationResult& result : compare_face_orientations(model, options)) {
        fmt::print("{:22} {:10.1f} {:6.1f}% {:9.2f} {:12.1f}\n", result.method, result.found,
                   100.0 * result.found / faces, result.holes, result.microseconds);
    }
}

// Hidden: `croquis bench` is where it belongs.
void add_orientation_command(CLI::App& program, Commands& commands) {
    struct Asked {
        std::string model;
        ViewOptions view;
        int views = FaceOrientationOptions{}.views;
    };
    CLI::App* command = program.add_subcommand("orientation", "Compares ways to tell which faces look at the eye");
    command->group("");
    const auto asked = std::make_shared<Asked>();
    command->add_option("model", asked->model, "Model file")->required();
    asked->view.add_to(*command);
    command->add_option("--views", asked->views, "How many directions, spread evenly")->capture_default_str();
    commands[command] = [asked] {
        FaceOrientationOptions options;
        options.view = asked->view.view();
        options.views = asked->views;
        print_orientation_table(Model::load(asked->model), options);
        return 0;
    };
}

}  // namespace croquis::app
