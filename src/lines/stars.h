// What the faces around a vertex hide of the edges that end there: the only place, beside crossings, where the number
// of layers over a line can change (seed D, "Silhouettes and cusps").
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lines/image_edges.h"
#include "lines/surface.h"
#include "lines/viewpoint.h"

namespace croquis::lines {

/// For each image edge, how many faces at its ends a and b hide the edge right there. A vertex where that differs
/// between two edges is a cusp, of the plain, the border or the "exotic" kind alike; at vertices that can be none,
/// where only differences matter, 0 stands for whatever it is.
[[nodiscard]] std::vector<std::array<std::int16_t, 2>> layers_at_ends(const Surface& surface, const Viewpoint& view,
                                                                      const ImageEdges& edges);

}  // namespace croquis::lines
