#include "lines/walk_probe.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "lines/predicates.h"

namespace croquis::lines {
namespace {

constexpr double most_bands = 1u << 16;
constexpr std::size_t vertices_a_piece = 1u << 15;

/// Calls visit(face) for the faces that hold both vertices, in ascending order, until it returns false.
template <typename Visit>
void visit_faces(const Surface& surface, std::uint32_t one, std::uint32_t other, const Visit& visit) {
    for (const std::uint32_t f : surface.faces_around(one)) {
        const auto& v = surface.topology().faces[f].vertices;
        if ((v[0] == other || v[1] == other || v[2] == other) && !visit(f)) return;
    }
}

bool holds(const model::Face& face, std::uint32_t vertex) {
    return face.vertices[0] == vertex || face.vertices[1] == vertex || face.vertices[2] == vertex;
}

}  // namespace

/// A place where sheets come into a path.
struct Walker::Entrance {
    std::uint32_t hiding = 0;
    double distance = 0;  ///< pixels to the point
};

/// One of the four ways out of the picture from a point.
struct Walker::Path {
    int along = 0;            ///< coordinate that changes: 0 for x, 1 for y
    bool is_positive = true;  ///< the point's side of the edges on the path: orientation(lower, upper, point) > 0
    double length = 0;        ///< of all walks, pixels
    std::vector<Entrance> entrances;

