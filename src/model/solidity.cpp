#include "model/solidity.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "model/parts.h"

namespace croquis::model {
namespace {

constexpr std::size_t faces_a_piece = 8192;

Parts parts_of(const Topology& topology, std::span<const FacesAlike> on_crowded_edges) {
    Parts parts(topology.faces.size());
    parallel_for(topology.edges.size(), faces_a_piece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t e = begin; e < end; ++e) {
            const auto [first, second] = topology.edges[e].faces;
            if (second == no_face) continue;
            const std::uint32_t mesh = topology.faces[first].mesh;
            if (topology.mesh_is_solid[mesh] && topology.faces[second].mesh == mesh) parts.join(first, second);
        }
    });
    for (const auto& [first, second] : on_crowded_edges) parts.join(first, second);
    return parts;
}

/// True where a solid mesh has several parts.
bool any_parted(const Topology& topology, Parts& parts) {
    std::vector<std::uint32_t> first_part(topology.mesh_is_solid.size(), no_face);
    for (std::uint32_t f = 0; f < topology.faces.size(); ++f) {
        const std::uint32_t mesh = topology.faces[f].mesh;
        if (!topology.mesh_is_solid[mesh] || parts.first_face(f) != f) continue;
        if (first_part[mesh] != no_face) return true;
        first_part[mesh] = f;
    }
    return false;
}

void drop_meshes_wound_two_ways(Topology& topology, Parts& parts) {
    const std::vector<Face>& faces = topology.faces;
    std::vector<double> volume(faces.size());  // of parts, six times over; stands at the part's first face
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
        if (!topology.mesh_is_solid[faces[f].mesh]) continue;
        const std::uint32_t first = parts.first_face(f);
        const auto point = [&](std::uint32_t v) { return glm::dvec3(topology.positions[v]); };
        const glm::dvec3 apex = point(faces[first].vertices[0]);
        const auto& [a, b, c] = faces[f].vertices;
        volume[first] += glm::dot(point(a) - apex, glm::cross(point(b) - apex, point(c) - apex));
    }
    std::vector<std::array<bool, 2>> found(topology.mesh_is_solid.size(), {false, false});
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
        if (volume[f] != 0) found[faces[f].mesh][volume[f] < 0 ? 1 : 0] = true;
    }
    for (std::size_t m = 0; m < found.size(); ++m) {
        if (found[m][0] && found[m][1]) topology.mesh_is_solid[m] = false;
    }
}

}  // namespace

void fill_solidity(Topology& topology, const SolidMeshes& in_order, std::span<const FacesAlike> on_crowded_edges) {
    topology.mesh_is_solid.assign(in_order.size(), false);
    for (const Face& face : topology.faces) topology.mesh_is_solid[face.mesh] = true;
    bool any = false;
    for (std::size_t m = 0; m < in_order.size(); ++m) {
        topology.mesh_is_solid[m] = topology.mesh_is_solid[m] && in_order[m];
        any = any || topology.mesh_is_solid[m];
    }
    if (!any) return;
    Parts parts = parts_of(topology, on_crowded_edges);
    if (any_parted(topology, parts)) drop_meshes_wound_two_ways(topology, parts);
}

}  // namespace croquis::model
