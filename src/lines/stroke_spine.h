// A polyline by its arc length, with its frame of tangent and normal: what strokes are laid along (seed D, section 4).
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace croquis::lines {

/// A place on a line, and what widths depend on there.
struct SpinePoint {
    glm::dvec2 position{0.0};  ///< pixels
    double depth = 0;          ///< eye distance, scene units
    double light = 0;          ///< 0: the surface is turned from the light; 1: it faces it
};

/// A polyline of at least two points, none of which lies where the one before it does.
class Spine {
public:
    /// Takes the points; what falls together with its forerunner is left out. `is_usable` says whether enough is left.
    void assign(std::span<const SpinePoint> points, bool closed);
    [[nodiscard]] bool is_usable() const { return points_.size() > 1; }

    [[nodiscard]] bool closed() const { return closed_; }
    [[nodiscard]] double length() const { return along_.back(); }

    /// The vertices; a closed line's first one stands at the end again.
    [[nodiscard]] std::span<const SpinePoint> vertices() const { return points_; }
    /// How far along the line each vertex lies, pixels.
    [[nodiscard]] std::span<const double> along() const { return along_; }

    /// The point at an arc length. Beyond the ends of an open line it is the end; a closed line goes round.
    [[nodiscard]] SpinePoint at(double along) const;

    /// The unit tangent: the direction from `reach` pixels before to `reach` pixels behind. So it turns steadily where
    /// the polyline has corners, and is exact on straight lines and, by symmetry, on circles.
    [[nodiscard]] glm::dvec2 tangent(double along, double reach) const;

    /// Lengthens an open line at its ends, straight on.
    void extend(double at_start, double at_end, double reach);

private:
    [[nodiscard]] std::size_t segment_at(double along) const;

    std::vector<SpinePoint> points_;
    std::vector<double> along_;
    bool closed_ = false;
    mutable std::size_t last_segment_ = 0;  // where the last question was: the next is mostly near
};

/// To the left of a direction, on a page whose y axis points down.
[[nodiscard]] inline glm::dvec2 left_of(const glm::dvec2& direction) { return {direction.y, -direction.x}; }

}  // namespace croquis::lines
