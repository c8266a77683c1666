// The sheet of paper: where on it the pixels of a drawing's frame lie.
#pragma once

#include <glm/vec2.hpp>

namespace croquis::output {

constexpr double mm_per_screen_pixel = 25.4 / 96.0;  ///< CSS's pixel: what a drawing measures that names no paper

/// A sheet and its free edge, in millimetres.
struct Paper {
    double width = 0;  ///< 0: as large as the frame at 96 pixels to the inch, and the margin around it
    double height = 0;
    double margin = 0;
};

/// A frame of pixels on a sheet.
struct Sheet {
    double width = 0;  ///< millimetres
    double height = 0;
    double mm_per_pixel = mm_per_screen_pixel;
    glm::dvec2 origin{0.0};  ///< of the frame's upper left corner

    [[nodiscard]] glm::dvec2 place(const glm::dvec2& pixel) const { return origin + mm_per_pixel * pixel; }
};

/// The frame as large as it goes within the margins, in their middle.
[[nodiscard]] Sheet lay_out(const Paper& paper, double frame_width, double frame_height);

}  // namespace croquis::output
