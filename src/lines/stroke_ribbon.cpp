#include "lines/stroke_ribbon.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>

#include "lines/stroke_spine.h"

namespace croquis::lines {
namespace {

constexpr double same_place = 1e-6;      // pixels
constexpr double flatness = 0.1;         // pixels that an arc may miss
constexpr double mitred_turn = 0.25;     // radians: up to here one crossbar serves a bend
constexpr double closest_points = 0.15;  // half widths: nearer ones say nothing of the ribbon
constexpr double window = 4;             // half widths along the spine within which a bend may fold the ribbon

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

// A vertex of the spine that a ribbon is made of.
struct Joint {
    glm::dvec2 position;
    double half_width, along;
    std::uint32_t point;
};

// A closed stroke is cut open in the middle of its longest piece, far from bends.
std::vector<StrokePoint> opened(std::span<const StrokePoint> points, std::uint32_t& first) {
    const std::size_t count = points.size();
    double longest = -1;
    for (std::size_t i = 0; i < count; ++i) {
        const double length = glm::distance(points[i].position, points[(i + 1) % count].position);
        if (length > longest) {
            longest = length;
            first = static_cast<std::uint32_t>(i);
        }
    }
    StrokePoint middle = points[first];
    const StrokePoint& next = points[(first + 1) % count];
    middle.position = 0.5 * (middle.position + next.position);
    middle.width = 0.5f * (middle.width + next.width);
    std::vector<StrokePoint> open{middle};
    for (std::size_t i = 1; i <= count; ++i) open.push_back(points[(first + i) % count]);
    open.push_back(middle);
    return open;
}

std::vector<Joint> joints_of(std::span<const StrokePoint> points) {
    std::vector<Joint> joints;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        Joint joint{points[i].position, 0.5 * points[i].width, 0, i};
        if (!joints.empty()) {
            const double distance = glm::distance(joints.back().position, joint.position);
            const double thinner = std::min(joint.half_width, joints.back().half_width);
            const double closest = std::max(same_place, closest_points * thinner);
            const bool is_last = i + 1 == points.size();
            if (distance < closest && !is_last) continue;
            if (distance < closest && joints.size() > 1) joints.pop_back();
            joint.along = joints.back().along + glm::distance(joints.back().position, joint.position);
        }
        joints.push_back(joint);
    }
    if (joints.size() < 2 || joints.back().along < same_place) joints.clear();
    return joints;
}

double arc_step(double radius) { return 2 * std::acos(std::max(0.5, 1 - flatness / std::max(radius, flatness))); }

glm::dvec2 rotated(const glm::dvec2& v, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * v.x - s * v.y, s * v.x + c * v.y};
}

// The crossbars of one joint, between two directions of the spine.
void add_joint(const Joint& joint, const glm::dvec2& in, const glm::dvec2& out, std::vector<Crossbar>& bars) {
    const glm::dvec2 &p = joint.position, before = left_of(in), after = left_of(out);
    const double h = joint.half_width;
    const double turn = std::atan2(cross(in, out), glm::dot(in, out));  // positive: to the right, for y points down
    const auto add = [&](const glm::dvec2& left, const glm::dvec2& right) {
        bars.push_back({p, p + left, p - right, joint.along, h, joint.point});
    };
    if (std::abs(turn) < mitred_turn) {
        const glm::dvec2 arm = glm::normalize(before + after) * (h / std::cos(turn / 2));
        return add(arm, arm);
    }
    const int steps = static_cast<int>(std::ceil(std::abs(turn) / arc_step(h)));
    for (int i = 0; i <= steps; ++i) {
        const glm::dvec2 outer = h * rotated(before, turn * i / steps);
        const glm::dvec2 inner = h * (2 * i <= steps ? before : after);
        turn > 0 ? add(outer, inner) : add(inner, outer);
    }
}

