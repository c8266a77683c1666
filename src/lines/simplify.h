// Leaving out points that say nothing about the course of a line.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace croquis::lines {

[[nodiscard]] double distance_to_segment(const glm::dvec2& point, const glm::dvec2& a, const glm::dvec2& b);

/// Marks the points between points[first] and points[last] that are needed so that none of the others lies farther than
/// `tolerance` from the line through those that are kept (Douglas and Peucker 1973).
void mark_bends(std::span<const glm::dvec2> points, std::size_t first, std::size_t last, double tolerance,
                std::vector<bool>& kept);

}  // namespace croquis::lines
