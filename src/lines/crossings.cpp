#include "lines/crossings.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/common.hpp>

#include "base/error.h"
#include "base/parallel.h"
#include "lines/predicates.h"

namespace croquis::lines {
namespace {

constexpr std::size_t lines_a_piece = 256;
constexpr std::size_t most_crossings = 20'000'000;  // half a gigabyte
/// Of depths, relative to the larger one: within it two edges that cross in the picture may as well touch.
constexpr double depth_doubt = 1e-8;

/// Appends what two edges that cross in the picture are to each other.
void append_crossings(const ImageEdges& edges, std::uint32_t first, std::uint32_t second,
                      std::vector<Crossing>& found) {
    const ImageEdge& e = edges.edges()[first];
    const ImageEdge& f = edges.edges()[second];
    if (e.a == f.a || e.a == f.b || e.b == f.a || e.b == f.b) return;
    const ImageVertex &a = edges.vertices()[e.a], &b = edges.vertices()[e.b];
    const ImageVertex &c = edges.vertices()[f.a], &d = edges.vertices()[f.b];
    const double side_c = orientation(a.position, b.position, c.position);
    const double side_d = orientation(a.position, b.position, d.position);
    if ((side_c > 0) == (side_d > 0)) return;
    const double side_a = orientation(c.position, d.position, a.position);
    const double side_b = orientation(c.position, d.position, b.position);
    if ((side_a > 0) == (side_b > 0)) return;
    Crossing of_first{first, second, side_a / (side_a - side_b)};
    Crossing of_second{second, first, side_c / (side_c - side_d)};
    const double nearness = a.nearness + of_first.share * (b.nearness - a.nearness);
    const double other_nearness = c.nearness + of_second.share * (d.nearness - c.nearness);
    if (other_nearness > nearness) of_first.gain = static_cast<std::int8_t>(side_a > 0 ? f.step : -f.step);
    if (nearness > other_nearness) of_second.gain = static_cast<std::int8_t>(side_c > 0 ? e.step : -e.step);
    of_first.is_doubtful = of_second.is_doubtful =
        std::abs(other_nearness - nearness) <= depth_doubt * std::abs(nearness);
    if (f.step != 0) found.push_back(of_first);
    if (e.step != 0) found.push_back(of_second);
}

}  // namespace

/// Calls visit(cell) for every cell that the segment touches, row by row, with a margin far above rounding.
template <typename Visit>
void CrossingFinder::visit_cells(const glm::dvec2& a, const glm::dvec2& b, const Visit& visit) const {
    constexpr double margin = 1e-6;
    glm::dvec2 from = (a - grid_.low) * grid_.cells_a_pixel;
    glm::dvec2 to = (b - grid_.low) * grid_.cells_a_pixel;
    if (from.y > to.y) std::swap(from, to);
    const auto cell = [](double value, int count) { return static_cast<int>(std::clamp(value, 0.0, count - 1.0)); };
    const int first = cell(from.y - margin, grid_.rows), last = cell(to.y + margin, grid_.rows);
    const double slope = first == last ? 0.0 : (to.x - from.x) / std::max(to.y - from.y, 1e-300);
    const double left = std::min(from.x, to.x), right = std::max(from.x, to.x);
    for (int row = first; row <= last; ++row) {
        double low = left, high = right;
        if (first != last) {
            const double enter = from.x + slope * (row - margin - from.y);
            const double leave = from.x + slope * (row + 1 + margin - from.y);
            low = std::max(left, std::min(enter, leave));
            high = std::min(right, std::max(enter, leave));
        }
        const int end = cell(high + margin, grid_.columns);
        for (int column = cell(low - margin, grid_.columns); column <= end; ++column) {
            visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(grid_.columns) +
                  static_cast<std::size_t>(column));
        }
    }
}

void CrossingFinder::place_grid(const ImageEdges& edges) {
    hiding_.clear();
    boxes_.resize(edges.edges().size());
    glm::dvec2 low(1e300), high(-1e300);
    for (std::uint32_t e = 0; e < edges.edges().size(); ++e) {
        const ImageEdge& edge = edges.edges()[e];
        const glm::dvec2 &a = edges.vertices()[edge.a].position, &b = edges.vertices()[edge.b].position;
        constexpr float wide = 1e-2f;  // of a pixel: more than single precision rounds off
        const glm::vec2 least = glm::vec2(glm::min(a, b)) - wide, most = glm::vec2(glm::max(a, b)) + wide;
        boxes_[e] = {least.x, least.y, most.x, most.y};
        if (edge.step == 0) continue;
        hiding_.push_back(e);
        low = glm::min(low, glm::min(a, b));
        high = glm::max(high, glm::max(a, b));
    }
    const glm::dvec2 size = glm::max(high - low, glm::dvec2(1e-9));
    const double wanted = static_cast<double>(hiding_.size()) + 1.0;  // one cell an edge
    const double rows = std::clamp(std::sqrt(wanted * size.y / size.x), 1.0, 2048.0);
    grid_.rows = static_cast<int>(rows);
    grid_.columns = static_cast<int>(std::clamp(wanted / rows, 1.0, 2048.0));
    grid_.low = low;
    grid_.cells_a_pixel = glm::dvec2(grid_.columns, grid_.rows) / size;
}

