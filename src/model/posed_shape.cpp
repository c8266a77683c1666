#include "model/posed_shape.h"

#include <glm/geometric.hpp>

#include "model/welding.h"

namespace croquis::model {

PosedShape posed_shape(const Model& model, const Pose* pose) {
    const Topology& topology = model.topology();
    if (pose == nullptr) return {topology.positions, topology.face_normals};
    std::vector<std::span<const glm::vec3>> at_rest;
    for (const Mesh& mesh : model.meshes) at_rest.emplace_back(mesh.positions);
    const WeldedPoints welded = weld_points(at_rest);
    PosedShape shape;
    shape.positions.resize(topology.positions.size());
    for (std::size_t m = 0; m < model.meshes.size(); ++m) {
        const std::vector<glm::vec3>& moved = (*pose)[m].positions;
        for (std::size_t v = 0; v < moved.size(); ++v)
            shape.positions[welded.ids[welded.first_of_list[m] + v]] = moved[v];
    }
    for (const Face& face : topology.faces) {
        const glm::dvec3 a(shape.positions[face.vertices[0]]), b(shape.positions[face.vertices[1]]),
            c(shape.positions[face.vertices[2]]);
        const glm::dvec3 area = area_vector(a, b, c);
        const double length = glm::length(area);
        shape.face_normals.push_back(length > 0 ? glm::vec3(area / length) : glm::vec3(0.0f));
    }
    return shape;
}

}  // namespace croquis::model
