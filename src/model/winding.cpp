#include "model/winding.h"

#include <glm/geometric.hpp>
#include <span>
#include <utility>

#include "model/parts.h"
#include "model/welding.h"

namespace croquis::model {
namespace {

/// How much of a triangle's area its normals agree with: negative where they look the other way.
double agreement(const Mesh& mesh, std::size_t triangle) {
    const std::uint32_t* const v = &mesh.triangles[3 * triangle];
    const glm::dvec3 given =
        glm::dvec3(mesh.normals[v[0]]) + glm::dvec3(mesh.normals[v[1]]) + glm::dvec3(mesh.normals[v[2]]);
    return glm::dot(area_vector(mesh.positions[v[0]], mesh.positions[v[1]], mesh.positions[v[2]]), given);
}

bool agrees_everywhere(const Mesh& mesh) {
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
        if (agreement(mesh, t) < 0) return false;
    }
    return true;
}

/// Faces that share an edge of two faces and are wound alike across it.
Parts parts_wound_alike(const Topology& topology) {
    std::vector<bool> is_irregular(topology.edges.size(), false);
    for (const auto* list : {&topology.crowded_edges, &topology.twisted_edges}) {
        for (const std::uint32_t e : *list) is_irregular[e] = true;
    }
    Parts parts(topology.faces.size());
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
        const auto [first, second] = topology.edges[e].faces;
        if (second != no_face && !is_irregular[e]) parts.join(first, second);
    }
    return parts;
}

/// The triangle of each face of a mesh's own topology.
std::vector<std::size_t> triangles_of_faces(const Mesh& mesh) {
    std::vector<std::size_t> triangles;
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
        const std::uint32_t* const v = &mesh.triangles[3 * t];
        if (has_area(mesh.positions[v[0]], mesh.positions[v[1]], mesh.positions[v[2]])) triangles.push_back(t);
    }
    return triangles;
}

}  // namespace

void turn_to_normals(Mesh& mesh) {
    if (agrees_everywhere(mesh)) return;
    const Topology topology = weld(std::span(&mesh, 1));
    const std::vector<std::size_t> triangles = triangles_of_faces(mesh);
    Parts parts = parts_wound_alike(topology);
    std::vector<double> sums(triangles.size(), 0.0);  // of parts; stand at their first face
    for (std::uint32_t f = 0; f < triangles.size(); ++f) sums[parts.first_face(f)] += agreement(mesh, triangles[f]);
    for (std::uint32_t f = 0; f < triangles.size(); ++f) {
        std::uint32_t* const v = &mesh.triangles[3 * triangles[f]];
        if (sums[parts.first_face(f)] < 0) std::swap(v[1], v[2]);
    }
}

}  // namespace croquis::model
