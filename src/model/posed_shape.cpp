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

std::vector<std::uint32_t> topology_vertices(const Model& model) {
    const std::vector<std::uint32_t>& sewn = model.topology().sewn;
    std::vector<std::span<const glm::vec3>> at_rest;
    for (const Mesh& mesh : model.meshes) at_rest.emplace_back(mesh.positions);
    std::vector<std::uint32_t> vertices = weld_points(at_rest).ids;
    if (!sewn.empty()) {
        for (std::uint32_t& vertex : vertices) vertex = sewn[vertex];
    }
    return vertices;
}

std::vector<glm::vec3> posed_positions(const Model& model, const Pose& pose) {
    std::vector<glm::vec3> positions(model.topology().positions.size());
    const std::vector<std::uint32_t> vertices = topology_vertices(model);
    auto vertex = vertices.begin();
    for (const MeshPose& mesh : pose) {
        for (const glm::vec3& moved : mesh.positions) positions[*vertex++] = moved;
    }
    return positions;
}

}  // namespace croquis::model
