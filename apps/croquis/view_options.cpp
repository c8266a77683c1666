#include "view_options.h"

#include <vector>

#include "base/error.h"
#include "base/names.h"
#include "parse.h"

namespace croquis::app {

void ViewOptions::add_to(CLI::App& command) {
    command
        .add_option("--view", direction,
                    "Direction from the box's centre to the eye, X,Y,Z, or front, back, left, right, top, bottom, iso")
        ->capture_default_str();
    command.add_option("--fit", fit, "Share of the frame that every vertex lies within")
        ->check(check_number)
        ->capture_default_str();
    command.add_option("--eye", eye, "Position of the eye, X,Y,Z, in place of --view and --fit");
    command.add_option("--target", target, "Point looked at, X,Y,Z; the box's centre where none is named");
    command.add_option("--up", up, "Direction that points up in the picture")->capture_default_str();
    command.add_option("--fov", field_of_view, "Field of view of the frame's height, degrees")
        ->check(check_number)
        ->capture_default_str();
    command.add_option("--projection", projection, "perspective or parallel")->capture_default_str();
    command.add_option("--animation", animation, "Name of one of the model's animations");
    command.add_option("--time", time, "Seconds into the animation")->check(check_number)->capture_default_str();
}

View ViewOptions::view() const {
    View view;
    view.direction = parse_view(direction);
    view.fit = fit;
    if (!eye.empty()) view.eye = parse_vector(eye, "--eye");
    if (!target.empty()) view.target = parse_vector(target, "--target");
    view.up = parse_vector(up, "--up");
    view.field_of_view = field_of_view;
    if (projection != "perspective" && projection != "parallel") {
        const std::vector<std::string> known{"perspective", "parallel"};
        fail("--projection: expected perspective or parallel, found \"{}\"{}", projection,
             suggestion(projection, known));
    }
    view.parallel = projection == "parallel";
    return view;
}

}  // namespace croquis::app
