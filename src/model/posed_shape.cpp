#include "model/posed_shape.h"

#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "model/welding.h"

namespace croquis::model {

PosedShape posed_shape(const Model& model, const Pose* pose) {
    const Topology& topology = model.topology();
    PosedShape shape;
    shape.positions = pose == nullptr ? topology.positions : posed_positions(model, *pose);
    shape.face_normals.resize(topology.faces.size());
    parallel_for(topology.faces.size(), 8192, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
            const auto& [a, b, c] = topology.faces[f].vertices;
            const glm::dvec3 area = area_vector(shape.positions[a], shape.positions[b], shape.positions[c]);
            const double length = glm::length(area);
            shape.face_normals[f] = length > 0 ? glm::vec3(area / length) : glm::vec3(0.0f);
        }
    });
    return shape;
}

std::vector<glm::vec3> posed_positions(const Model& model, const Pose& pose) {
    const Topology& topology = model.topology();
    std::vector<std::span<const glm::vec3>> at_rest;
    for (const Mesh& mesh : model.meshes) at_rest.emplace_back(mesh.positions);
    const WeldedPoints welded = weld_points(at_rest);
    std::vector<glm::vec3> positions(topology.positions.size());
    for (std::size_t m = 0; m < model.meshes.size(); ++m) {
        const std::vector<glm::vec3>& moved = pose[m].positions;
        for (std::size_t v = 0; v < moved.size(); ++v) {
            const std::uint32_t id = welded.ids[welded.first_of_list[m] + v];
            positions[topology.sewn.empty() ? id : topology.sewn[id]] = moved[v];
        }
    }
    return positions;
}

}  // namespace croquis::model
