// Drawings for machines that pull a pen over paper: few, long paths in an order that lifts the pen little (SPEC row
// L13).
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "output/vector_page.h"

namespace croquis::output {

/// What a plotter can tell apart, in millimetres.
struct PlotterOptions {
    double join_distance = 0.02;      ///< ends nearer than this meet
    double line_tolerance = 0.005;    ///< a point this near to the line between its neighbours is none
    double overlap_tolerance = 0.02;  ///< pieces along each other nearer than this are drawn once
};

/// Makes ready what one pen draws: points that say nothing go, what lies upon another line is drawn once, paths are
/// joined end to end where they meet, and then ordered and turned round so that the pen travels little while it is up:
/// nearest neighbour, then 2-opt and Or-opt. It starts at `start`, the sheet's upper left corner. The same rings give
/// the same result.
[[nodiscard]] std::vector<Ring> plan_pen(std::vector<Ring> rings, const glm::dvec2& start = glm::dvec2(0.0),
                                         const PlotterOptions& options = {});

/// How far the pen travels up, from `start` to the last ring.
[[nodiscard]] double travel_of(std::span<const Ring> rings, const glm::dvec2& start = glm::dvec2(0.0));

/// Where the pen stands when it has drawn a ring.
[[nodiscard]] const glm::dvec2& end_of(const Ring& ring);

/// How far it draws.
[[nodiscard]] double ink_of(std::span<const Ring> rings);

/// The steps of `plan_pen`.
void drop_idle_points(std::vector<Ring>& rings, double line_tolerance);
void drop_overlaps(std::vector<Ring>& rings, double overlap_tolerance);
void join_ends(std::vector<Ring>& rings, double join_distance);
void order_rings(std::vector<Ring>& rings, const glm::dvec2& start = glm::dvec2(0.0));

}  // namespace croquis::output
