// Fine crosshatching's geometry: triangles split along shadow lines, so that each piece has one level of shade (seed B,
// chapter 4, "'Fine' Crosshatching"). Drawings on the screen find the same pieces pixel by pixel
// (hatching_levels.glsl); this is their reference.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

namespace croquis::model {

/// A corner with the cosine of the angle between its normal and the light, which is linear in between (equation 4.5).
struct ShadeCorner {
    glm::dvec3 position;
    double cosine = 0;
};

using ShadeTriangle = std::array<ShadeCorner, 3>;

struct ShadePiece {
    ShadeTriangle corners;
    int level = 0;               ///< how many thresholds its cosines lie above
    std::uint32_t triangle = 0;  ///< that it is a piece of
};

/// How many of the thresholds, which ascend, a cosine has reached.
[[nodiscard]] int shade_level(double cosine, std::span<const double> thresholds);

/// The pieces of a triangle. A triangle, or piece, with no side longer than `smallest_split` is not split: it has the
/// level of its barycentre, as in simple crosshatching. Zero: all are split until their level is one.
[[nodiscard]] std::vector<ShadePiece> split_by_shade(const ShadeTriangle& triangle, std::span<const double> thresholds,
                                                     double smallest_split);

/// What to split: a mesh, and its light as a position (w = 1) or the direction to it (w = 0).
struct LitSurface {
    std::span<const glm::vec3> positions;
    std::span<const glm::vec3> normals;
    std::span<const std::uint32_t> triangles;
    glm::dvec4 light{0.0, 0.0, 1.0, 0.0};
};

/// The pieces of all triangles, in their order.
[[nodiscard]] std::vector<ShadePiece> split_by_shade(const LitSurface& surface, std::span<const double> thresholds,
                                                     double smallest_split);

}  // namespace croquis::model
