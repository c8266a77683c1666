#include "lines/simplify.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

namespace croquis::lines {

double distance_to_segment(const glm::dvec2& point, const glm::dvec2& a, const glm::dvec2& b) {
    const glm::dvec2 along = b - a;
    const double square = glm::dot(along, along);
    const double share = square > 0 ? std::clamp(glm::dot(point - a, along) / square, 0.0, 1.0) : 0.0;
    return glm::distance(point, a + share * along);
}

// With a stack of its own: a long line would exhaust that of the thread.
void mark_bends(std::span<const glm::dvec2> points, std::size_t first, std::size_t last, double tolerance,
                std::vector<bool>& kept) {
    std::vector<std::pair<std::size_t, std::size_t>> ranges{{first, last}};
    while (!ranges.empty()) {
        const auto [begin, end] = ranges.back();
        ranges.pop_back();
        double farthest = tolerance;
        std::size_t bend = begin;
        for (std::size_t i = begin + 1; i < end; ++i) {
            const double distance = distance_to_segment(points[i], points[begin], points[end]);
            if (distance > farthest) {
                farthest = distance;
                bend = i;
            }
        }
        if (bend == begin) continue;
        kept[bend] = true;
        ranges.push_back({begin, bend});
        ranges.push_back({bend, end});
    }
}

}  // namespace croquis::lines
