#include "lines/piercings.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "base/parallel.h"

namespace croquis::lines {

PiercingFinder::PiercingFinder(const Surface& surface, const CutCurves& cuts, const RayCaster& rays)
    : surface_(surface), cuts_(cuts), rays_(rays), is_known_(surface.edge_count() + cuts.segments.size(), false) {}

std::uint32_t PiercingFinder::number_of(const ImageEdge& edge) const {
    const bool is_segment = edge.line_class == LineClass::intersection;
    return edge.edge + (is_segment ? static_cast<std::uint32_t>(surface_.edge_count()) : 0);
}

std::array<glm::dvec3, 2> PiercingFinder::ends_of(std::uint32_t number) const {
    if (number < surface_.edge_count()) {
        const auto& [a, b] = surface_.topology().edges[number].vertices;
        return {surface_.point(a), surface_.point(b)};
    }
    const auto& [a, b] = cuts_.segments[number - surface_.edge_count()].nodes;
    return {cuts_.nodes[a].point, cuts_.nodes[b].point};
}

void PiercingFinder::append_own_faces(std::uint32_t number, std::vector<std::uint32_t>& faces) const {
    const auto append_around = [&](std::uint32_t vertex) {
        const auto around = surface_.faces_around(vertex);
        faces.insert(faces.end(), around.begin(), around.end());
    };
    if (number < surface_.edge_count()) {
        for (const std::uint32_t vertex : surface_.topology().edges[number].vertices) append_around(vertex);
        return;
    }
    const CutSegment& segment = cuts_.segments[number - surface_.edge_count()];
    faces.insert(faces.end(), segment.faces.begin(), segment.faces.end());
    for (const std::uint32_t n : segment.nodes) {
        const CutNode& node = cuts_.nodes[n];
        const auto& [a, b] = surface_.topology().edges[node.edge].vertices;
        if (node.face == model::no_face) {
            append_around(
                glm::distance(surface_.point(a), node.point) < glm::distance(surface_.point(b), node.point) ? a : b);
            continue;
        }
        for (const std::uint32_t f : surface_.faces_around(a)) {
            const auto& v = surface_.topology().faces[f].vertices;
            if (v[0] == b || v[1] == b || v[2] == b) faces.push_back(f);
        }
    }
}

void PiercingFinder::look_at(const std::vector<std::uint32_t>& numbers) {
    struct Found {
        std::uint32_t number;
        std::vector<Piercing> piercings;
    };
    constexpr std::size_t numbers_a_block = 128;
    std::vector<std::vector<Found>> blocks((numbers.size() + numbers_a_block - 1) / numbers_a_block);
    parallel_for(blocks.size(), 1, [&](std::size_t begin, std::size_t end) {
        std::vector<Piercing> piercings;
        std::vector<std::uint32_t> own_faces;
        for (std::size_t b = begin; b < end; ++b) {
            const std::size_t last = std::min((b + 1) * numbers_a_block, numbers.size());
            for (std::size_t i = b * numbers_a_block; i < last; ++i) {
                const auto [from, to] = ends_of(numbers[i]);
                own_faces.clear();
                append_own_faces(numbers[i], own_faces);
                piercings.clear();
                rays_.find_piercings(from, to, own_faces, piercings);
                if (!piercings.empty()) blocks[b].push_back({numbers[i], piercings});
            }
        }
    });
    for (auto& block : blocks) {
        for (Found& found : block) piercings_.emplace(found.number, std::move(found.piercings));
    }
    for (const std::uint32_t number : numbers) is_known_[number] = true;
}

std::vector<Crossing> PiercingFinder::find(const ImageEdges& edges, const Viewpoint& view) {
    std::vector<std::uint32_t> unknown;
    for (const ImageEdge& edge : edges.edges()) {
        if (!is_known_[number_of(edge)]) unknown.push_back(number_of(edge));
    }
    look_at(unknown);
    std::vector<Crossing> crossings;
    if (piercings_.empty()) return crossings;
    for (std::uint32_t e = 0; e < edges.edges().size(); ++e) {
        const ImageEdge& edge = edges.edges()[e];
        const auto found = piercings_.find(number_of(edge));
        if (found == piercings_.end()) continue;
        const auto [from, to] = ends_of(number_of(edge));
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
