// The area that a model covers in a view, as rings to be filled.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "lines/surface.h"
#include "lines/viewpoint.h"
#include "output/vector_page.h"

namespace croquis::output {

/// The area that the surface covers within the view's frame, in pixels of it, to be filled by the nonzero rule.
///
/// Every face, turned so that its projection winds one way, counts 1 where it lies. The sum over the faces is found
/// from edges alone: an edge between two faces of one turn is passed once in each direction and cancels out;
/// silhouettes and borders remain, and form closed rings. Their winding number is the number of layers at each point,
/// so that holes stay open and parts that overlap or pass through each other need no care.
[[nodiscard]] std::vector<Ring> covered_area(const lines::Surface& surface, const lines::Viewpoint& view);

/// What of a closed ring lies within [0, width] × [0, height]; winding numbers in there are kept.
[[nodiscard]] Ring cut_to_frame(const Ring& ring, double width, double height);

}  // namespace croquis::output
