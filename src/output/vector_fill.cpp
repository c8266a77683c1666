#include "output/vector_fill.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>

#include "output/plotter.h"

namespace croquis::output {
namespace {

using lines::Surface;
using lines::Viewpoint;

struct DirectedEdge {
    std::uint32_t from = 0, to = 0;
};

// The edges of all faces that count, less those that cancel out.
class AreaEdges {
public:
    AreaEdges(const Surface& surface, const Viewpoint& view) : surface_(surface), view_(view) {
        const auto vertices = std::uint32_t(surface.vertex_count());
        distances_.resize(vertices);
        for (std::uint32_t v = 0; v < vertices; ++v) distances_[v] = view.eye_distance(surface.point(v));
        const bool cuts_near =
            is_perspective() && std::any_of(distances_.begin(), distances_.end(),
                                            [&](double distance) { return distance < view.near_distance; });
        const auto& topology = surface.topology();
        for (std::uint32_t f = 0; f < topology.faces.size(); ++f) {
            const bool is_front = surface.front_facing(f, view);
            // Of a solid body the faces that are turned away lie behind others, unless the eye is inside.
            if (!is_front && !cuts_near && topology.mesh_is_solid[topology.faces[f].mesh]) continue;
            auto corners = topology.faces[f].vertices;
            if (!is_front) std::swap(corners[1], corners[2]);
            add_face(corners);
        }
    }

    [[nodiscard]] std::vector<Ring> rings() {
        const std::vector<DirectedEdge> edges = uncancelled();
        std::vector<bool> is_used(edges.size(), false);
        const auto starts_before = [](const DirectedEdge& edge, std::uint32_t vertex) { return edge.from < vertex; };
        const auto unused_from = [&](std::uint32_t vertex) {
            auto place = std::lower_bound(edges.begin(), edges.end(), vertex, starts_before);
            auto i = std::size_t(place - edges.begin());
            while (is_used[i]) ++i;  // as many edges leave a vertex as come to it
            return i;
        };
        std::vector<Ring> rings;
        for (std::size_t first = 0; first < edges.size(); ++first) {
            if (is_used[first]) continue;
            Ring ring;
            ring.closed = true;
            std::size_t i = first;
            for (;;) {
                is_used[i] = true;
                ring.points.push_back(place(edges[i].from));
                if (edges[i].to == edges[first].from) break;
                i = unused_from(edges[i].to);
            }
            rings.push_back(std::move(ring));
        }
        return rings;
    }

private:
    [[nodiscard]] bool is_perspective() const { return view_.projection == model::Projection::perspective; }
    [[nodiscard]] bool is_in_front(std::uint32_t vertex) const {
        return !is_perspective() || distances_[vertex] >= view_.near_distance;
    }

    [[nodiscard]] glm::dvec2 place(std::uint32_t vertex) const {
        const auto count = std::uint32_t(surface_.vertex_count());
        return view_.project(vertex < count ? surface_.point(vertex) : cut_points_[vertex - count]).position;
    }

    // Where an edge passes the near plane: a vertex of its own, the same for all faces at the edge.
    std::uint32_t cut_vertex(std::uint32_t a, std::uint32_t b) {
        if (a > b) std::swap(a, b);
        const auto next = std::uint32_t(surface_.vertex_count() + cut_points_.size());
        const auto [entry, is_new] = cut_vertices_.try_emplace(std::uint64_t(a) << 32 | b, next);
        if (is_new) {
            const double share = (view_.near_distance - distances_[a]) / (distances_[b] - distances_[a]);
            cut_points_.push_back(surface_.point(a) + share * (surface_.point(b) - surface_.point(a)));
        }
        return entry->second;
    }

    void add_face(const std::array<std::uint32_t, 3>& corners) {
        std::array<std::uint32_t, 4> polygon{};
        std::size_t count = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = corners[i], b = corners[(i + 1) % 3];
            if (is_in_front(a)) polygon[count++] = a;
            if (is_in_front(a) != is_in_front(b)) polygon[count++] = cut_vertex(a, b);
        }
        for (std::size_t i = 0; i < count; ++i) edges_.push_back({polygon[i], polygon[(i + 1) % count]});
    }

    // Edges that are passed more often one way than the other, sorted by where they start.
    [[nodiscard]] std::vector<DirectedEdge> uncancelled() {
        const auto pair_of = [](const DirectedEdge& edge) {
            return std::uint64_t(std::min(edge.from, edge.to)) << 32 | std::max(edge.from, edge.to);
        };
        std::sort(edges_.begin(), edges_.end(),
                  [&](const DirectedEdge& a, const DirectedEdge& b) { return pair_of(a) < pair_of(b); });
        std::vector<DirectedEdge> left;
        for (std::size_t i = 0; i < edges_.size();) {
            const std::uint64_t pair = pair_of(edges_[i]);
            const DirectedEdge upwards{std::uint32_t(pair >> 32), std::uint32_t(pair)};
            int turns = 0;
            for (; i < edges_.size() && pair_of(edges_[i]) == pair; ++i)
                turns += edges_[i].from == upwards.from ? 1 : -1;
            for (; turns > 0; --turns) left.push_back(upwards);
            for (; turns < 0; ++turns) left.push_back({upwards.to, upwards.from});
        }
        std::stable_sort(left.begin(), left.end(),
                         [](const DirectedEdge& a, const DirectedEdge& b) { return a.from < b.from; });
        return left;
    }

    const Surface& surface_;
    const Viewpoint& view_;
    std::vector<double> distances_;
    std::vector<DirectedEdge> edges_;
    std::unordered_map<std::uint64_t, std::uint32_t> cut_vertices_;
    std::vector<glm::dvec3> cut_points_;
};

// Keeps the side of a line across the frame: Sutherland and Hodgman's step. `height` is positive on that side.
template <typename Height>
std::vector<glm::dvec2> cut_by(const std::vector<glm::dvec2>& points, const Height& height) {
    std::vector<glm::dvec2> kept;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec2& a = points[i];
        const glm::dvec2& b = points[(i + 1) % points.size()];
        const double at_a = height(a), at_b = height(b);
        if (at_a >= 0) kept.push_back(a);
        if ((at_a >= 0) != (at_b >= 0)) kept.push_back(a + (at_a / (at_a - at_b)) * (b - a));
    }
    return kept;
}

}  // namespace

Ring cut_to_frame(const Ring& ring, double width, double height) {
    const bool is_inside = std::all_of(ring.points.begin(), ring.points.end(), [&](const glm::dvec2& point) {
        return point.x >= 0 && point.x <= width && point.y >= 0 && point.y <= height;
    });
    if (is_inside) return ring;
    Ring cut = ring;
    cut.points = cut_by(cut.points, [](const glm::dvec2& point) { return point.x; });
    cut.points = cut_by(cut.points, [&](const glm::dvec2& point) { return width - point.x; });
    cut.points = cut_by(cut.points, [](const glm::dvec2& point) { return point.y; });
    cut.points = cut_by(cut.points, [&](const glm::dvec2& point) { return height - point.y; });
    return cut;
}

std::vector<Ring> covered_area(const Surface& surface, const Viewpoint& view) {
    std::vector<Ring> rings = AreaEdges(surface, view).rings();
    for (Ring& ring : rings) ring = cut_to_frame(ring, view.width, view.height);
    constexpr double unseen = 0.004;  // pixels
    drop_idle_points(rings, unseen);
    std::erase_if(rings, [](const Ring& ring) { return ring.points.size() < 3; });
    return rings;
}

}  // namespace croquis::output
