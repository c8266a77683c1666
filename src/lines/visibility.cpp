// What quantitative invisibility and ray casts share: pieces within the frame, and the probe that casts rays.
#include "lines/visibility.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "lines/pieces.h"

namespace croquis::lines {

RayProbe::RayProbe(const RayCaster& rays, const Surface& surface, const ImageEdges& edges, const Viewpoint& view,
                   double tolerance)
    : rays_(rays), surface_(surface), edges_(edges), view_(view), tolerance_(tolerance) {}

std::uint32_t RayProbe::layers(const ImageEdge& edge, double share, std::uint32_t at_most) const {
    const glm::dvec3 point = view_.unproject(edges_.point_at(edge, share));
    const bool perspective = view_.projection == model::Projection::perspective;
    const glm::dvec3 eye = perspective ? view_.eye : point + view_.back * 4.0;
    const FacePair pair = edges_.faces_of(edge);
    if (pair.first != pair.second) {
        return rays_.layers(point, eye, std::array{pair.first, pair.second}, tolerance_, at_most);
    }
    const auto& [a, b] = surface_.topology().edges[edge.edge].vertices;
    std::vector<std::uint32_t> faces;
    for (const std::uint32_t f : surface_.faces_around(a)) {
        const auto& v = surface_.topology().faces[f].vertices;
        if (v[0] == b || v[1] == b || v[2] == b) faces.push_back(f);
    }
    return rays_.layers(point, eye, faces, tolerance_, at_most);
}

bool RayProbe::is_open_behind(const ImageEdge& edge, const ImagePoint& beside) const {
    const glm::dvec3 from = view_.unproject(beside);
    const glm::dvec3 away = -glm::normalize(view_.towards_eye(from));
    const FacePair pair = edges_.faces_of(edge);
    return rays_.layers(from, from + 4.0 * away, std::array{pair.first, pair.second}, 0.0, 1) == 0;
}

Interval frame_interval(const Viewpoint& view, const ImageEdges& edges, const ImageEdge& edge) {
    if (edges.is_whole()) return {0, 1};
    const glm::dvec2& a = edges.vertices()[edge.a].position;
    const glm::dvec2 offset = edges.vertices()[edge.b].position - a;
    Interval inside{0, 1};
    const glm::dvec2 size(view.width, view.height);
    for (const int axis : {0, 1}) {
        if (offset[axis] == 0) {
            if (a[axis] < 0 || a[axis] > size[axis]) return {0, 0};
            continue;
        }
        const double enter = -a[axis] / offset[axis], leave = (size[axis] - a[axis]) / offset[axis];
        inside.from = std::max(inside.from, std::min(enter, leave));
        inside.to = std::min(inside.to, std::max(enter, leave));
    }
    return inside.from < inside.to ? inside : Interval{0, 0};
}

CrossingsByEdge::CrossingsByEdge(const VisibilityTask& task) : crossings_(task.crossings) {
    starts_.assign(task.edges.edges().size() + 1, 0);
    for (const Crossing& crossing : crossings_) ++starts_[crossing.edge + 1];
    for (std::size_t e = 1; e < starts_.size(); ++e) starts_[e] += starts_[e - 1];
}

void append_piece(std::vector<Piece>& pieces, const Piece& piece) {
    if (!(piece.from < piece.to)) return;
    if (!pieces.empty()) {
        Piece& last = pieces.back();
        if (last.edge == piece.edge && last.layers == piece.layers && last.to == piece.from) {
            last.to = piece.to;
            return;
        }
    }
    pieces.push_back(piece);
}

/// What is shorter in the picture, in pixels, is noise of the crossings and no piece of its own.
constexpr double shortest_piece = 1e-6;

void probe_edge(const VisibilityTask& task, const CrossingsByEdge& crossings, const LayerProbe& probe,
                std::uint32_t image_edge, std::vector<Piece>& pieces) {
    const ImageEdge& edge = task.edges.edges()[image_edge];
    const Interval inside = frame_interval(task.view, task.edges, edge);
    double from = inside.from;
    const double length = task.edges.length_of(edge);
    const double shortest = shortest_piece / std::max(length, shortest_piece);
    const auto close = [&](double to) {
        to = std::clamp(to, inside.from, inside.to);
        if (!(from < to)) return;
        const std::uint32_t at_most = task.count_layers ? 0xffffffffu : 1u;
        // Where all lines up exactly, what its own body hides may count as seen.
        const std::uint32_t fewest = edge.never_seen ? 1 : 0;
        append_piece(pieces, {image_edge, from, to, std::max(probe.layers(edge, 0.5 * (from + to), at_most), fewest)});
        from = to;
    };
    for (const Crossing& crossing : crossings.of(image_edge)) {
        const bool is_inside = crossing.share - from > shortest && inside.to - crossing.share > shortest;
        if (is_inside && (crossing.gain != 0 || crossing.is_doubtful)) close(crossing.share);
    }
    close(inside.to);
}

VisibilityResult probed_visibility(const VisibilityTask& task, const LayerProbe& probe) {
    const CrossingsByEdge crossings(task);
    constexpr std::size_t edges_a_block = 64;
    const std::size_t count = task.edges.edges().size();
    std::vector<std::vector<Piece>> blocks((count + edges_a_block - 1) / edges_a_block);
    parallel_for(blocks.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t block = begin; block < end; ++block) {
            const std::size_t last = std::min((block + 1) * edges_a_block, count);
            for (std::size_t e = block * edges_a_block; e < last; ++e) {
                const ImageEdge& edge = task.edges.edges()[e];
                if (!edge.is_line) continue;
                probe_edge(task, crossings, probe, static_cast<std::uint32_t>(e), blocks[block]);
            }
        }
    });
    VisibilityResult result;
    for (const auto& block : blocks) result.pieces.insert(result.pieces.end(), block.begin(), block.end());
    return result;
}

VisibilityResult all_visible(const VisibilityTask& task) {
    VisibilityResult result;
    for (std::uint32_t e = 0; e < task.edges.edges().size(); ++e) {
        const ImageEdge& edge = task.edges.edges()[e];
        if (!edge.is_line) continue;
        const Interval inside = frame_interval(task.view, task.edges, edge);
        append_piece(result.pieces, {e, inside.from, inside.to, 0});
    }
    return result;
}

}  // namespace croquis::lines
