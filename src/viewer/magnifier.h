// A lens at the mouse that shows the pixels of the picture, and their values (seed B, chapter 5).
//
// The seed copies 128 x 128 pixels around the mouse onto a sphere by OpenGL's sphere map. For the sphere's normal n and
// the viewing direction u = (0, 0, -1), the reflection r = u - 2 n (n·u) gives m = 2 √(r_x² + r_y² + (r_z + 1)²) = 4
// n_z, so that s = r_x / m + 1/2 = n_x / 2 + 1/2: linear in the place on the disc. Its sphere is a round, even lens,
// and so is this one; only the square lens is ours.
#pragma once

#include "viewer/canvas.h"

namespace croquis::viewer {

class Magnifier {
public:
    enum class Shape { round, square };

    void hold() { is_held_ = true; }
    void release() { is_held_ = false; }
    [[nodiscard]] bool is_held() const { return is_held_; }

    [[nodiscard]] Shape shape() const { return shape_; }
    void set_shape(Shape shape) { shape_ = shape; }

    /// 1.5 times, as the seed has it, to 16 times.
    [[nodiscard]] double factor() const { return factor_; }
    void zoom(double notches);

    /// Draws the lens over everything, about the mouse. `pixels_a_point` is how many pixels of the canvas one point of
    /// the user interface has.
    void show(const Canvas& canvas, double pixels_a_point) const;

private:
    bool is_held_ = false;
    Shape shape_ = Shape::round;
    double factor_ = 4;
};

}  // namespace croquis::viewer