void CrossingFinder::fill_grid(const ImageEdges& edges) {
    const auto visit_edge = [&](std::uint32_t e, const auto& visit) {
        const ImageEdge& edge = edges.edges()[e];
        visit_cells(edges.vertices()[edge.a].position, edges.vertices()[edge.b].position, visit);
    };
    cell_starts_.assign(static_cast<std::size_t>(grid_.rows) * static_cast<std::size_t>(grid_.columns) + 2, 0);
    for (const std::uint32_t e : hiding_) visit_edge(e, [&](std::size_t cell) { ++cell_starts_[cell + 2]; });
    for (std::size_t c = 2; c < cell_starts_.size(); ++c) cell_starts_[c] += cell_starts_[c - 1];
    cell_edges_.resize(cell_starts_.back());
    for (const std::uint32_t e : hiding_) {
        visit_edge(e, [&](std::size_t cell) { cell_edges_[cell_starts_[cell + 1]++] = e; });
    }
}

void CrossingFinder::test(const ImageEdges& edges, std::uint32_t line, std::vector<std::uint32_t>& met,
                          std::vector<Crossing>& found) const {
    const ImageEdge& edge = edges.edges()[line];
    const ImageVertex &a = edges.vertices()[edge.a], &b = edges.vertices()[edge.b];
    const Box box = boxes_[line];
    met.clear();
    visit_cells(a.position, b.position, [&](std::size_t cell) {
        for (std::uint32_t i = cell_starts_[cell]; i < cell_starts_[cell + 1]; ++i) {
            // Of two edges that hide, the earlier one sees to the pair.
            if (edge.step != 0 && cell_edges_[i] <= line) continue;
            const Box& other = boxes_[cell_edges_[i]];
            if (other.right < box.left || other.left > box.right || other.bottom < box.top || other.top > box.bottom) {
                continue;
            }
            met.push_back(cell_edges_[i]);
        }
    });
    if (met.size() > 1) std::sort(met.begin(), met.end());
    met.erase(std::unique(met.begin(), met.end()), met.end());
    for (const std::uint32_t other : met) append_crossings(edges, line, other, found);
}

void CrossingFinder::find(const ImageEdges& edges) {
    crossings_.clear();
    place_grid(edges);
    if (hiding_.empty()) return;
    fill_grid(edges);
    const std::size_t pieces = (edges.edges().size() + lines_a_piece - 1) / lines_a_piece;
    std::vector<std::vector<Crossing>> found(pieces);
    std::atomic<std::size_t> count = 0;
    parallel_for(pieces, 1, [&](std::size_t begin, std::size_t end) {
        std::vector<std::uint32_t> met;
        for (std::size_t p = begin; p < end && count < most_crossings; ++p) {
            const std::size_t last = std::min((p + 1) * lines_a_piece, edges.edges().size());
            for (std::size_t e = p * lines_a_piece; e < last && found[p].size() < most_crossings; ++e) {
                // An edge that only hides must be known too: layers pass on along it from line to line.
                test(edges, static_cast<std::uint32_t>(e), met, found[p]);
            }
            count += found[p].size();
        }
    });
    if (count >= most_crossings) {
        fail("expected lines that cross up to {} times in the picture, found more: a tangle of faces", most_crossings);
    }
    sort_by_edge(found, edges.edges().size());
}

void CrossingFinder::sort_by_edge(const std::vector<std::vector<Crossing>>& found, std::size_t edge_count) {
    edge_starts_.assign(edge_count + 2, 0);
    std::size_t count = 0;
    for (const auto& piece : found) {
        count += piece.size();
        for (const Crossing& crossing : piece) ++edge_starts_[crossing.edge + 2];
    }
    for (std::size_t e = 2; e < edge_starts_.size(); ++e) edge_starts_[e] += edge_starts_[e - 1];
    crossings_.resize(count);
    for (const auto& piece : found) {
        for (const Crossing& crossing : piece) crossings_[edge_starts_[crossing.edge + 1]++] = crossing;
    }
    for (std::size_t e = 0; e < edge_count; ++e) {
        const auto first = crossings_.begin() + edge_starts_[e], last = crossings_.begin() + edge_starts_[e + 1];
        if (last - first < 2) continue;
        std::sort(first, last, [](const Crossing& x, const Crossing& y) {
            return x.share != y.share ? x.share < y.share : x.other < y.other;
        });
    }
}

}  // namespace croquis::lines
