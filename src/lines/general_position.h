// A surface's points moved apart until no four lie in a plane, and the exact test of a plane's sides.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "lines/surface.h"

namespace croquis::lines {

/// The points of a surface, each moved at random by no more than the rounding of its coordinates in the file, onto a
/// grid on which sides of planes can be told exactly in whole numbers. So whether and where faces pass through each
/// other has one answer for all who ask, and curves in which they do neither end nor fork by rounding. A vertex moves
/// for all its faces alike, in every run alike.
class GeneralPosition {
public:
    explicit GeneralPosition(const Surface& surface);

    [[nodiscard]] const glm::dvec3& operator[](std::uint32_t vertex) const { return points_[vertex]; }

    /// The power of two that no coordinate exceeds; at rest at most 1.
    [[nodiscard]] double extent() const { return extent_; }
    /// How far a point may have been moved along each axis.
    [[nodiscard]] double largest_shift() const { return extent_ * shift_share; }

    /// Six times the volume of the tetrahedron over the triangle a, b, c, positive for a top on the side from which the
    /// triangle runs counter-clockwise: a rounded value, the sign of which is true.
    [[nodiscard]] double volume(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t top) const;

private:
    static constexpr double shift_share = 0x1p-24;  // half of what single precision keeps of the largest coordinates
    static constexpr double grid_share = 0x1p-40;   // of the extent; products of three differences fit in 128 bits

    [[nodiscard]] double exact_volume(const glm::dvec3& u, const glm::dvec3& v, const glm::dvec3& w) const;

    std::vector<glm::dvec3> points_;
    double extent_ = 1;
};

}  // namespace croquis::lines
