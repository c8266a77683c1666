// Whether a point lies in a filled area, by adding up angles: no crossing rule that could share a mistake.
#pragma once

#include <cmath>
#include <span>

#include "output/vector_page.h"

namespace croquis::test_support {

/// How often rings wind around a point, from the angle that each piece covers.
inline int winding_number(std::span<const output::Ring> rings, const glm::dvec2& point) {
    double angle = 0;
    for (const output::Ring& ring : rings) {
        for (std::size_t i = 0; i < ring.points.size(); ++i) {
            const glm::dvec2 a = ring.points[i] - point, b = ring.points[(i + 1) % ring.points.size()] - point;
            angle += std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
        }
    }
    return int(std::lround(angle / (2 * 3.14159265358979323846)));
}

/// The distance from a point to the nearest piece of some rings.
inline double distance_to(std::span<const output::Ring> rings, const glm::dvec2& point) {
    double nearest = 1e30;
    for (const output::Ring& ring : rings) {
        for (std::size_t i = 0; i < ring.points.size(); ++i) {
            const glm::dvec2 a = ring.points[i], along = ring.points[(i + 1) % ring.points.size()] - a;
            const double square = along.x * along.x + along.y * along.y;
            const glm::dvec2 from = point - a;
            const double share =
                square > 0 ? std::fmin(std::fmax((from.x * along.x + from.y * along.y) / square, 0.0), 1.0) : 0.0;
            nearest = std::fmin(nearest, std::hypot(from.x - share * along.x, from.y - share * along.y));
        }
    }
    return nearest;
}

}  // namespace croquis::test_support
