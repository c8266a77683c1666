// The crossbars of a stroke: where they reach to on both sides, so that none crosses another at a bend (seed D, section
// 4, leaves such crossings as they are).
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "lines/stroke.h"

namespace croquis::lines {

/// A crossbar. At a bend it is two arms of different directions.
struct Crossbar {
    glm::dvec2 centre{0.0};  ///< on the spine, pixels
    glm::dvec2 left{0.0}, right{0.0};
    double along = 0;         ///< of the centre; beyond the spine's length in a round end
    double half_width = 0;    ///< of the stroke there; an arm may be shorter
    std::uint32_t point = 0;  ///< of the stroke: the one whose depth and colour it has
};

/// The crossbars of a stroke from its beginning to its end; a closed one's first stands at the end again. Empty where
/// the stroke has no length.
[[nodiscard]] std::vector<Crossbar> crossbars_of(std::span<const StrokePoint> points, bool closed, StrokeEnds ends);

}  // namespace croquis::lines
