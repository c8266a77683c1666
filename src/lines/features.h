// The lines of a surface that do not depend on the view: creases, material boundaries, tagged edges, borders, and
// where faces pass through each other.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lines/cut_curves.h"
#include "lines/line_class.h"
#include "lines/surface.h"

namespace croquis::lines {

/// An edge that is a line in every view.
struct Feature {
    std::uint32_t edge = 0;
    LineClass line_class = LineClass::crease;
};

/// An edge that is not regular (Surface::irregular_edges), with all its faces.
struct IrregularEdge {
    std::uint32_t edge = 0;
    std::uint32_t first_face = 0;  ///< in Features::irregular_faces
    std::uint32_t face_count = 0;
    /// What it is when it is no silhouette: border, crease or another; nothing when it is then no line.
    LineClass line_class = LineClass::border;
    bool is_feature = false;
};

struct Features {
    /// Finds those of the asked classes. The crease angle is in radians.
    Features(const Surface& surface, LineClasses classes, double crease_angle);

    std::vector<Feature> regular;          ///< in ascending order of edges
    std::vector<IrregularEdge> irregular;  ///< all irregular edges, in ascending order
    std::vector<std::uint32_t> irregular_faces;
    CutCurves cuts;
    float crease_cosine = 0;  ///< of the largest angle that makes no crease

    [[nodiscard]] std::span<const std::uint32_t> faces_of(const IrregularEdge& edge) const {
        return std::span(irregular_faces).subspan(edge.first_face, edge.face_count);
    }
};

/// The face's corner that is not on the edge.
[[nodiscard]] std::uint32_t corner_opposite(const model::Face& face, const model::Edge& edge);

/// True when the face's winding passes from the edge's first vertex to its second.
[[nodiscard]] bool winds_along(const model::Face& face, const model::Edge& edge);

}  // namespace croquis::lines
