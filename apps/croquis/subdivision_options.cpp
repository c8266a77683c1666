#include "subdivision_options.h"

#include <utility>

#include "parse.h"

namespace croquis::app {

void SubdivisionOptions::add_to(CLI::App& command) {
    command.add_option("--subdivide", levels, "Draw the smooth surface after so many subdivisions, 0 to 5")
        ->check(check_whole_number)
        ->capture_default_str();
    command.add_option("--scheme", scheme, "Of subdivision: loop or catmull-clark")->capture_default_str();
}

Model SubdivisionOptions::applied_to(Model model) const {
    return levels == 0 ? std::move(model) : model.subdivided(scheme, levels);
}

}  // namespace croquis::app
