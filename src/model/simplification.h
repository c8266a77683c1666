// Levels of detail: the same model in fewer faces (seed A, 2.4.2). Edges are collapsed in the order of their quadric
// errors (Garland and Heckbert 1997), through meshoptimizer.
#pragma once

#include <cstddef>
#include <memory>

#include "model/model.h"

namespace croquis::model {

/// The model in so many triangles, give or take 3 %; the model itself where it has no more.
///
/// All meshes are taken as one surface, so that they stay together where they touch. A vertex that is left stays where
/// it was and keeps its texture coordinate, colour and normals: of several normals each face takes the one that is
/// nearest to its own. So nothing leaves the model's bounds, and rigs and clips serve as before. A closed surface stays
/// closed; borders, edges between meshes and seams of texture coordinates and colours are thinned out along themselves.
///
/// Vertices that coincide at rest are taken for one, and shapes of a clip are not looked at. Tagged edges whose
/// vertices go are lost.
///
/// Throws Error for 0 triangles, and where borders and seams leave too little to collapse.
[[nodiscard]] std::shared_ptr<const Model> simplified(const std::shared_ptr<const Model>& model, std::size_t triangles);

}  // namespace croquis::model
