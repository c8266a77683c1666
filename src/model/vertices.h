// A mesh's vertices as a whole: every list that holds one entry a vertex, its rig's among them, kept in step.
#pragma once

#include <cstdint>
#include <span>

#include "model/load.h"

namespace croquis::model {

/// Adds copies of vertices: the n-th new vertex is a copy of `sources[n]`. `rig` may be null.
void append_copies(Mesh& mesh, MeshRig* rig, std::span<const std::uint32_t> sources);

/// Drops the vertices that no triangle names.
void drop_unused_vertices(Mesh& mesh, MeshRig* rig);

/// Makes one vertex of those that are alike in everything. For readers of formats that repeat vertices. A mesh with
/// bones or shapes stays as it is; `rig` may be null.
void join_vertices(Mesh& mesh, MeshRig* rig = nullptr, const Progress& progress = {});

}  // namespace croquis::model
