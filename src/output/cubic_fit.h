// Few cubics through many points of a smooth line.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "output/curves.h"

namespace croquis::output {

/// A cubic in Bernstein's form.
struct Cubic {
    std::array<glm::dvec2, 4> control;

    [[nodiscard]] glm::dvec2 at(double t) const {
        const double s = 1 - t;
        return s * s * s * control[0] + 3 * s * s * t * control[1] + 3 * s * t * t * control[2] +
               t * t * t * control[3];
    }
    /// The first derivative by t.
    [[nodiscard]] glm::dvec2 slope(double t) const {
        const double s = 1 - t;
        return 3.0 * (s * s * (control[1] - control[0]) + 2 * s * t * (control[2] - control[1]) +
                      t * t * (control[3] - control[2]));
    }
    /// The second.
    [[nodiscard]] glm::dvec2 bend(double t) const {
        return 6.0 * ((1 - t) * (control[2] - 2.0 * control[1] + control[0]) +
                      t * (control[3] - 2.0 * control[2] + control[1]));
    }
};

/// A point of a smooth line and its direction there, of length 1.
struct CurveSample {
    glm::dvec2 position{0.0};
    glm::dvec2 direction{0.0};
};

/// Appends pieces that pass every sample within the tolerance; they begin and end at the first and the last, and have
/// the samples' directions wherever they begin or end.
void fit_cubics(std::span<const CurveSample> samples, double tolerance, std::vector<CurvePiece>& pieces);

}  // namespace croquis::output
