// The welded topology beside the render vertices: who touches whom (seed A, 2.2.3; seed D, 2).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace croquis::model {

struct Mesh;

/// Both ends of an edge that the model's author marked to be drawn always (seed C, chapter 3: artistic edges).
using TaggedEdge = std::array<glm::vec3, 2>;

constexpr std::uint32_t no_face = 0xffffffffu;

/// An undirected edge. Of more than two faces on an edge the first two stand here; `face_count` tells how many.
struct Edge {
    std::array<std::uint32_t, 2> vertices;                 ///< welded vertices, the smaller first
    std::array<std::uint32_t, 2> faces{no_face, no_face};  ///< faces[1] is no_face on a border
};

/// A face of the whole model: a triangle of a mesh that is left after welding.
struct Face {
    std::array<std::uint32_t, 3> vertices;  ///< welded vertices, in the mesh's winding
    std::uint32_t mesh = 0;
};

/// All meshes welded into one: vertices at the same position are one vertex, faces of no area are gone, borders that
/// coincide but for rounding are sewn (model/sewing.h), and each undirected edge stands once.
struct Topology {
    std::vector<glm::vec3> positions;  ///< one a welded vertex
    std::vector<Face> faces;
    std::vector<Edge> edges;                   ///< sorted by their vertices
    std::vector<std::uint32_t> crowded_edges;  ///< indices of edges with three or more faces, ascending
    std::vector<std::uint32_t> twisted_edges;  ///< indices of edges whose two faces are wound against each other
    std::vector<std::uint32_t> tagged_edges;   ///< indices of edges that the model's author marked, ascending
    std::vector<std::uint32_t> star_starts;    ///< where each vertex starts in `star_faces`, and the end of the last
    std::vector<std::uint32_t> star_faces;     ///< the faces around each vertex in turn: see `faces_around`
    std::vector<std::uint32_t> sewn;           ///< the vertex of each distinct position; empty unless borders were sewn

    /// True for a mesh whose surface is closed, has two faces on each edge and is wound one way, in all of its
    /// connected parts alike: then faces that turn away from the eye are never seen. A body with a hollow, whose wall
    /// is wound the other way, does not count. One entry a mesh.
    std::vector<bool> mesh_is_solid;
    /// True for a mesh of negative volume, wound inside out. One entry a mesh.
    std::vector<bool> mesh_is_inverted;

    [[nodiscard]] std::size_t border_edge_count() const;

    /// The faces at a vertex, in ascending order.
    [[nodiscard]] std::span<const std::uint32_t> faces_around(std::uint32_t vertex) const {
        return std::span(star_faces).subspan(star_starts[vertex], star_starts[vertex + 1] - star_starts[vertex]);
    }
};

/// Welds vertices at exactly equal positions (-0 equals 0) across all meshes, and sews borders that coincide. Tagged
/// edges that are no edge of a mesh are passed over.
[[nodiscard]] Topology weld(std::span<const Mesh> meshes, std::span<const TaggedEdge> tagged = {});

}  // namespace croquis::model
