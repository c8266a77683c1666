// Finding vertices that stand at the same place: the base of topology and of smooth normals.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "model/progress.h"

namespace croquis::model {

/// Lists of points, one a mesh, in which equal positions share a number.
struct WeldedPoints {
    std::vector<glm::vec3> positions;        ///< one a distinct position, in the order of their first appearance
    std::vector<std::uint32_t> ids;          ///< all lists' points in turn: indices into `positions`
    std::vector<std::size_t> first_of_list;  ///< where each list starts in `ids`
};

/// Welds points at exactly equal positions; -0 equals 0, and the result holds no -0.
[[nodiscard]] WeldedPoints weld_points(std::span<const std::span<const glm::vec3>> lists,
                                       const Progress& progress = {});

/// Twice the area times the unit normal, computed in double so that neither tiny nor huge models lose it.
[[nodiscard]] inline glm::dvec3 area_vector(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return glm::cross(b - a, c - a);
}

/// True for a triangle that is more than a point or a line: what has a place in the topology.
[[nodiscard]] inline bool has_area(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 area = area_vector(a, b, c);
    return glm::dot(area, area) > 0;
}

}  // namespace croquis::model
