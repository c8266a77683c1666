#include "model/control_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/welding.h"

namespace croquis::model {
namespace {

glm::dvec3 unit_normal(const Topology& topology, std::uint32_t face) {
    const auto& [a, b, c] = topology.faces[face].vertices;
    return glm::normalize(area_vector(topology.positions[a], topology.positions[b], topology.positions[c]));
}

/// Edges that bend the surface by more than an angle.
void add_creases(ControlMesh& control, const Topology& topology, double angle) {
    const double cosine = std::cos(angle);
    for (const Edge& edge : topology.edges) {
        if (edge.faces[1] == no_face) continue;
        if (glm::dot(unit_normal(topology, edge.faces[0]), unit_normal(topology, edge.faces[1])) >= cosine) continue;
        for (const std::uint32_t v : edge.vertices) control.sharp.push_back(static_cast<int>(v));
    }
}

/// The looks of all render vertices, and which of them each face's corners have.
void add_looks(ControlMesh& control, const Model& model) {
    const auto has_look = [](const Mesh& mesh) { return !mesh.texcoords.empty() || !mesh.colors.empty(); };
    if (std::none_of(model.meshes.begin(), model.meshes.end(), has_look)) return;
    control.look_of_corner.reserve(control.corners.size());
    for (const Mesh& mesh : model.meshes) {
        const std::size_t first = control.looks.size();
        control.looks.resize(first + mesh.positions.size());
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            if (!mesh.texcoords.empty()) control.looks[first + v].texcoord = mesh.texcoords[v];
            if (!mesh.colors.empty()) control.looks[first + v].color = mesh.colors[v];
        }
        for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
            const std::uint32_t* const corner = &mesh.triangles[3 * t];
            const auto& p = mesh.positions;
            if (!has_area(p[corner[0]], p[corner[1]], p[corner[2]])) continue;  // no face of the topology
            for (int k = 0; k < 3; ++k) control.look_of_corner.push_back(static_cast<int>(first + corner[k]));
        }
    }
}

}  // namespace

ControlMesh control_mesh(const Model& model, std::optional<double> crease_angle) {
    const Topology& topology = model.topology();
    ControlMesh control;
    for (const glm::vec3& position : topology.positions) control.points.push_back({glm::dvec3(position)});
    for (const Face& face : topology.faces) {
        for (const std::uint32_t v : face.vertices) control.corners.push_back(static_cast<int>(v));
        control.mesh_of.push_back(face.mesh);
    }
    if (crease_angle) add_creases(control, topology, *crease_angle);
    for (const std::uint32_t e : topology.tagged_edges) {
        for (const std::uint32_t v : topology.edges[e].vertices) control.tagged.push_back(static_cast<int>(v));
    }
    add_looks(control, model);
    return control;
}

}  // namespace croquis::model
