// Curves in which faces pass through each other (SPEC row L15).
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "lines/surface.h"

namespace croquis::lines {

/// A straight piece of a curve: where two faces meet that have no edge in common.
struct CutSegment {
    std::array<std::uint32_t, 2> faces;  ///< the smaller first
    std::array<std::uint32_t, 2> nodes;
};

/// An end of cut segments. Segments that end where the same edge passes through the same face share their node; so do
/// those that end at the same vertex.
struct CutNode {
    glm::dvec3 point;  ///< scene space, on the edge
    std::uint32_t edge = 0;
    std::uint32_t face = 0;  ///< model::no_face where two faces that share a vertex begin to cut each other: at that
                             ///< vertex of the edge
};

/// Segments in the order of their faces, nodes in that of their edges.
struct CutCurves {
    std::vector<CutNode> nodes;
    std::vector<CutSegment> segments;
    bool is_tangle = false;  ///< too many faces lie close together; then there are no segments
};

/// All curves in which faces of the surface pass through each other. Independent of the view and of the number of
/// threads. Time and memory grow with the faces, and with the pairs of faces whose boxes overlap; where these are more
/// than some dozens a face, as in a heap of random triangles, the search gives up.
///
/// Curves close, or end where a border passes through a face or faces begin to cut at a vertex that they share: the
/// question is decided exactly for points moved by half a rounding of single precision (GeneralPosition). Faces that
/// touch within that rounding do not pass through each other, and give nothing: flush walls, a box on a table, a tip on
/// a plane, a face that stands in the model twice. A vertex or edge that lies in a face counts if the surface goes on
/// behind the face; so a cylinder is cut by the plate through it also where its vertices lie in the plate.
[[nodiscard]] CutCurves find_cut_curves(const Surface& surface);

}  // namespace croquis::lines
