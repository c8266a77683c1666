// One view, or several on one sheet as technical drawings arrange them.
#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "croquis/lines.h"
#include "lines/surface.h"
#include "lines/viewpoint.h"

namespace croquis {

/// A view and where its own frame lies in that of the drawing.
struct PlacedView {
    std::string name;  ///< empty where there is but one view
    lines::Viewpoint viewpoint;
    glm::dvec2 corner{0.0};       ///< of its frame in the drawing's, pixels
    glm::dvec2 label_place{0.0};  ///< the middle of its label's foot, pixels
    double label_height = 0;
};

/// Throws Error for a view that cannot be placed.
[[nodiscard]] std::vector<PlacedView> place_views(const lines::Surface& surface, const model::Pose* pose,
                                                  const LineOptions& options);

}  // namespace croquis
