// Closing seams whose two sides differ in their last digits.
#pragma once

#include <cstdint>
#include <vector>

#include "model/topology.h"

namespace croquis::model {

/// How far apart the ends of two borders may be to be sewn, as a share of the diagonal of the model's box: what single
/// precision leaves of points that were computed twice.
constexpr double seam_width = 1e-6;

/// Which vertices are one when borders that coincide are sewn together: each vertex's new number, or nothing where
/// nothing is to be sewn. New numbers keep the order of the first vertices; those take the place of the others.
///
/// Two border edges are sewn when both pairs of ends lie within `seam_width` of each other, the faces are wound alike
/// across them, each edge is at least 16 seam widths long, and neither has a second such partner. A sewing that would
/// bring two corners of a face together is left out. So nothing but borders is ever touched, closed models stay as
/// they are, and which edges are sewn does not depend on their order.
[[nodiscard]] std::vector<std::uint32_t> sewn_vertices(const Topology& topology);

}  // namespace croquis::model
