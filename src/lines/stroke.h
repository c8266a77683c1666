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

/// How an open stroke ends.
enum class StrokeEnds : std::uint8_t {
    round,  ///< with half a disc, which also fills the gaps between lines that meet (seed E, 10.4)
    butt,   ///< square, at the last point
};

/// What strokes are laid down with, besides what their points say.
struct Brush {
    StrokeEnds ends = StrokeEnds::round;
    /// The name of an image that runs along the spine and repeats; black leaves all of the stroke's colour, white none.
    /// Empty: an even stroke.
    std::string texture;
};

/// An unbroken piece of a stroke. Line breaks of an offset file, dashes, corners and repetitions make several of one
/// line.
struct Stroke {
    std::uint32_t line = 0;  ///< of the drawing: its class, mesh and layers
    bool closed = false;     ///< the last point is joined to the first, which is not repeated
    std::uint32_t first_point = 0;
    std::uint32_t point_count = 0;
    std::uint32_t brush = 0;  ///< of the strokes' brushes
};

/// All strokes of a drawing, in the order in which they are painted: lines behind most layers first, contours last.
struct Strokes {
    std::vector<Stroke> strokes;
    std::vector<StrokePoint> points;
    std::vector<Brush> brushes{Brush{}};

    [[nodiscard]] std::span<const StrokePoint> points_of(const Stroke& stroke) const {
        return std::span(points).subspan(stroke.first_point, stroke.point_count);
    }
};

}  // namespace croquis::lines
