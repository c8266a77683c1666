// The welded topology's points and face normals at rest or in a pose; who touches whom never changes.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "model/animation.h"
#include "model/model.h"

namespace croquis::model {

struct PosedShape {
    std::vector<glm::vec3> positions;     ///< one a welded vertex
    std::vector<glm::vec3> face_normals;  ///< one a face, unit; zero for a face that the pose has folded to nothing
};

/// The shape of `model.topology()` at rest (`pose` null) or in a pose.
[[nodiscard]] PosedShape posed_shape(const Model& model, const Pose* pose);

/// The points of `model.topology()` in a pose.
[[nodiscard]] std::vector<glm::vec3> posed_positions(const Model& model, const Pose& pose);

/// The vertex of `model.topology()` that each vertex of each mesh is, the meshes' vertices in turn.
[[nodiscard]] std::vector<std::uint32_t> topology_vertices(const Model& model);

}  // namespace croquis::model
