#include "lines/contours.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "lines/pieces.h"

namespace croquis::lines {
namespace {

/// How far beside the line, in pixels, one looks past it.
constexpr double aside = 2e-3;
/// Along lines longer than this one looks again: in views along faces, what lies behind may begin or end at no
/// crossing.
constexpr double longest_run = 16;  // pixels

bool is_outline_class(LineClass line_class) {
    return line_class == LineClass::silhouette || line_class == LineClass::border;
}

/// Pieces cut at every crossing, those with lines behind them too.
void cut(const VisibilityTask& task, std::vector<Piece>& pieces, std::vector<ChainKey>& keys) {
    const CrossingsByEdge crossings(task);
    std::vector<Piece> cut_pieces;
    std::vector<ChainKey> cut_keys;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        Piece rest = pieces[p];
        if (rest.layers == 0 && is_outline_class(keys[p].line_class)) {
            for (const Crossing& crossing : crossings.of(rest.edge)) {
                if (crossing.share <= rest.from || crossing.share >= rest.to) continue;
                cut_pieces.push_back({rest.edge, rest.from, crossing.share, 0});
                cut_keys.push_back(keys[p]);
                rest.from = crossing.share;
            }
        }
        cut_pieces.push_back(rest);
        cut_keys.push_back(keys[p]);
    }
    pieces = std::move(cut_pieces);
    keys = std::move(cut_keys);
}

/// True when a look past the outer side of the piece meets nothing behind it.
bool has_nothing_behind(const VisibilityTask& task, const LayerProbe& probe, const Piece& piece) {
    const ImageEdge& edge = task.edges.edges()[piece.edge];
    // What only rounding shows has its own body behind it.
    if (edge.step == 0 || edge.never_seen || !(task.edges.length_of(edge) > 0)) return false;
    return probe.is_open_behind(edge, task.edges.point_beside(edge, 0.5 * (piece.from + piece.to), aside));
}

/// From the start of a link to its end.
glm::dvec2 direction_of(const VisibilityTask& task, const std::vector<Piece>& pieces, const Link& link) {
    const ImageEdge& edge = task.edges.edges()[pieces[link.piece].edge];
    const double length = task.edges.length_of(edge);
    return length > 0 ? task.edges.along(edge) / (link.reversed ? -length : length) : glm::dvec2(0.0);
}

/// True where the surface around a joint of two links goes on without another hiding edge. Not at corners: in views
/// along faces, edges of the surface behind may line up with one side of a corner.
bool is_plain_joint(const VisibilityTask& task, const std::vector<Piece>& pieces, const Link& before,
                    const Link& after) {
    const Piece &first = pieces[before.piece], &second = pieces[after.piece];
    if (first.edge == second.edge) return false;
    constexpr double corner_cosine = 0.8;
    if (glm::dot(direction_of(task, pieces, before), direction_of(task, pieces, after)) < corner_cosine) return false;
    const ImageEdge& edge = task.edges.edges()[first.edge];
    const std::uint32_t vertex = before.reversed ? edge.a : edge.b;
    const auto around = task.edges.edges_at(vertex);
    return std::count_if(around.begin(), around.end(),
                         [&](std::uint32_t e) { return task.edges.edges()[e].step != 0; }) == 2;
}

}  // namespace

void find_contours(const VisibilityTask& task, const LayerProbe& probe, std::vector<Piece>& pieces,
                   std::vector<ChainKey>& keys) {
    cut(task, pieces, keys);
    const Chains chains = chain_pieces(task.edges, pieces, keys);
    parallel_for(chains.chains.size(), 4, [&](std::size_t begin, std::size_t end) {
        for (std::size_t c = begin; c < end; ++c) {
            const auto links = chains.links_of(chains.chains[c]);
            if (pieces[links[0].piece].layers != 0 || !is_outline_class(keys[links[0].piece].line_class)) continue;
            std::size_t first = 0;
            while (first < links.size()) {
                std::size_t last = first + 1;
                double length = length_of(task.edges, pieces[links[first].piece]);
                while (last < links.size() && length < longest_run &&
                       is_plain_joint(task, pieces, links[last - 1], links[last])) {
                    length += length_of(task.edges, pieces[links[last++].piece]);
                }
                const auto run = links.subspan(first, last - first);
                const Link longest = *std::max_element(run.begin(), run.end(), [&](const Link& x, const Link& y) {
                    return pieces[x.piece].to - pieces[x.piece].from < pieces[y.piece].to - pieces[y.piece].from;
                });
                if (has_nothing_behind(task, probe, pieces[longest.piece])) {
                    for (const Link& link : run) keys[link.piece].line_class = LineClass::contour;
                }
                first = last;
            }
        }
    });
}

}  // namespace croquis::lines
