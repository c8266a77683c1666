#include "lines/tracing.h"

#include <glm/geometric.hpp>

namespace croquis::lines {
namespace {

/// A point this near to the straight line between its neighbours, in pixels, says nothing.
constexpr double straight = 1e-4;

glm::vec3 normal_of(const Surface& surface, const ImageEdge& edge) {
    const FacePair pair = surface.pairs()[edge.edge];
    const glm::vec3 sum = glm::vec3(surface.planes()[pair.first]) + glm::vec3(surface.planes()[pair.second]);
    const float length = glm::length(sum);
    return length > 1e-6f ? sum / length : glm::vec3(surface.planes()[pair.first]);
}

bool is_between(const LinePoint& before, const LinePoint& point, const LinePoint& after) {
    const glm::dvec2 whole = after.position - before.position, part = point.position - before.position;
    const double length = glm::length(whole);
    if (!(length > 0)) return false;
    const double along = glm::dot(whole, part) / length;
    return along > 0 && along < length && std::abs(whole.x * part.y - whole.y * part.x) <= straight * length;
}

}  // namespace

Drawing trace(const VisibilityTask& task, const Chains& chains, const std::vector<Piece>& pieces,
              const std::vector<ChainKey>& keys) {
    Drawing drawing{task.view.width, task.view.height, {}, {}};
    drawing.lines.reserve(chains.chains.size());
    drawing.points.reserve(chains.links.size() + chains.chains.size());
    for (const Chains::Chain& chain : chains.chains) {
        const auto links = chains.links_of(chain);
        const ChainKey& key = keys[links[0].piece];
        Line line{key.line_class, key.mesh, key.layers, chain.closed};
        line.first_point = static_cast<std::uint32_t>(drawing.points.size());
        const auto add = [&](const ImageEdge& edge, double share) {
            const ImagePoint point = task.edges.point_at(edge, share);
            const LinePoint next{point.position, task.view.distance_of(point.nearness), normal_of(task.surface, edge)};
            const std::size_t count = drawing.points.size() - line.first_point;
            if (count >= 2 && is_between(drawing.points[drawing.points.size() - 2], drawing.points.back(), next)) {
                drawing.points.back() = next;
            } else {
                drawing.points.push_back(next);
            }
        };
        for (std::size_t i = 0; i < links.size(); ++i) {
            const Piece& piece = pieces[links[i].piece];
            const ImageEdge& edge = task.edges.edges()[piece.edge];
            if (i == 0) add(edge, links[i].reversed ? piece.to : piece.from);
            if (i + 1 < links.size() || !chain.closed) add(edge, links[i].reversed ? piece.from : piece.to);
        }
        line.point_count = static_cast<std::uint32_t>(drawing.points.size()) - line.first_point;
        drawing.lines.push_back(line);
    }
    return drawing;
}

}  // namespace croquis::lines
