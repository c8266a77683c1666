#include "output/curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "output/cubic_fit.h"

namespace croquis::output {
namespace {

constexpr double sharp_turn = 1.05;   // radians: more is a corner however short its sides are
constexpr double same_point = 1e-3;   // of the tolerance
constexpr int samples_a_segment = 3;  // of a smooth one
constexpr int most_rounds = 8;

double angle_between(const glm::dvec2& a, const glm::dvec2& b) {
    return std::abs(std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b)));
}

glm::dvec2 unit(const glm::dvec2& along) { return along / glm::length(along); }

// The points without repetitions; both ends stay where they are.
std::vector<glm::dvec2> distinct(std::span<const glm::dvec2> points, bool closed, double least) {
    std::vector<glm::dvec2> kept;
    for (const glm::dvec2& point : points) {
        if (kept.empty() || glm::distance(kept.back(), point) > least) kept.push_back(point);
    }
    if (closed) {
        while (kept.size() > 1 && glm::distance(kept.back(), kept.front()) <= least) kept.pop_back();
    } else if (kept.size() > 1) {
        kept.back() = points.back();
    }
    return kept;
}

/// Decides which points of a line are corners, which segments between them are straight, and what the direction is at
/// all others.
class Shape {
public:
    Shape(std::span<const glm::dvec2> points, bool closed, double bulge)
        : points_(points), closed_(closed), bulge_(bulge), segments_(closed ? points.size() : points.size() - 1) {
        for (std::size_t i = 0; i < segments_.size(); ++i) {
            const glm::dvec2 along = point(i + 1) - point(i);
            segments_[i].length = glm::length(along);
            segments_[i].direction = along / segments_[i].length;
        }
        find_sharp_corners();
        for (int round = 0; round < most_rounds && straighten(); ++round) settle_joins();
    }

    [[nodiscard]] std::size_t segment_count() const { return segments_.size(); }
    [[nodiscard]] bool is_straight(std::size_t segment) const { return segments_[segment].is_straight; }
    [[nodiscard]] bool is_corner(std::size_t i) const { return joins_[i % joins_.size()].is_corner; }
    [[nodiscard]] const glm::dvec2& point(std::size_t i) const { return points_[i % points_.size()]; }

    /// The direction in which a smooth line runs at both ends of a segment.
    [[nodiscard]] std::array<glm::dvec2, 2> directions(std::size_t segment) const {
        const glm::dvec2& chord = segments_[segment].direction;
        const Join &from = join(segment), &to = join(segment + 1);
        // At a corner the line goes on as an arc of a circle that ends as the other end says.
        const auto mirrored = [&](const glm::dvec2& other) { return 2.0 * glm::dot(chord, other) * chord - other; };
        if (from.is_corner && to.is_corner) return {chord, chord};
        return {from.is_corner ? mirrored(to.direction) : from.direction,
                to.is_corner ? mirrored(from.direction) : to.direction};
    }

    /// Where, and how directed, a smooth line is at some shares of a segment: it is the circle's arc where both ends
    /// turn alike.
    void append_samples(std::size_t segment, std::vector<CurveSample>& samples) const {
        const std::array<glm::dvec2, 2> ends = directions(segment);
        const glm::dvec2 &a = point(segment), &b = point(segment + 1);
        const double turn = 0.5 * turn_of(segment);
        const double handle = segments_[segment].length / (3 * std::pow(std::cos(0.5 * turn), 2));
        const Cubic cubic{{a, a + handle * ends[0], b - handle * ends[1], b}};
        for (int i = samples.empty() ? 0 : 1; i <= samples_a_segment; ++i) {
            const double t = double(i) / samples_a_segment;
            samples.push_back({cubic.at(t), unit(cubic.slope(t))});
        }
        samples.back().position = b;
    }

private:
    struct Segment {
        glm::dvec2 direction{0.0};
        double length = 0;
        bool is_straight = false;
    };
    struct Join {
        glm::dvec2 direction{0.0};
        bool is_corner = false;
    };

    [[nodiscard]] const Join& join(std::size_t i) const { return joins_[i % joins_.size()]; }

    // The sum of the turns at both ends of a segment, from its own direction.
    [[nodiscard]] double turn_of(std::size_t segment) const {
        const std::array<glm::dvec2, 2> ends = directions(segment);
        const glm::dvec2& chord = segments_[segment].direction;
        return angle_between(ends[0], chord) + angle_between(ends[1], chord);
    }

    // How far the line leaves the segment: the height of a flat arc whose ends turn so much.
    [[nodiscard]] double bulge_of(std::size_t segment) const {
        return segments_[segment].length * turn_of(segment) / 8;
    }

    // Calls `visit(join, segment before, segment after)` wherever two segments meet.
    template <typename Visit>
    void at_joins(const Visit& visit) {
        for (std::size_t i = closed_ ? 0 : 1; i < segments_.size(); ++i) {
            visit(joins_[i], (i + segments_.size() - 1) % segments_.size(), i);
        }
    }

    void find_sharp_corners() {
        joins_.assign(points_.size(), Join{{}, true});
        at_joins([&](Join& join, std::size_t before, std::size_t after) {
            const Segment &in = segments_[before], &out = segments_[after];
            if (angle_between(in.direction, out.direction) > sharp_turn) return;
            join.is_corner = false;
            // Of the circle through the point and its neighbours.
            join.direction = unit(in.direction * out.length + out.direction * in.length);
        });
    }

    // Finds more segments that are too long to bend as much as their ends tell; whether it found any.
    bool straighten() {
        bool found = false;
        for (std::size_t i = 0; i < segments_.size(); ++i) {
            const bool between_corners = join(i).is_corner && join(i + 1).is_corner;
            if (segments_[i].is_straight || !(between_corners || bulge_of(i) > bulge_)) continue;
            segments_[i].is_straight = found = true;
        }
        return found;
    }

    // A smooth line leaves a straight segment in its direction, if that does not bend it too much.
    void settle_joins() {
        at_joins([&](Join& join, std::size_t before, std::size_t after) {
            const bool in_straight = segments_[before].is_straight, out_straight = segments_[after].is_straight;
            if (join.is_corner || (!in_straight && !out_straight)) return;
            join.direction = segments_[in_straight ? before : after].direction;
            join.is_corner = (in_straight && out_straight) || bulge_of(in_straight ? after : before) > bulge_;
        });
    }

    std::span<const glm::dvec2> points_;
    bool closed_;
    double bulge_;
    std::vector<Segment> segments_;
    std::vector<Join> joins_;
};

}  // namespace

Curve fit_curve(std::span<const glm::dvec2> points, bool closed, const CurveLimits& limits) {
    Curve curve;
    curve.closed = closed;
    const std::vector<glm::dvec2> nodes = distinct(points, closed, same_point * limits.tolerance);
    if (nodes.empty()) return curve;
    curve.start = nodes.front();
    if (nodes.size() == 1) return curve;
    const Shape shape(nodes, closed, limits.bulge);
    std::vector<CurveSample> samples;
    for (std::size_t i = 0; i < shape.segment_count(); ++i) {
        if (shape.is_straight(i)) {
            curve.pieces.push_back({CurvePiece::Kind::straight, {}, {}, shape.point(i + 1)});
            continue;
        }
        shape.append_samples(i, samples);
        const bool goes_on = i + 1 < shape.segment_count() && !shape.is_corner(i + 1) && !shape.is_straight(i + 1);
        if (goes_on) continue;
        fit_cubics(samples, limits.tolerance, curve.pieces);
        samples.clear();
    }
    return curve;
}

}  // namespace croquis::output