// Half a disc, as crossbars that grow shorter. `sign`: 1 at the end of the stroke, -1 at its beginning.
std::vector<Crossbar> round_end(const Joint& joint, const glm::dvec2& direction, double sign) {
    std::vector<Crossbar> bars;
    const double h = joint.half_width;
    const int steps = static_cast<int>(std::ceil(std::numbers::pi / 2 / arc_step(h)));
    for (int i = 1; i <= steps; ++i) {
        const double angle = std::numbers::pi / 2 * i / steps;
        const double ahead = sign * h * std::sin(angle);
        const glm::dvec2 centre = joint.position + ahead * direction;
        const glm::dvec2 arm = h * std::cos(angle) * left_of(direction);
        bars.push_back({centre, centre + arm, centre - arm, joint.along + ahead, h, joint.point});
    }
    if (sign < 0) std::reverse(bars.begin(), bars.end());
    return bars;
}

std::optional<glm::dvec2> crossing(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
    const glm::dvec2 first = b - a, second = d - c;
    const double area = cross(first, second);
    if (std::abs(area) < 1e-12) return std::nullopt;
    const double t = cross(c - a, second) / area, u = cross(c - a, first) / area;
    constexpr double slack = 1e-9;
    if (t < -slack || t > 1 + slack || u < -slack || u > 1 + slack) return std::nullopt;
    return a + t * first;
}

double distance_to_segment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
    const glm::dvec2 side = b - a;
    const double square = glm::dot(side, side);
    const double t = square > 0 ? std::clamp(glm::dot(p - a, side) / square, 0.0, 1.0) : 0.0;
    return glm::distance(p, a + t * side);
}

// The tips of one side's arms, and how bends fold them over each other.
class Rail {
public:
    Rail(std::vector<Crossbar>& bars, glm::dvec2 Crossbar::*tip) : bars_(bars), tip_(tip) {}

    // Where the rail runs backwards it makes a loop, which is cut off at its crossing; what has none is shortened.
    void unfold() {
        for (std::size_t i = 0; i + 1 < bars_.size(); ++i) {
            if (!runs_back(i)) continue;
            std::size_t last = i;
            while (last + 2 < bars_.size() && runs_back(last + 1)) ++last;
            if (const std::size_t end = cut_loop(i, last)) i = end - 1;
        }
        for (std::size_t i = 1; i < bars_.size(); ++i) shorten_crossing(i);
        for (std::size_t i = 0; i + 1 < bars_.size(); ++i) {
            if (is_corner(i) && runs_back(i)) drop_shorter_leg(i);
        }
    }

private:
    [[nodiscard]] glm::dvec2& tip(std::size_t i) const { return bars_[i].*tip_; }
    [[nodiscard]] bool is_corner(std::size_t i) const { return bars_[i].centre == bars_[i + 1].centre; }
    [[nodiscard]] double reach(std::size_t i) const { return window * bars_[i].half_width; }

    // A piece of the rail goes against the spine; at a corner, which never is the first or last joint, against the mean
    // of both directions.
    [[nodiscard]] bool runs_back(std::size_t i) const {
        const glm::dvec2 step = tip(i + 1) - tip(i);
        if (step == glm::dvec2(0)) return false;
        std::size_t before = i, after = i + 1;
        while (before > 0 && bars_[before].centre == bars_[i].centre) --before;
        while (after + 1 < bars_.size() && bars_[after].centre == bars_[i + 1].centre) ++after;
        const bool corner = is_corner(i);
        const glm::dvec2 from = corner ? bars_[before].centre : bars_[i].centre;
        const glm::dvec2 to = corner ? bars_[after].centre : bars_[i + 1].centre;
        if (!corner) return glm::dot(step, to - from) < 0;
        const glm::dvec2 in = glm::normalize(bars_[i].centre - from), out = glm::normalize(to - bars_[i].centre);
        return glm::dot(step, in + out) < 0;
    }

    // Looks for the crossing of the rail before the pieces first … last with the rail behind them, the nearest ones
    // first. Returns the last bar that was moved there, or 0.
    std::size_t cut_loop(std::size_t first, std::size_t last) {
        const double before = bars_[first].along - reach(first), behind = bars_[last].along + reach(last);
        for (std::size_t i = first; i-- > 0 && bars_[i + 1].along >= before;) {
            for (std::size_t j = last + 1; j + 1 < bars_.size() && bars_[j].along <= behind; ++j) {
                const auto found = crossing(tip(i), tip(i + 1), tip(j), tip(j + 1));
                if (!found || !is_on_border(*found, i, j)) continue;
                for (std::size_t k = i + 1; k <= j; ++k) tip(k) = *found;
                return j;
            }
        }
        return 0;
    }

