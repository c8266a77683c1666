#include "shape_options.h"

#include "parse.h"

namespace croquis::app {

void ShapeOptions::add_subdivision_to(CLI::App& command) {
    command.add_option("--subdivide", levels, "Draw the smooth surface after so many subdivisions, 0 to 5")
        ->check(check_whole_number)
        ->capture_default_str();
    command.add_option("--scheme", scheme, "Of subdivision: loop or catmull-clark")->capture_default_str();
}

void ShapeOptions::add_simplification_to(CLI::App& command) {
    command
        .add_option("--simplify", triangles,
                    "Draw the model, subdivided where that is asked, in so many triangles, where it has more")
        ->check(check_whole_number);
}

Model ShapeOptions::applied_to(Model model) const {
    if (levels != 0) model = model.subdivided(scheme, levels);
    if (triangles) model = model.simplified(*triangles);
    return model;
}

}  // namespace croquis::app
