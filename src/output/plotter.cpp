#include "output/plotter.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "lines/simplify.h"

namespace croquis::output {
namespace {

double length_of(const Ring& ring) {
    double length = 0;
    for (std::size_t i = 1; i < ring.points.size(); ++i) length += glm::distance(ring.points[i - 1], ring.points[i]);
    if (ring.closed && ring.points.size() > 1) length += glm::distance(ring.points.back(), ring.points.front());
    return length;
}

// Bends of a long line may lie straight between the two that are left beside them.
void drop_straight(std::vector<glm::dvec2>& points, double tolerance) {
    std::size_t count = 1;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        if (lines::distance_to_segment(points[i], points[count - 1], points[i + 1]) > tolerance)
            points[count++] = points[i];
    }
    points[count++] = points.back();
    points.resize(count);
}

void drop_idle_points(Ring& ring, double tolerance) {
    std::vector<glm::dvec2>& points = ring.points;
    const auto is_repeated = [&](const glm::dvec2& a, const glm::dvec2& b) { return glm::distance(a, b) <= 1e-6; };
    points.erase(std::unique(points.begin(), points.end(), is_repeated), points.end());
    while (ring.closed && points.size() > 1 && is_repeated(points.front(), points.back())) points.pop_back();
    if (points.size() < 3) {
        ring.closed = false;
        return;
    }
    if (ring.closed) {
        // The point farthest from the first is certainly a bend: a closed ring starts there, so that its first point
        // is no idle one.
        const glm::dvec2 start = points.front();
        const auto bend = std::max_element(points.begin(), points.end(), [&](const auto& a, const auto& b) {
            return glm::distance(a, start) < glm::distance(b, start);
        });
        std::rotate(points.begin(), bend, points.end());
        points.push_back(points.front());
    }
    std::vector<bool> kept(points.size(), false);
    kept.front() = kept.back() = true;
    lines::mark_bends(points, 0, points.size() - 1, tolerance, kept);
    std::size_t count = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (kept[i]) points[count++] = points[i];
    }
    points.resize(count);
    drop_straight(points, 0.5 * tolerance);
    if (ring.closed) points.pop_back();
    if (points.size() < 3) ring.closed = false;
}

}  // namespace

const glm::dvec2& end_of(const Ring& ring) { return ring.closed ? ring.points.front() : ring.points.back(); }

double travel_of(std::span<const Ring> rings, const glm::dvec2& start) {
    double travel = 0;
    glm::dvec2 pen = start;
    for (const Ring& ring : rings) {
        travel += glm::distance(pen, ring.points.front());
        pen = end_of(ring);
    }
    return travel;
}

double ink_of(std::span<const Ring> rings) {
    double length = 0;
    for (const Ring& ring : rings) length += length_of(ring);
    return length;
}

void drop_idle_points(std::vector<Ring>& rings, double line_tolerance) {
    for (Ring& ring : rings) drop_idle_points(ring, line_tolerance);
    std::erase_if(rings, [](const Ring& ring) { return ring.points.size() < 2; });
}

std::vector<Ring> plan_pen(std::vector<Ring> rings, const glm::dvec2& start, const PlotterOptions& options) {
    drop_idle_points(rings, options.line_tolerance);
    drop_overlaps(rings, options.overlap_tolerance);
    join_ends(rings, options.join_distance);
    drop_idle_points(rings, options.line_tolerance);
    order_rings(rings, start);
    return rings;
}

}  // namespace croquis::output
