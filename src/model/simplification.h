// Levels of detail: the same model in fewer faces (seed A, 2.4.2), through meshoptimizer. Carefully, by collapsing
// edges in the order of their quadric errors (Garland and Heckbert 1997); or roughly, by clustering vertices in the
// cells of a grid (Rossignac and Borrel 1993), each cell by the vertex of least quadric error.
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

/// A rough copy of about so many triangles, without a look at the model's topology: for very large models. Each mesh is
/// clustered on its own and gets triangles by its share; one of a few triangles stays as it is. Vertices that are left
/// stay where they were, with all that they carry; normals are those of the fine surface. Throws Error for 0 triangles,
/// and where nothing would be left.
[[nodiscard]] std::shared_ptr<const Model> clustered(const std::shared_ptr<const Model>& model, std::size_t triangles);

}  // namespace croquis::model
