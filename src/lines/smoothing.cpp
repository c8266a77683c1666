// Smoothing within half a pixel, after visibility is decided: zigzags of the mesh go, places stay.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "lines/cleaning.h"

namespace croquis::lines {
namespace {

constexpr double window = 4;        // pixels to each side over which places are averaged
constexpr double medium_piece = 8;  // pixels: where two such pieces meet is a corner of the model, no zigzag
constexpr double long_piece = 12;   // pixels: its ends are

/// One line as places by arc length. A closed one starts at its first point, which stays.
class Curve {
public:
    Curve(std::span<const LinePoint> points, bool closed) {
        for (const LinePoint& point : points) places_.push_back(point.position);
        if (closed) places_.push_back(places_.front());
        along_.push_back(0);
        sum_.push_back(glm::dvec2(0.0));
        for (std::size_t i = 1; i < places_.size(); ++i) {
            const double length = glm::distance(places_[i - 1], places_[i]);
            along_.push_back(along_.back() + length);
            sum_.push_back(sum_.back() + 0.5 * length * (places_[i - 1] + places_[i]));
        }
    }

    [[nodiscard]] double length() const { return along_.back(); }
    [[nodiscard]] double along(std::size_t i) const { return along_[i]; }

    /// The integral of the place from the start to a distance along the curve.
    [[nodiscard]] glm::dvec2 integral(double along) const {
        const auto after =
            std::clamp(std::upper_bound(along_.begin(), along_.end(), along), along_.begin() + 1, along_.end() - 1);
        const auto i = static_cast<std::size_t>(after - along_.begin());
        const double whole = along_[i] - along_[i - 1], part = along - along_[i - 1];
        if (!(whole > 0)) return sum_[i - 1];
        const glm::dvec2 place = glm::mix(places_[i - 1], places_[i], part / whole);
        return sum_[i - 1] + 0.5 * part * (places_[i - 1] + place);
    }

private:
    std::vector<glm::dvec2> places_;
    std::vector<double> along_;
    std::vector<glm::dvec2> sum_;
};

/// For each point, how far the line runs straight from it to the point before, and on through points at which it hardly
/// turns.
std::vector<double> straight_before(std::span<const LinePoint> points, bool closed) {
    constexpr double hardly = 0.01;  // radians
    const std::size_t count = points.size();
    std::vector<double> lengths(count, 0);
    double length = 0;
    for (std::size_t i = closed ? 0 : 1; i < (closed ? 2 * count : count); ++i) {
        const glm::dvec2 along = points[i % count].position - points[(i + count - 1) % count].position;
        const glm::dvec2 before = points[(i + count - 1) % count].position - points[(i + count - 2) % count].position;
        const bool turns =
            std::abs(along.x * before.y - along.y * before.x) > hardly * glm::length(along) * glm::length(before) ||
            glm::dot(along, before) <= 0;
        const bool is_first = !closed && i == 1;
        length = (turns || is_first ? 0 : length) + glm::length(along);
        lengths[i % count] = length;
    }
    return lengths;
}

/// Corners that must stay: ends, the ends of long straight pieces, and where pieces of some length meet.
std::vector<bool> corners_of(std::span<const LinePoint> points, bool closed) {
    const std::size_t count = points.size();
    const std::vector<double> before = straight_before(points, closed);
    const std::vector<LinePoint> turned(points.rbegin(), points.rend());
    const std::vector<double> after = straight_before(turned, closed);
    std::vector<bool> is_corner(count, false);
    for (std::size_t i = 0; i < count; ++i) {
        const auto [least, most] = std::minmax(before[i], after[count - 1 - i]);
        is_corner[i] = most >= long_piece || least >= medium_piece || (!closed && (i == 0 || i + 1 == count));
    }
    return is_corner;
}

void smooth(std::vector<LinePoint>& points, bool closed, double limit) {
    const std::vector<LinePoint> original = points;
    const std::vector<bool> is_corner = corners_of(points, closed);
    for (int pass = 0; pass < 2; ++pass) {
        const Curve curve(points, closed);
        double last_corner = 0;
        std::vector<double> room(points.size(), window);  // to the nearest corner
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (is_corner[i]) last_corner = curve.along(i);
            room[i] = std::min(room[i], curve.along(i) - last_corner);
        }
        double next_corner = curve.length();
        for (std::size_t i = points.size(); i-- > 0;) {
            if (is_corner[i]) next_corner = curve.along(i);
            room[i] = std::min(room[i], next_corner - curve.along(i));
        }
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (!(room[i] > 1e-9)) continue;
            const double s = curve.along(i);
            const glm::dvec2 mean = (curve.integral(s + room[i]) - curve.integral(s - room[i])) / (2 * room[i]);
            const glm::dvec2 shift = mean - original[i].position;
            const double size = glm::length(shift);
            points[i].position = original[i].position + (size > limit ? limit / size * shift : shift);
        }
    }
}

/// Marks the points of points[first..last] that are needed to keep within `detail` (Douglas and Peucker 1973).
void mark_needed(const std::vector<LinePoint>& points, std::size_t first, std::size_t last, double detail,
                 std::vector<bool>& needed) {
    std::vector<std::pair<std::size_t, std::size_t>> ranges{{first, last}};
    while (!ranges.empty()) {
        const auto [begin, end] = ranges.back();
        ranges.pop_back();
        const glm::dvec2 a = points[begin].position, along = points[end].position - a;
        const double squared = glm::dot(along, along);
        double farthest = detail;
        std::size_t index = begin;
        for (std::size_t i = begin + 1; i < end; ++i) {
            const glm::dvec2 offset = points[i].position - a;
            const double share = squared > 0 ? std::clamp(glm::dot(offset, along) / squared, 0.0, 1.0) : 0.0;
            const double distance = glm::length(offset - share * along);
            if (distance > farthest) {
                farthest = distance;
                index = i;
            }
        }
        if (index == begin) continue;
        needed[index] = true;
        ranges.push_back({begin, index});
        ranges.push_back({index, end});
    }
}

std::vector<LinePoint> simplified(const std::vector<LinePoint>& points, bool closed, double detail) {
    std::vector<bool> needed(points.size(), false);
    needed.front() = needed.back() = true;
    if (closed) {
        const std::size_t middle = points.size() / 2;
        needed[middle] = true;
        mark_needed(points, 0, middle, detail, needed);
        mark_needed(points, middle, points.size() - 1, detail, needed);
    } else {
        mark_needed(points, 0, points.size() - 1, detail, needed);
    }
    std::vector<LinePoint> kept;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (needed[i]) kept.push_back(points[i]);
    }
    return kept;
}

}  // namespace

Drawing smoothed(const Drawing& drawing, const CleaningLimits& limits) {
    Drawing result{drawing.width, drawing.height, {}, {}};
    result.points.reserve(drawing.points.size());
    for (Line line : drawing.lines) {
        const auto given = drawing.points_of(line);
        std::vector<LinePoint> points(given.begin(), given.end());
        if (points.size() > 2) {
            smooth(points, line.closed, limits.smoothing);
            points = simplified(points, line.closed, limits.detail);
        }
        line.first_point = static_cast<std::uint32_t>(result.points.size());
        line.point_count = static_cast<std::uint32_t>(points.size());
        result.points.insert(result.points.end(), points.begin(), points.end());
        result.lines.push_back(line);
    }
    return result;
}

}  // namespace croquis::lines
