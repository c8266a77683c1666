// A lens at the mouse that shows the pixels of the picture, and their values (seed B, chapter 5). The seed's lens is
// the sphere (sphere_lens.h); the round and the square one are ours, flat, so that every pixel has the same size in
// them.
#pragma once

#include "viewer/canvas.h"

namespace croquis::viewer {

class Magnifier {
public:
    enum class Shape { round, square, sphere };

    void hold() { is_held_ = true; }
    void release() { is_held_ = false; }
    [[nodiscard]] bool is_held() const { return is_held_; }

    [[nodiscard]] Shape shape() const { return shape_; }
    /// Round, square, sphere and round again.
    void take_next_shape();

    /// 1.5 times, as the seed has it, to 16 times; of the sphere that in its middle.
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
