// Lines as true curves: cubics where a line bends, straight pieces where it is straight, corners where it has corners
// (SPEC row L13; after P. J. Schneider, "An algorithm for automatically fitting digitized curves", Graphics Gems,
// 1990).
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace croquis::output {

/// A part of a curve, from where the part before it ends.
struct CurvePiece {
    enum class Kind : std::uint8_t { straight, cubic };
    Kind kind = Kind::straight;
    glm::dvec2 leaving{0.0};   ///< a cubic's second control point
    glm::dvec2 arriving{0.0};  ///< its third
    glm::dvec2 end{0.0};
};

/// Pieces that follow each other. The last piece of a closed curve ends at its start.
struct Curve {
    glm::dvec2 start{0.0};
    std::vector<CurvePiece> pieces;
    bool closed = false;
};

/// How far a curve may leave the points that it is fitted to, all in their unit.
struct CurveLimits {
    double tolerance = 0.1;  ///< from a point to the curve
    /// Between two points, a smooth line is taken to bulge by what its turns at both tell. Where that were more than
    /// this the line is straight there, and two straight pieces meet in a corner.
    double bulge = 0.2;
};

/// The curve through points: begins at the first and ends at the last, or closed at the first again. It passes each
/// point within the tolerance and the line between neighbours within the tolerance and the bulge, and has one direction
/// wherever it has no corner.
[[nodiscard]] Curve fit_curve(std::span<const glm::dvec2> points, bool closed, const CurveLimits& limits = {});

}  // namespace croquis::output
