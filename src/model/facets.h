// A mesh whose triangles can each be shaded as one: a vertex of its own for each triangle, as few vertices as that
// takes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/model.h"

namespace croquis::model {

/// Who speaks for whom. OpenGL takes what is the same all over a triangle from its last vertex; so each triangle's last
/// vertex is its own, and a vertex that would have to be the last of several is there several times.
struct FacetLayout {
    static constexpr std::uint32_t no_triangle = 0xffffffff;
    std::vector<std::uint32_t> vertices;    ///< of the mesh; those that are there again stand at the end
    std::vector<std::uint32_t> triangles;   ///< three of `vertices` each, turned but not changed, in the mesh's order
    std::vector<std::uint32_t> spoken_for;  ///< for each of `vertices` the triangle whose last it is, or no_triangle
};

[[nodiscard]] FacetLayout facet_layout(const Mesh& mesh);

/// What is the same all over a triangle.
struct Facet {
    glm::vec3 normal{0.0f};      ///< the sum of its vertices' normals (seed B, before equation 4.2)
    glm::vec3 barycentre{0.0f};  ///< seed B, before equation 4.2
    float size = 0;              ///< its longest side
    glm::vec2 texcoord{0.0f};    ///< at the barycentre
    glm::vec4 color{1.0f};       ///< facet_color
};

/// The colour that two of the triangle's vertices have, else the mean of all three: so areas of one colour end in clear
/// borders, and gradients run on. White where there are no colours.
[[nodiscard]] glm::vec4 facet_color(const Mesh& mesh, std::size_t triangle);

/// A triangle of the mesh, whose vertices stand at these positions with these normals.
[[nodiscard]] Facet facet_of(const Mesh& mesh, std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                             std::size_t triangle);

}  // namespace croquis::model
