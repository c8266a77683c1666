// Surfaces and views for measuring the finding of lines.
#pragma once

#include <memory>

#include "lines/viewpoint.h"
#include "model/model.h"

namespace croquis::bench {

/// An octahedron's sides cut into 8 n² triangles and brought onto a sphere; each vertex moved out by up to `noise`
/// times the length of an edge.
[[nodiscard]] std::shared_ptr<const model::Model> sphere(int n, double noise);

/// A turn by a degree a view, from a little above, of the whole scene in a frame of 1024 pixels.
[[nodiscard]] lines::Viewpoint turned(int degrees, model::Projection projection);

}  // namespace croquis::bench
