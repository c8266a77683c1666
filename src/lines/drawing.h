// A drawing in lines: what finding, visibility and chaining come to, and what strokes and files start from.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "lines/line_class.h"

namespace croquis::lines {

/// A point of a line.
struct LinePoint {
    glm::dvec2 position{0.0};  ///< pixels, from the frame's upper left corner; y points down
    double depth = 0;          ///< eye distance along the direction of looking, in scene units
    glm::vec3 normal{0.0f};    ///< of the surface there, unit, in world axes; the mean of the edge's faces
};

/// A chain of edges of one class, mesh and visibility: a long curve wherever the model has one.
struct Line {
    LineClass line_class = LineClass::silhouette;
    std::uint32_t mesh = 0;    ///< index into the model's meshes
    std::uint32_t layers = 0;  ///< how many layers of surface hide it; 0: visible
    bool closed = false;       ///< the last point is joined to the first, which is not repeated
    std::uint32_t first_point = 0;
    std::uint32_t point_count = 0;

    [[nodiscard]] bool visible() const { return layers == 0; }
};

/// All lines of a view, in pixels of its frame. What lies outside the frame is cut off.
struct Drawing {
    double width = 0;  ///< of the frame, pixels
    double height = 0;
    std::vector<Line> lines;
    std::vector<LinePoint> points;  ///< of all lines

    [[nodiscard]] std::span<const LinePoint> points_of(const Line& line) const {
        return std::span(points).subspan(line.first_point, line.point_count);
    }
};

/// Length in pixels, with the closing piece of a closed line.
[[nodiscard]] double length_of(const Drawing& drawing, const Line& line);

}  // namespace croquis::lines
