// Border edges are sorted into a grid by their middles; edges that coincide have a cell in common.
#include "model/sewing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>
#include <span>

#include "model/model.h"

namespace croquis::model {
namespace {

constexpr std::uint32_t none = 0xffffffffu;
constexpr double seams_a_cell = 16;      ///< the side of a cell, in seam widths
constexpr double seams_an_edge = 16;     ///< the shortest edge, in seam widths
constexpr std::size_t most_a_cell = 64;  ///< edges whose middles lie together closer than this are no clean seam

/// A border edge from `start` to `end`, as its face winds.
struct BorderEdge {
    std::uint32_t start = 0, end = 0;
};

/// A cell of the grid that the middle of a border edge lies in, or within a seam's width of.
struct Entry {
    std::uint64_t cell = 0;
    std::uint32_t edge = 0;
};

double width_of(const Topology& topology) {
    Bounds box;
    for (const glm::vec3& p : topology.positions) box.add(p);
    return seam_width * glm::distance(glm::dvec3(box.low), glm::dvec3(box.high));  // in double: squares may be tiny
}

std::vector<BorderEdge> border_edges(const Topology& topology, double shortest) {
    std::vector<BorderEdge> borders;
    for (const Edge& edge : topology.edges) {
        if (edge.faces[1] != no_face) continue;
        const auto [a, b] = edge.vertices;
        const glm::dvec3 along = glm::dvec3(topology.positions[b]) - glm::dvec3(topology.positions[a]);
        if (glm::length(along) < shortest) continue;
        const auto& v = topology.faces[edge.faces[0]].vertices;
        const bool forward = (v[0] == a && v[1] == b) || (v[1] == a && v[2] == b) || (v[2] == a && v[0] == b);
        borders.push_back(forward ? BorderEdge{a, b} : BorderEdge{b, a});
    }
    return borders;
}

/// Which border edges coincide.
class SeamFinder {
public:
    SeamFinder(const Topology& topology, std::span<const BorderEdge> borders, double width)
        : positions_(topology.positions), borders_(borders), width_(width), partner_(borders.size(), none) {
        fill_grid();
        std::size_t begin = 0;
        while (begin < grid_.size()) {
            std::size_t end = begin + 1;
            while (end < grid_.size() && grid_[end].cell == grid_[begin].cell) ++end;
            if (end - begin <= most_a_cell) compare(std::span<const Entry>(grid_).subspan(begin, end - begin));
            begin = end;
        }
    }

    /// The one edge that coincides with an edge and with no other; none where there is none.
    [[nodiscard]] std::uint32_t partner(std::uint32_t edge) const {
        const std::uint32_t other = partner_[edge];
        return other < borders_.size() && partner_[other] == edge ? other : none;
    }

private:
    static constexpr std::uint32_t several = none - 1;

    void fill_grid() {
        for (std::uint32_t e = 0; e < borders_.size(); ++e) {
            const glm::dvec3 middle = 0.5 * (point(borders_[e].start) + point(borders_[e].end));
            const glm::dvec3 cell = glm::dvec3(seams_a_cell * width_);
            const glm::dvec3 low = glm::floor((middle - width_) / cell), high = glm::floor((middle + width_) / cell);
            for (double x = low.x; x <= high.x; ++x)
                for (double y = low.y; y <= high.y; ++y)
                    for (double z = low.z; z <= high.z; ++z) grid_.push_back({cell_number(x, y, z), e});
        }
        std::sort(grid_.begin(), grid_.end(),
                  [](const Entry& a, const Entry& b) { return a.cell != b.cell ? a.cell < b.cell : a.edge < b.edge; });
    }

    /// Some 60,000 cells lie along the box; two that share a number cost a comparison, no more.
    static std::uint64_t cell_number(double x, double y, double z) {
        const auto part = [](double v) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(v)) & 0x1fffffu; };
        return part(x) << 42 | part(y) << 21 | part(z);
    }

    void compare(std::span<const Entry> cell) {
        for (std::size_t i = 0; i < cell.size(); ++i) {
            for (std::size_t j = i + 1; j < cell.size(); ++j) {
                const BorderEdge &a = borders_[cell[i].edge], &b = borders_[cell[j].edge];
                if (!near(a.start, b.end) || !near(a.end, b.start)) continue;
                note(cell[i].edge, cell[j].edge);
                note(cell[j].edge, cell[i].edge);
            }
        }
    }

    void note(std::uint32_t edge, std::uint32_t other) {
        if (partner_[edge] == none) partner_[edge] = other;
        if (partner_[edge] != other) partner_[edge] = several;
    }

    [[nodiscard]] bool near(std::uint32_t a, std::uint32_t b) const {
        return glm::distance(point(a), point(b)) <= width_;
    }
    [[nodiscard]] glm::dvec3 point(std::uint32_t vertex) const { return glm::dvec3(positions_[vertex]); }

    std::span<const glm::vec3> positions_;
    std::span<const BorderEdge> borders_;
    double width_;
    std::vector<Entry> grid_;
    std::vector<std::uint32_t> partner_;
};

/// Vertices that become one, named by the first of them.
class Clusters {
public:
    explicit Clusters(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
    }

    [[nodiscard]] std::uint32_t first(std::uint32_t vertex) {
        while (parent_[vertex] != vertex) vertex = parent_[vertex] = parent_[parent_[vertex]];
        return vertex;
    }

    void join(std::uint32_t a, std::uint32_t b) {
        a = first(a);
        b = first(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::uint32_t> parent_;
};

/// The clusters that hold two corners of one face.
std::vector<std::uint32_t> collapsing(const Topology& topology, Clusters& clusters) {
    std::vector<std::uint32_t> found;
    for (const Face& face : topology.faces) {
        const std::uint32_t a = clusters.first(face.vertices[0]), b = clusters.first(face.vertices[1]),
                            c = clusters.first(face.vertices[2]);
        if (a == b || a == c) found.push_back(a);
        if (b == c) found.push_back(b);
    }
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace

std::vector<std::uint32_t> sewn_vertices(const Topology& topology) {
    const double width = width_of(topology);
    const std::vector<BorderEdge> borders = border_edges(topology, seams_an_edge * width);
    const SeamFinder seams(topology, borders, width);
    Clusters clusters(topology.positions.size());
    bool any = false;
    for (std::uint32_t e = 0; e < borders.size(); ++e) {
        const std::uint32_t partner = seams.partner(e);
        if (partner == none) continue;
        clusters.join(borders[e].start, borders[partner].end);
        clusters.join(borders[e].end, borders[partner].start);
        any = true;
    }
    if (!any) return {};
    const std::vector<std::uint32_t> left_out = collapsing(topology, clusters);
    std::vector<std::uint32_t> number(topology.positions.size());
    std::uint32_t count = 0;
    for (std::uint32_t v = 0; v < number.size(); ++v) {
        const std::uint32_t first = clusters.first(v);
        const bool joins = first != v && !std::binary_search(left_out.begin(), left_out.end(), first);
        number[v] = joins ? number[first] : count++;
    }
    return count < number.size() ? number : std::vector<std::uint32_t>{};
}

}  // namespace croquis::model