    [[nodiscard]] int across() const { return 1 - along; }
};

bool Walker::serves(const Surface& surface, const Viewpoint& view) {
    if (view.projection == model::Projection::parallel) return true;
    const double farthest_along = glm::dot(view.eye, view.back) - view.near_distance;
    std::atomic<bool> all_in_front{true};
    parallel_for(surface.vertex_count(), vertices_a_piece, [&](std::size_t begin, std::size_t end) {
        double along = -std::numeric_limits<double>::infinity();
        for (std::size_t v = begin; v < end; ++v) {
            along = std::max(along, glm::dot(surface.point(static_cast<std::uint32_t>(v)), view.back));
        }
        if (along > farthest_along) all_in_front.store(false, std::memory_order_relaxed);
    });
    return all_in_front.load();
}

Walker::Walker(const Surface& surface, const Viewpoint& view, const ImageEdges& edges,
               std::span<const std::uint32_t> silhouettes)
    : surface_(surface), view_(view) {
    if (edges.is_whole()) {
        take(edges);
    } else {
        gather(silhouettes);
    }
    for (const int axis : {0, 1}) sort_into_bands(axis);
}

void Walker::take(const ImageEdges& edges) {
    const auto end = [&](std::uint32_t vertex) {
        const ImageVertex& v = edges.vertices()[vertex];
        return End{{v.position, v.nearness}, v.vertex};
    };
    for (const ImageEdge& edge : edges.edges()) {
        if (edge.step != 0) hiding_.push_back({end(edge.a), end(edge.b), edge.step});
    }
}

void Walker::gather(std::span<const std::uint32_t> silhouettes) {
    const std::vector<model::Edge>& edges = surface_.topology().edges;
    hiding_.reserve(silhouettes.size() + surface_.irregular_edges().size());
    for (const std::uint32_t e : silhouettes) {
        add(e, 2 * side_of(surface_, edges[e], surface_.pairs()[e].first, view_));
    }
    for (const std::uint32_t e : surface_.irregular_edges()) {
        int step = 0;
        visit_faces(surface_, edges[e].vertices[0], edges[e].vertices[1], [&](std::uint32_t f) {
            step += side_of(surface_, edges[e], f, view_);
            return true;
        });
        if (step != 0) add(e, step);
    }
}

Walker::End Walker::end_at(std::uint32_t vertex) const { return {image_of(surface_, view_, vertex), vertex}; }

void Walker::add(std::uint32_t edge, int step) {
    const auto& [a, b] = surface_.topology().edges[edge].vertices;
    hiding_.push_back({end_at(a), end_at(b), step});
}

// Rounds the same way everywhere and never the larger of two coordinates to the smaller band: no margin is needed.
std::size_t Walker::Bands::band_of(double coordinate) const {
    const double band = std::clamp((coordinate - low) * bands_a_pixel, 0.0, static_cast<double>(count - 1));
    return static_cast<std::size_t>(band);
}

void Walker::sort_into_bands(int axis) {
    Bands& bands = bands_[static_cast<std::size_t>(axis)];
    double low = std::numeric_limits<double>::infinity(), high = -low, covered = 0;
    for (const HidingEdge& edge : hiding_) {
        covered += std::abs(edge.a.point.position[axis] - edge.b.point.position[axis]);
        low = std::min({low, edge.a.point.position[axis], edge.b.point.position[axis]});
        high = std::max({high, edge.a.point.position[axis], edge.b.point.position[axis]});
    }
    // As wide as an edge covers in the mean, so that each lies in some two bands.
    const double wanted = covered > 0 ? (high - low) * static_cast<double>(hiding_.size()) / covered : 1.0;
    bands.count = static_cast<std::size_t>(std::clamp(wanted, 1.0, most_bands));
    bands.low = hiding_.empty() ? 0.0 : low;
    bands.bands_a_pixel = high > low ? static_cast<double>(bands.count) / (high - low) : 1.0;
    const auto visit_bands = [&](const HidingEdge& edge, const auto& visit) {
        const std::size_t one = bands.band_of(edge.a.point.position[axis]);
        const std::size_t other = bands.band_of(edge.b.point.position[axis]);
        for (std::size_t band = std::min(one, other); band <= std::max(one, other); ++band) visit(band);
    };
    bands.starts.assign(bands.count + 2, 0);
    for (const HidingEdge& edge : hiding_) visit_bands(edge, [&](std::size_t band) { ++bands.starts[band + 2]; });
    for (std::size_t b = 2; b < bands.starts.size(); ++b) bands.starts[b] += bands.starts[b - 1];
    bands.edges.resize(bands.starts.back());
    for (std::uint32_t e = 0; e < hiding_.size(); ++e) {
        visit_bands(hiding_[e], [&](std::size_t band) { bands.edges[bands.starts[band + 1]++] = e; });
    }
}

/// Of a pair of paths along one axis, the one on whose edges' positive side the point lies stands last.
void Walker::find_entrances(const Aim& aim, Path* pair) const {
    const int along = pair->along, across = pair->across();
    const Bands& bands = bands_[static_cast<std::size_t>(across)];
    const double level = aim.position[across];
    const std::size_t band = bands.band_of(level);
    for (std::uint32_t i = bands.starts[band]; i < bands.starts[band + 1]; ++i) {
        const HidingEdge& edge = hiding_[bands.edges[i]];
        const glm::dvec2 *lower = &edge.a.point.position, *upper = &edge.b.point.position;
        const bool is_turned = (*lower)[across] > (*upper)[across];
        if (is_turned) std::swap(lower, upper);
        if ((*lower)[across] > level || !((*upper)[across] > level)) continue;
        const bool is_positive = orientation(*lower, *upper, aim.position) > 0;
        // Sheets gained from the far side to the point's.
        const int step = is_turned ? -edge.step : edge.step;
        const int gain = is_positive ? -step : step;
        if (gain <= 0) continue;
        const double share = (level - (*lower)[across]) / ((*upper)[across] - (*lower)[across]);
        const double meets = (*lower)[along] + share * ((*upper)[along] - (*lower)[along]);
        Path& path = pair[is_positive ? 1 : 0];
        path.entrances.push_back({bands.edges[i], std::abs(meets - aim.position[along])});
        path.length += gain * path.entrances.back().distance;
    }
}

Walker::Walk Walker::walk(const Aim& aim) const {
    Walk walk;
    if (hiding_.empty()) return walk;
    std::array<Path, 4> paths;
    for (const int along : {0, 1}) {
        Path* const pair = &paths[static_cast<std::size_t>(2 * along)];
        for (const int positive : {0, 1}) {
            pair[positive].along = along;
            pair[positive].is_positive = positive == 1;
        }
        find_entrances(aim, pair);
        if (pair[0].entrances.empty() || pair[1].entrances.empty()) return walk;
    }
    Path& path = *std::min_element(paths.begin(), paths.end(),
                                   [](const Path& one, const Path& other) { return one.length < other.length; });
    std::sort(path.entrances.begin(), path.entrances.end(), [](const Entrance& one, const Entrance& other) {
        return one.distance != other.distance ? one.distance < other.distance : one.hiding < other.hiding;
    });
    for (const Entrance& entrance : path.entrances) {
        if (walk.layers >= aim.at_most) break;
        enter(aim, path, entrance, walk);
    }
    return walk;
}

/// Sheets that come up to an edge from beyond go on in as many of those on this side, in the order of their faces,
/// however many faces the edge has; those left over begin here. Which of them go on does not matter to their number.
void Walker::enter(const Aim& aim, const Path& path, const Entrance& entrance, Walk& walk) const {
    const HidingEdge& edge = hiding_[entrance.hiding];
    Gate gate{edge.a, edge.b};
    const int across = path.across();
    if (gate.lower.point.position[across] > gate.upper.point.position[across]) std::swap(gate.lower, gate.upper);
    const model::Edge upward{{gate.lower.vertex, gate.upper.vertex}};
    const int here = path.is_positive ? -1 : 1;
    std::uint32_t from_beyond = 0;
    visit_faces(surface_, gate.lower.vertex, gate.upper.vertex, [&](std::uint32_t f) {
        from_beyond += side_of(surface_, upward, f, view_) != here ? 1 : 0;
        return true;
    });
    visit_faces(surface_, gate.lower.vertex, gate.upper.vertex, [&](std::uint32_t f) {
        if (side_of(surface_, upward, f, view_) != here) return true;
        if (from_beyond > 0) {
            --from_beyond;
            return true;
        }
        ++walk.sheets;
        if (follow(aim, path, gate, f, walk)) ++walk.layers;
        return walk.layers < aim.at_most;
    });
}

/// True when the sheet that a face continues from a gate comes to lie over the point and counts there.
bool Walker::follow(const Aim& aim, const Path& path, Gate gate, std::uint32_t face, Walk& walk) const {
    const int across = path.across(), along = path.along;
    const double level = aim.position[across];
    while (face != model::no_face) {
        ++walk.faces;
        const End apex = end_at(
            corner_opposite(surface_.topology().faces[face], model::Edge{{gate.lower.vertex, gate.upper.vertex}}));
        Gate exit = gate;
        (apex.point.position[across] > level ? exit.upper : exit.lower) = apex;
        const bool is_beyond =
            (orientation(exit.lower.point.position, exit.upper.point.position, aim.position) > 0) == path.is_positive;
        if (is_beyond) {
            face = next_face(path, exit, face);
            gate = exit;
            continue;
        }
        const model::Face& over = surface_.topology().faces[face];
        if (holds(over, aim.own_edge[0]) && holds(over, aim.own_edge[1])) return false;
        const auto at_level = [&](const Gate& g) {
            const ImagePoint &lower = g.lower.point, &upper = g.upper.point;
            const double share = (level - lower.position[across]) / (upper.position[across] - lower.position[across]);
            return ImagePoint{lower.position + share * (upper.position - lower.position),
                              lower.nearness + share * (upper.nearness - lower.nearness)};
        };
        const ImagePoint enters = at_level(gate), leaves = at_level(exit);
        const double length = enters.position[along] - leaves.position[along];
        const double passed = enters.position[along] - aim.position[along];
        const double share = length != 0 ? std::clamp(passed / length, 0.0, 1.0) : 0.0;
        const double nearness = enters.nearness + share * (leaves.nearness - enters.nearness);
        return view_.distance_of(nearness) < aim.eye_distance;
    }
    return false;
}

/// The face beyond a gate that goes on with a face's sheet; none where it turns back or ends.
std::uint32_t Walker::next_face(const Path& path, const Gate& gate, std::uint32_t face) const {
    const model::Edge upward{{gate.lower.vertex, gate.upper.vertex}};
    const int here = path.is_positive ? -1 : 1;
    std::uint32_t rank = 0;
    visit_faces(surface_, gate.lower.vertex, gate.upper.vertex, [&](std::uint32_t f) {
        if (f == face) return false;
        rank += side_of(surface_, upward, f, view_) != here ? 1 : 0;
        return true;
    });
    std::uint32_t next = model::no_face;
    visit_faces(surface_, gate.lower.vertex, gate.upper.vertex, [&](std::uint32_t f) {
        if (side_of(surface_, upward, f, view_) != here || rank-- > 0) return true;
        next = f;
        return false;
    });
    return next;
}

WalkProbe::WalkProbe(const Walker& walker, const Surface& surface, const ImageEdges& edges, const Viewpoint& view,
                     double tolerance)
    : walker_(walker), surface_(surface), edges_(edges), view_(view), tolerance_(tolerance) {}

std::uint32_t WalkProbe::layers(const ImageEdge& edge, double share, std::uint32_t at_most) const {
    const ImagePoint point = edges_.point_at(edge, share);
    Walker::Aim aim;
    aim.position = point.position;
    aim.eye_distance = view_.distance_of(point.nearness) - tolerance_;
    aim.own_edge = surface_.topology().edges[edge.edge].vertices;
    aim.at_most = at_most;
    return walker_.walk(aim).layers;
}

bool WalkProbe::is_open_behind(const ImageEdge& edge, const ImagePoint& beside) const {
    Walker::Aim aim;
    aim.position = beside.position;
    aim.own_edge = surface_.topology().edges[edge.edge].vertices;
    aim.at_most = 1;
    return walker_.walk(aim).layers == 0;
}

}  // namespace croquis::lines
