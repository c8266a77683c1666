// Faces that agree with the normals their file gives.
#pragma once

#include "model/model.h"

namespace croquis::model {

/// Turns faces whose normals look the other way than the winding. `normals` must be as long as `positions`; zero
/// vectors do not count.
///
/// Faces that share an edge and are wound alike are turned together or not at all, by what most of their area wants:
/// at a sharp fold smooth normals may disagree with single faces of a surface that is wound well.
void turn_to_normals(Mesh& mesh);

}  // namespace croquis::model
