// Strokes: lines with width, colour and hand. One description feeds the GPU's strips and the vector files alike
// (seed D, section 4; SPEC rows L9 and L11).
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lines/drawing.h"

namespace croquis::lines {

/// A point of a stroke's spine.
struct StrokePoint {
    glm::dvec2 position{0.0};                 ///< pixels, from the frame's upper left corner; y points down
    float depth = 0;                          ///< eye distance, scene units
    float width = 1;                          ///< whole width across the spine, pixels
    glm::vec4 color{0.0f, 0.0f, 0.0f, 1.0f};  ///< red, green, blue, opacity; not multiplied
    float along = 0;                          ///< length of the spine up to here, pixels
};

/// An unbroken piece of a stroke. Line breaks of an offset file and dashes make several of one line.
struct Stroke {
    std::uint32_t line = 0;  ///< of the drawing: its class, mesh and layers
    bool closed = false;
    std::uint32_t first_point = 0;
    std::uint32_t point_count = 0;
};

/// All strokes of a drawing.
struct Strokes {
    std::vector<Stroke> strokes;
    std::vector<StrokePoint> points;

    [[nodiscard]] std::span<const StrokePoint> points_of(const Stroke& stroke) const {
        return std::span(points).subspan(stroke.first_point, stroke.point_count);
    }
};

}  // namespace croquis::lines
