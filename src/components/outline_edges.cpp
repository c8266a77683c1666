#include "components/outline_edges.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <unordered_map>

#include "base/parallel.h"

namespace croquis::components {

OutlineEdges::OutlineEdges(std::shared_ptr<const lines::Surface> surface)
    : surface_(std::move(surface)),
      finder_(lines::make_finder("automatic", *surface_)),
      material_boundaries_(surface_->material_boundaries()) {}

std::uint32_t OutlineEdges::third_corner(std::uint32_t edge, std::uint32_t face) const {
    const auto& ends = surface_->topology().edges[edge].vertices;
    const auto& corners = surface_->topology().faces[face].vertices;
    return *std::find_if(corners.begin(), corners.end(),
                         [&](std::uint32_t corner) { return corner != ends[0] && corner != ends[1]; });
}

bool OutlineEdges::bounds_its_faces(std::uint32_t edge, const lines::Viewpoint& view,
                                    const std::vector<bool>& shown) const {
    const auto& [a, b] = surface_->topology().edges[edge].vertices;
    const glm::dvec3 start = surface_->point(a);
    const glm::dvec3 across = glm::cross(surface_->point(b) - start, view.towards_eye(start));
    bool left = false, right = false;
    for (const std::uint32_t index : surface_->faces_around(a)) {
        const model::Face& face = surface_->topology().faces[index];
        const bool holds_edge = std::find(face.vertices.begin(), face.vertices.end(), b) != face.vertices.end();
        if (!holds_edge || !shown[face.mesh]) continue;
        const double side = glm::dot(across, surface_->point(third_corner(edge, index)) - start);
        left = left || side > 0;
        right = right || side < 0;
    }
    return left != right;
}

// Edges that may be contours but are not for the finder to decide: with one face, three or more, or two that are wound
// against each other, and those between what is shown and what is not.
std::vector<std::uint32_t> OutlineEdges::contour_candidates(const lines::Viewpoint& view,
                                                            const std::vector<bool>& shown) {
    const auto irregular = surface_->irregular_edges();
    std::vector<std::uint32_t> candidates(irregular.begin(), irregular.end());
    if (std::find(shown.begin(), shown.end(), false) != shown.end()) {
        candidates.insert(candidates.end(), material_boundaries_.begin(), material_boundaries_.end());
    }
    std::erase_if(candidates, [&](std::uint32_t edge) { return !bounds_its_faces(edge, view, shown); });
    const std::vector<std::uint32_t>& silhouettes = finder_->find(view);
    candidates.insert(candidates.end(), silhouettes.begin(), silhouettes.end());
    std::sort(candidates.begin(), candidates.end());
    candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
    return candidates;
}

std::vector<EdgeWithFace> OutlineEdges::contours(const lines::Viewpoint& view, const std::vector<bool>& shown) {
    const model::Topology& topology = surface_->topology();
    std::vector<EdgeWithFace> found;
    for (const std::uint32_t edge : contour_candidates(view, shown)) {
        for (const std::uint32_t face : topology.edges[edge].faces) {
            if (face == model::no_face || !shown[topology.faces[face].mesh]) continue;
            found.push_back({edge, third_corner(edge, face)});
            break;
        }
    }
    return found;
}

// Lines that share a vertex hang together: each vertex leads on to another of its heap, the heap's first to itself.
std::vector<EdgeWithFace> OutlineEdges::without_specks(std::vector<EdgeWithFace> lines, const lines::Viewpoint& view,
                                                       double shortest) const {
    if (shortest <= 0) return lines;
    const model::Topology& topology = surface_->topology();
    std::unordered_map<std::uint32_t, std::uint32_t> leads_to;
    const auto first_of = [&](std::uint32_t vertex) {
        while (leads_to.at(vertex) != vertex) vertex = leads_to[vertex] = leads_to.at(leads_to.at(vertex));
        return vertex;
    };
    for (const EdgeWithFace& line : lines) {
        const auto& [a, b] = topology.edges[line.edge].vertices;
        leads_to.try_emplace(a, a);
        leads_to.try_emplace(b, b);
        leads_to[first_of(a)] = first_of(b);
    }
    std::unordered_map<std::uint32_t, double> pixels;
    for (const EdgeWithFace& line : lines) {
        const auto& [a, b] = topology.edges[line.edge].vertices;
        const glm::dvec3 start = surface_->point(a), end = surface_->point(b);
        const bool before_eye = std::min(view.eye_distance(start), view.eye_distance(end)) > view.near_distance;
        pixels[first_of(a)] +=
            before_eye ? glm::distance(view.project(start).position, view.project(end).position) : shortest;
    }
    std::erase_if(lines, [&](const EdgeWithFace& line) {
        return pixels.at(first_of(topology.edges[line.edge].vertices[0])) < shortest;
    });
    return lines;
}

std::vector<EdgeWithFace> OutlineEdges::edges_of_faces(const lines::Viewpoint& view, Facing facing,
                                                       const std::vector<bool>& shown) const {
    const model::Topology& topology = surface_->topology();
    std::vector<std::uint8_t> drawn(topology.faces.size());
    parallel_for(drawn.size(), 8192, [&](std::size_t begin, std::size_t end) {
        for (std::size_t face = begin; face < end; ++face) {
            const bool front = surface_->front_facing(std::uint32_t(face), view);
            drawn[face] = shown[topology.faces[face].mesh] && front == (facing == Facing::front);
        }
    });
    std::vector<EdgeWithFace> found;
    for (std::uint32_t edge = 0; edge < topology.edges.size(); ++edge) {
        const auto& [first, second] = topology.edges[edge].faces;
        const bool first_drawn = drawn[first] != 0, second_drawn = second != model::no_face && drawn[second] != 0;
        if (first_drawn == second_drawn) continue;
        found.push_back({edge, third_corner(edge, first_drawn ? first : second)});
    }
    return found;
}

std::vector<EdgeWithFace> OutlineEdges::inner_edges(double crease_angle, const std::vector<bool>& shown) const {
    const model::Topology& topology = surface_->topology();
    std::vector<std::uint32_t> edges = surface_->creases(crease_angle);
    edges.insert(edges.end(), material_boundaries_.begin(), material_boundaries_.end());
    edges.insert(edges.end(), topology.tagged_edges.begin(), topology.tagged_edges.end());
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    std::vector<EdgeWithFace> found;
    for (const std::uint32_t edge : edges) {
        const std::uint32_t face = topology.edges[edge].faces[0];
        if (shown[topology.faces[face].mesh]) found.push_back({edge, third_corner(edge, face)});
    }
    return found;
}

}  // namespace croquis::components
