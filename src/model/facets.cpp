#include "model/facets.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

namespace croquis::model {
namespace {

// Which of the corners of a triangle may become its own: of those that are nobody's yet, the one with the fewest
// triangles to come, which else might stay without one.
std::size_t rarest_free_corner(std::span<const std::uint32_t> corners, std::span<const std::uint32_t> spoken_for,
                               std::span<const std::uint32_t> triangles_to_come) {
    std::size_t best = corners.size();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (spoken_for[corners[i]] != FacetLayout::no_triangle) continue;
        if (best == corners.size() || triangles_to_come[corners[i]] < triangles_to_come[corners[best]]) best = i;
    }
    return best;
}

}  // namespace

FacetLayout facet_layout(const Mesh& mesh) {
    FacetLayout layout;
    layout.vertices.resize(mesh.positions.size());
    for (std::size_t i = 0; i < layout.vertices.size(); ++i) layout.vertices[i] = std::uint32_t(i);
    layout.spoken_for.assign(layout.vertices.size(), FacetLayout::no_triangle);
    layout.triangles.reserve(mesh.triangles.size());
    std::vector<std::uint32_t> triangles_to_come(layout.vertices.size(), 0);
    for (const std::uint32_t vertex : mesh.triangles) ++triangles_to_come[vertex];

    for (std::size_t triangle = 0; triangle < mesh.triangle_count(); ++triangle) {
        std::array<std::uint32_t, 3> corners{};
        std::copy_n(mesh.triangles.begin() + std::ptrdiff_t(3 * triangle), 3, corners.begin());
        std::size_t last = rarest_free_corner(corners, layout.spoken_for, triangles_to_come);
        for (const std::uint32_t corner : corners) --triangles_to_come[corner];
        if (last == corners.size()) {
            last = 2;
            layout.vertices.push_back(corners[last]);
            layout.spoken_for.push_back(FacetLayout::no_triangle);
            corners[last] = std::uint32_t(layout.vertices.size() - 1);
        }
        layout.spoken_for[corners[last]] = std::uint32_t(triangle);
        for (std::size_t i = 1; i <= 3; ++i) layout.triangles.push_back(corners[(last + i) % 3]);
    }
    return layout;
}

glm::vec4 facet_color(const Mesh& mesh, std::size_t triangle) {
    if (mesh.colors.empty()) return glm::vec4(1.0f);
    glm::vec4 sum(0.0f);
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::u8vec4 color = mesh.colors[mesh.triangles[3 * triangle + i]];
        if (color == mesh.colors[mesh.triangles[3 * triangle + (i + 1) % 3]]) return glm::vec4(color) / 255.0f;
        sum += glm::vec4(color);
    }
    return sum / (3.0f * 255.0f);
}

Facet facet_of(const Mesh& mesh, std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
               std::size_t triangle) {
    Facet facet;
    facet.color = facet_color(mesh, triangle);
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t vertex = mesh.triangles[3 * triangle + i];
        const std::uint32_t next = mesh.triangles[3 * triangle + (i + 1) % 3];
        facet.normal += normals[vertex];
        facet.barycentre += positions[vertex] / 3.0f;
        facet.size = std::max(facet.size, glm::distance(positions[vertex], positions[next]));
        if (!mesh.texcoords.empty()) facet.texcoord += mesh.texcoords[vertex] / 3.0f;
    }
    return facet;
}

}  // namespace croquis::model
