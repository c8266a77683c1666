#include "lines/tracing.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace croquis::lines {
namespace {

/// A point this near to the straight line between its neighbours, in pixels, says nothing.
constexpr double straight = 1e-4;
constexpr double straight_in_depth = 1e-6;  // of the depth

glm::vec3 normal_of(const Surface& surface, FacePair pair) {
    const glm::vec3 sum = glm::vec3(surface.planes()[pair.first]) + glm::vec3(surface.planes()[pair.second]);
    const float length = glm::length(sum);
    return length > 1e-6f ? sum / length : glm::vec3(surface.planes()[pair.first]);
}

/// True when a point says nothing that its neighbours do not, in place or in depth: it lies within `tolerance` pixels
/// of the line between them. What is used up of the tolerance is taken off.
bool is_between(const ImagePoint& before, const ImagePoint& point, const ImagePoint& after, double& tolerance) {
    const glm::dvec2 whole = after.position - before.position, part = point.position - before.position;
    const double length = glm::length(whole);
    if (!(length > 0)) return false;
    const double share = glm::dot(whole, part) / (length * length);
    const double distance = std::abs(whole.x * part.y - whole.y * part.x) / length;
    if (!(share > 0 && share < 1) || distance > tolerance) return false;
    const double nearness = before.nearness + share * (after.nearness - before.nearness);
    if (std::abs(nearness - point.nearness) > straight_in_depth * std::abs(point.nearness)) return false;
    tolerance -= distance;
    return true;
}

/// A closed line begins wherever its first piece does: points about its seam that say nothing go too.
void mend_seam(std::vector<ImagePoint>& image, std::vector<LinePoint>& points, std::uint32_t first_point) {
    double tolerance = straight;
    if (image.size() > 3 && is_between(image[image.size() - 2], image.back(), image.front(), tolerance)) {
        image.pop_back();
        points.pop_back();
    }
    if (image.size() > 3 && is_between(image.back(), image[0], image[1], tolerance)) {
        image.erase(image.begin());
        points.erase(points.begin() + first_point);
    }
}

/// True for a line that is seen end-on.
bool is_point(std::span<const LinePoint> points) {
    constexpr double smallest = 1e-5;  // pixels: above what ends are moved by
    return std::all_of(points.begin(), points.end(), [&](const LinePoint& point) {
        return glm::distance(point.position, points[0].position) < smallest;
    });
}

}  // namespace

Drawing trace(const VisibilityTask& task, const Chains& chains, const std::vector<Piece>& pieces,
              const std::vector<ChainKey>& keys) {
    Drawing drawing{task.view.width, task.view.height, {}, {}};
    drawing.lines.reserve(chains.chains.size());
    drawing.points.reserve(chains.links.size() + chains.chains.size());
    std::vector<ImagePoint> image;  // of the line at hand
    for (const Chains::Chain& chain : chains.chains) {
        const auto links = chains.links_of(chain);
        const ChainKey& key = keys[links[0].piece];
        Line line{key.line_class, key.mesh, key.layers, chain.closed};
        line.first_point = static_cast<std::uint32_t>(drawing.points.size());
        image.clear();
        double tolerance = straight;  // of the straight piece at hand: a fine curve is no such piece
        const auto add = [&](const ImageEdge& edge, double share) {
            const ImagePoint point = task.edges.point_at(edge, share);
            const LinePoint next{point.position, task.view.distance_of(point.nearness),
                                 normal_of(task.surface, task.edges.faces_of(edge))};
            const std::size_t count = image.size();
            if (count >= 2 && is_between(image[count - 2], image[count - 1], point, tolerance)) {
                drawing.points.back() = next;
                image.back() = point;
            } else {
                drawing.points.push_back(next);
                image.push_back(point);
                tolerance = straight;
            }
        };
        for (std::size_t i = 0; i < links.size(); ++i) {
            const Piece& piece = pieces[links[i].piece];
            const ImageEdge& edge = task.edges.edges()[piece.edge];
            if (i == 0) add(edge, links[i].reversed ? piece.to : piece.from);
            if (i + 1 < links.size() || !chain.closed) add(edge, links[i].reversed ? piece.from : piece.to);
        }
        if (chain.closed) mend_seam(image, drawing.points, line.first_point);
        line.point_count = static_cast<std::uint32_t>(drawing.points.size()) - line.first_point;
        drawing.lines.push_back(line);
    }
    return drawing;
}

void drop_points(Drawing& drawing) {
    std::erase_if(drawing.lines, [&](const Line& line) { return is_point(drawing.points_of(line)); });
}

}  // namespace croquis::lines
