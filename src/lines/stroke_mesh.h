// Strokes as areas: ribbons of triangles with texture coordinates along the spine, and outlines to be filled (seed D,
// section 4).
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "lines/stroke.h"

namespace croquis::lines {

struct StrokeVertex {
    glm::vec2 position{0.0f};  ///< pixels, from the frame's upper left corner; y points down
    float depth = 0;           ///< eye distance, scene units
    glm::vec2 texture{0.0f};   ///< x: along the spine, 1 after each length of the image; y: across, 0 left to 1 right
    glm::vec4 color{0.0f, 0.0f, 0.0f, 1.0f};  ///< of the spine there; not multiplied
};

/// The triangles of one brush's strokes that follow each other.
struct StrokeMeshPart {
    std::uint32_t brush = 0;  ///< of the strokes
    std::uint32_t first_index = 0;
    std::uint32_t index_count = 0;
};

struct StrokeMesh {
    std::vector<StrokeVertex> vertices;
    std::vector<std::uint32_t> indices;  ///< three a triangle, turning either way
    std::vector<StrokeMeshPart> parts;   ///< in painting order
};

/// Width over height of the image of a name, to keep its proportions: it is as long along the spine as its height
/// laid across the stroke's greatest width makes it.
using TextureAspect = std::function<double(const std::string& texture)>;

/// Ribbons for all strokes. At a bend tighter than half the width the crossbars of the inner side meet in one point, so
/// that no triangle of a bend covers another; the outer side is rounded. Strokes that come back over themselves still
/// overlap there. Uses several threads; the result does not depend on how many.
[[nodiscard]] StrokeMesh make_stroke_mesh(const Strokes& strokes, const TextureAspect& aspect = {});

/// A closed ring of points, pixels.
using Ring = std::vector<glm::dvec2>;

/// The area of a stroke as polygons to be filled by the nonzero rule: one ring for an open stroke, two for a closed
/// one. Joins and round ends are arcs of points within `tolerance` pixels.
[[nodiscard]] std::vector<Ring> outline_of(const Strokes& strokes, const Stroke& stroke, double tolerance = 0.05);

}  // namespace croquis::lines
