// The sign on which every decision in the picture rests, exact for every input.
#pragma once

#include <cmath>
#include <glm/vec2.hpp>

namespace croquis::lines {

/// Twice the signed area of the triangle a, b, c with its sign decided exactly, however thin the triangle is: the value
/// is a rounded one, its sign is the true one. Positive when the turn from ab to ac is from the x to the y axis.
[[nodiscard]] double exact_orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c);

/// The same, quickly where rounding cannot have changed the sign (Shewchuk, Adaptive Precision Floating-Point
/// Arithmetic, 1997, gives the bound).
[[nodiscard]] inline double orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    const double left = (b.x - a.x) * (c.y - a.y);
    const double right = (b.y - a.y) * (c.x - a.x);
    const double value = left - right;
    constexpr double bound = 3.3306690738754716e-16;
    if (std::abs(value) > bound * (std::abs(left) + std::abs(right))) return value;
    return exact_orientation(a, b, c);
}

}  // namespace croquis::lines
