// Silhouettes of parallel projections by the Gauss map (seed E, section 10.3.2; SPEC row L4).
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "lines/silhouette_finder.h"

namespace croquis::lines {

/// The bins on the sphere of directions: sides of an icosahedron, split four to one again and again.
enum class GaussBins : std::uint8_t {
    separate,     ///< the spherical triangles themselves: an arc across a boundary stays at a level above
    overlapping,  ///< circles around them, half as large again: neighbours share a margin
};

/// The whole sphere, then 20, 80, 320 and 1280 triangles.
constexpr std::size_t gauss_map_levels = 5;

/// An edge is an arc on the sphere, between its faces' normals; in a parallel projection it is a silhouette when the
/// great circle of directions across the view cuts that arc. Arcs are kept in the smallest bin that holds them; bins
/// beside the circle are passed over. A perspective view throws Error: there, each point has a circle of its own.
[[nodiscard]] std::unique_ptr<SilhouetteFinder> make_gauss_map_finder(const Surface& surface, GaussBins bins);

/// How many arcs are kept at each level (seed E, table 2).
[[nodiscard]] std::array<std::size_t, gauss_map_levels> gauss_map_counts(const Surface& surface, GaussBins bins);

}  // namespace croquis::lines
