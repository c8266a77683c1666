#include "lines/piercings.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "base/parallel.h"

namespace croquis::lines {

PiercingFinder::PiercingFinder(const Surface& surface, const RayCaster& rays)
    : surface_(surface), rays_(rays), is_known_(surface.edge_count(), false) {}

void PiercingFinder::look_at(const std::vector<std::uint32_t>& edges) {
    struct Found {
        std::uint32_t edge;
        std::vector<Piercing> piercings;
    };
    constexpr std::size_t edges_a_block = 128;
    std::vector<std::vector<Found>> blocks((edges.size() + edges_a_block - 1) / edges_a_block);
    parallel_for(blocks.size(), 1, [&](std::size_t begin, std::size_t end) {
        std::vector<Piercing> piercings;
        for (std::size_t b = begin; b < end; ++b) {
            const std::size_t last = std::min((b + 1) * edges_a_block, edges.size());
            for (std::size_t i = b * edges_a_block; i < last; ++i) {
                const auto& ends = surface_.topology().edges[edges[i]].vertices;
                piercings.clear();
                rays_.find_piercings(ends[0], ends[1], piercings);
                if (!piercings.empty()) blocks[b].push_back({edges[i], piercings});
            }
        }
    });
    for (auto& block : blocks) {
        for (Found& found : block) piercings_.emplace(found.edge, std::move(found.piercings));
    }
    for (const std::uint32_t e : edges) is_known_[e] = true;
}

std::vector<Crossing> PiercingFinder::find(const ImageEdges& edges, const Viewpoint& view) {
    std::vector<std::uint32_t> unknown;
    for (const ImageEdge& edge : edges.edges()) {
        if (!is_known_[edge.edge]) unknown.push_back(edge.edge);
    }
    look_at(unknown);
    std::vector<Crossing> crossings;
    if (piercings_.empty()) return crossings;
    for (std::uint32_t e = 0; e < edges.edges().size(); ++e) {
        const ImageEdge& edge = edges.edges()[e];
        const auto found = piercings_.find(edge.edge);
        if (found == piercings_.end()) continue;
        const auto& ends = surface_.topology().edges[edge.edge].vertices;
        const glm::dvec3 from = surface_.point(ends[0]), to = surface_.point(ends[1]);
        const glm::dvec2 a = edges.vertices()[edge.a].position, b = edges.vertices()[edge.b].position;
        for (const Piercing& piercing : found->second) {
            const glm::dvec3 point = from + piercing.share * (to - from);
            if (view.projection == model::Projection::perspective && view.eye_distance(point) < view.near_distance) {
                continue;
            }
            const double share =
                glm::dot(view.project(point).position - a, b - a) / std::max(glm::dot(b - a, b - a), 1e-300);
            const auto& [p, q, r] = surface_.topology().faces[piercing.face].vertices;
            const glm::dvec3 corner = surface_.point(p);
            const glm::dvec3 normal = glm::cross(surface_.point(q) - corner, surface_.point(r) - corner);
            const bool ends_behind =
                (glm::dot(normal, to - from) < 0) == (glm::dot(normal, view.towards_eye(corner)) > 0);
            crossings.push_back({e, piercing.face, share, static_cast<std::int8_t>(ends_behind ? 1 : -1), true});
        }
    }
    return crossings;
}

}  // namespace croquis::lines