    // Whether a point is no nearer to the spine around a loop than the stroke's border is.
    [[nodiscard]] bool is_on_border(const glm::dvec2& p, std::size_t i, std::size_t j) const {
        const double before = bars_[i].along - reach(i), behind = bars_[j].along + reach(j);
        while (i > 0 && bars_[i].along > before) --i;
        for (; i + 1 < bars_.size() && bars_[i].along < behind; ++i) {
            const double least = 0.96 * std::min(bars_[i].half_width, bars_[i + 1].half_width) - 0.02;
            if (distance_to_segment(p, bars_[i].centre, bars_[i + 1].centre) < least) return false;
        }
        return true;
    }

    // Arms that cross an earlier one end where they cross, and so do those between them.
    void shorten_crossing(std::size_t i) {
        const double before = bars_[i].along - reach(i);
        for (std::size_t j = i; j-- > 0 && bars_[j].along >= before;) {
            if (bars_[j].centre == bars_[i].centre || tip(j) == tip(i)) continue;
            const auto found = crossing(bars_[j].centre, tip(j), bars_[i].centre, tip(i));
            if (!found || *found == bars_[i].centre || *found == bars_[j].centre) continue;
            for (std::size_t k = j; k <= i; ++k) tip(k) = *found;
        }
    }

    // A leg so short that it lies within the other leg's half of the ribbon adds nothing on this side.
    void drop_shorter_leg(std::size_t corner) {
        const double here = bars_[corner].along, reach_here = 0.5 * reach(corner);
        if (bars_.back().along - here < here - bars_.front().along) {
            for (std::size_t k = corner + 1; k < bars_.size() && bars_[k].along < here + reach_here; ++k) {
                tip(k) = bars_[k].centre;
            }
        } else {
            for (std::size_t k = corner + 1; k-- > 0 && bars_[k].along > here - reach_here;) tip(k) = bars_[k].centre;
        }
    }

    std::vector<Crossbar>& bars_;
    glm::dvec2 Crossbar::*tip_;
};

// The crossbars of an open stroke, or of a closed one that was cut open.
std::vector<Crossbar> open_crossbars(std::span<const StrokePoint> points, StrokeEnds ends) {
    std::vector<Crossbar> bars;
    const std::vector<Joint> joints = joints_of(points);
    if (joints.empty()) return bars;
    const std::size_t count = joints.size();
    const auto direction = [&](std::size_t i) { return glm::normalize(joints[i + 1].position - joints[i].position); };
    const glm::dvec2 first = direction(0), last = direction(count - 2);
    add_joint(joints.front(), first, first, bars);
    for (std::size_t i = 1; i + 1 < count; ++i) add_joint(joints[i], direction(i - 1), direction(i), bars);
    add_joint(joints.back(), last, last, bars);
    Rail(bars, &Crossbar::left).unfold();
    Rail(bars, &Crossbar::right).unfold();
    if (ends == StrokeEnds::butt) return bars;

    const std::vector<Crossbar> begin = round_end(joints.front(), first, -1);
    const std::vector<Crossbar> end = round_end(joints.back(), last, 1);
    bars.insert(bars.begin(), begin.begin(), begin.end());
    bars.insert(bars.end(), end.begin(), end.end());
    return bars;
}

}  // namespace

std::vector<Crossbar> crossbars_of(std::span<const StrokePoint> points, bool closed, StrokeEnds ends) {
    if (!closed || points.size() < 3) return open_crossbars(points, ends);
    std::uint32_t first = 0;
    std::vector<Crossbar> bars = open_crossbars(opened(points, first), StrokeEnds::butt);
    for (Crossbar& bar : bars) bar.point = static_cast<std::uint32_t>((first + bar.point) % points.size());
    return bars;
}

}  // namespace croquis::lines
