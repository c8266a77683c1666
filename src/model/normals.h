// Vertex normals where a file has none (seed A, 2.2.2; seed C, 3.3.2).
#pragma once

#include <vector>

#include "model/load.h"

namespace croquis::model {

/// Computes every vertex normal that is the zero vector, and those of `rig` likewise; lists of normals must be as long
/// as their positions. All meshes are taken together, so that a surface cut into several meshes, or a file that repeats
/// its vertices, is still smooth. `rig` may be empty.
///
/// A normal is the mean of the normals of the faces around the vertex, weighted by their angles there, taken over the
/// fan of faces that hang together by smooth edges. An edge is smooth where its two faces share a smoothing group or,
/// without groups, where their normals lie within `crease_angle`. A vertex on several fans is split.
///
/// Triangles must be in range and have an area at rest.
void complete_normals(std::vector<RawMesh>& meshes, Rig& rig, float crease_angle, const Progress& progress = {});

}  // namespace croquis::model
