// Outlines of strokes. Every piece of the spine is a quadrangle that turns one way, and every join a wedge that turns
// the same way; their sum is the outline, so that filling what it winds round at all fills exactly their union.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "lines/stroke_mesh.h"
#include "lines/stroke_spine.h"

namespace croquis::lines {
namespace {

struct Disc {
    glm::dvec2 centre;
    double radius;
};

double turn_between(const glm::dvec2& in, const glm::dvec2& out) {
    return std::atan2(in.x * out.y - in.y * out.x, glm::dot(in, out));
}

// Points of an arc from `from`, which is not one of them, around the disc.
void add_arc(const Disc& disc, const glm::dvec2& from, double turn, double tolerance, Ring& ring) {
    const double step = 2 * std::acos(std::max(0.5, 1 - tolerance / std::max(disc.radius, tolerance)));
    const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(turn) / step)));
    for (int i = 1; i <= steps; ++i) {
        const double c = std::cos(turn * i / steps), s = std::sin(turn * i / steps);
        ring.push_back(disc.centre + disc.radius * glm::dvec2(c * from.x - s * from.y, s * from.x + c * from.y));
    }
}

// One side of a stroke, from its beginning to its end.
class Side {
public:
    // `sign`: 1 for the left side, -1 for the right one.
    Side(const std::vector<Disc>& spine, double sign, double tolerance)
        : spine_(spine), sign_(sign), tolerance_(tolerance) {}

    [[nodiscard]] Ring border(bool closed) const {
        Ring ring;
        const std::size_t count = spine_.size();
        if (!closed) ring.push_back(spine_[0].centre + spine_[0].radius * normal(0));
        for (std::size_t i = 1; i + 1 < count; ++i) join(i, direction(i - 1), direction(i), ring);
        if (closed) {
            join(count - 1, direction(count - 2), direction(0), ring);
        } else {
            ring.push_back(spine_.back().centre + spine_.back().radius * normal(count - 2));
        }
        return ring;
    }

    [[nodiscard]] glm::dvec2 direction(std::size_t i) const {
        return glm::normalize(spine_[i + 1].centre - spine_[i].centre);
    }

private:
    [[nodiscard]] glm::dvec2 normal(std::size_t i) const { return sign_ * left_of(direction(i)); }

    void join(std::size_t i, const glm::dvec2& in, const glm::dvec2& out, Ring& ring) const {
        const Disc& disc = spine_[i];
        const glm::dvec2 before = sign_ * left_of(in), after = sign_ * left_of(out);
        const double turn = turn_between(in, out);
        const glm::dvec2 next = spine_[i + 1 < spine_.size() ? i + 1 : 1].centre;
        const double shorter =
            std::min(glm::distance(spine_[i - 1].centre, disc.centre), glm::distance(disc.centre, next));
        const double secant = 1 / std::cos(turn / 2);
        const bool is_mitred = disc.radius * (secant - 1) < tolerance_ && std::abs(turn) < 1 &&
                               disc.radius * std::abs(std::tan(turn / 2)) < 0.5 * shorter;
        if (is_mitred) {
            ring.push_back(disc.centre + disc.radius * secant * glm::normalize(before + after));
            return;
        }
        ring.push_back(disc.centre + disc.radius * before);
        if (sign_ * turn > 0) {  // the outer side
            add_arc(disc, before, turn, tolerance_, ring);
        } else {
            ring.push_back(disc.centre);
            ring.push_back(disc.centre + disc.radius * after);
        }
    }

    const std::vector<Disc>& spine_;
    double sign_, tolerance_;
};

std::vector<Disc> discs_of(std::span<const StrokePoint> points, bool closed) {
    constexpr double same_place = 1e-6;
    std::vector<Disc> discs;
    const auto add = [&](const StrokePoint& point) {
        if (!discs.empty() && glm::distance(discs.back().centre, point.position) < same_place) return;
        discs.push_back({point.position, 0.5 * point.width});
    };
    for (const StrokePoint& point : points) add(point);
    if (closed && discs.size() > 1) add(points.front());
    return discs;
}

}  // namespace

std::vector<Ring> outline_of(const Strokes& strokes, const Stroke& stroke, double tolerance) {
    const std::vector<Disc> discs = discs_of(strokes.points_of(stroke), stroke.closed);
    if (discs.size() < 2) return {};
    const Side left(discs, 1, tolerance), right(discs, -1, tolerance);
    Ring forth = left.border(stroke.closed), back = right.border(stroke.closed);
    std::reverse(back.begin(), back.end());
    if (stroke.closed) return {forth, back};

    const bool is_round = strokes.brushes[stroke.brush].ends == StrokeEnds::round;
    const double half_turn = std::numbers::pi;
    if (is_round) {
        add_arc(discs.back(), left_of(left.direction(discs.size() - 2)), half_turn, tolerance, forth);
        forth.pop_back();  // the right side begins there
    }
    forth.insert(forth.end(), back.begin(), back.end());
    if (is_round) {
        add_arc(discs.front(), -left_of(left.direction(0)), half_turn, tolerance, forth);
        forth.pop_back();
    }
    return {forth};
}

}  // namespace croquis::lines
