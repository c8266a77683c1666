// What a person types, as values: every form with an error that says what was expected.
#pragma once

#include <string>

#include "croquis/croquis.h"

namespace croquis::app {

/// "1,0.7,1". `what` names it in errors: "--eye".
[[nodiscard]] Vector3 parse_vector(const std::string& text, const std::string& what);

struct Size {
    int width = 0;
    int height = 0;
};
/// "1024x768".
[[nodiscard]] Size parse_size(const std::string& text, const std::string& what);

/// "0.2,0.4,1", "#3366ff", "#36f", or one of the names white, black, grey, red, green, blue, yellow.
[[nodiscard]] Vector3 parse_color(const std::string& text, const std::string& what);

/// A named view or a direction.
[[nodiscard]] Vector3 parse_view(const std::string& text);

/// "X,Y,Z" or "world:X,Y,Z" (towards the light), "viewer:X,Y,Z" (the same along the camera's axes), "point:X,Y,Z".
[[nodiscard]] Light parse_light(const std::string& text);

/// "transparent", a colour, or an image of the data folder as directory:image.
[[nodiscard]] Background parse_background(const std::string& text);

/// "2" or "2,40": the largest mean and, after a comma, the largest single difference that passes.
[[nodiscard]] Picture::Difference parse_threshold(const std::string& text);

/// What is wrong with text that should be a finite number, or nothing: for CLI::Option::check.
[[nodiscard]] std::string check_number(const std::string& text);

/// The same for a number of digits alone.
[[nodiscard]] std::string check_whole_number(const std::string& text);

}  // namespace croquis::app
