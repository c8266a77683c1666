// Smoothing within half a pixel, after visibility is decided: zigzags of the mesh go, places stay.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "lines/cleaning.h"
#include "lines/simplify.h"

namespace croquis::lines {
namespace {

constexpr double window = 4;        // pixels to each side over which places are averaged
constexpr double medium_piece = 8;  // pixels: where two such pieces meet is a corner of the model, no zigzag
constexpr double long_piece = 12;   // pixels: its ends are

/// Means of what is given at the points of a line over stretches of it. A closed line has no end.
class Averages {
public:
    Averages(std::span<const LinePoint> points, bool closed) : closed_(closed) {
        const std::size_t count = points.size() + (closed ? 1 : 0);
        along_.reserve(count);
        for (std::size_t i = 0; i < count; ++i) {
            const glm::dvec2 here = points[i % points.size()].position;
            along_.push_back(i == 0 ? 0.0 : along_.back() + glm::distance(points[i - 1].position, here));
        }
    }

    [[nodiscard]] double length() const { return along_.back(); }
    [[nodiscard]] double along(std::size_t i) const { return along_[i]; }

    /// The means over `room[i]` to each side of each point; where there is none, the value itself.
    [[nodiscard]] std::vector<glm::dvec2> of(const std::vector<glm::dvec2>& values, const std::vector<double>& room) {
        sum_.assign(1, glm::dvec2(0.0));
        for (std::size_t i = 1; i < along_.size(); ++i) {
            const glm::dvec2 middle = 0.5 * (values[i - 1] + values[i % values.size()]);
            sum_.push_back(sum_.back() + (along_[i] - along_[i - 1]) * middle);
        }
        std::vector<glm::dvec2> means = values;
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (!(room[i] > 1e-9)) continue;
            const glm::dvec2 sum = integral(along_[i] + room[i], values) - integral(along_[i] - room[i], values);
            means[i] = sum / (2 * room[i]);
        }
        return means;
    }

private:
    /// From the first point to a distance along the line.
    [[nodiscard]] glm::dvec2 integral(double along, const std::vector<glm::dvec2>& values) const {
        if (closed_ && along < 0) return integral(along + length(), values) - sum_.back();
        if (closed_ && along > length()) return integral(along - length(), values) + sum_.back();
        const auto after =
            std::clamp(std::upper_bound(along_.begin(), along_.end(), along), along_.begin() + 1, along_.end() - 1);
        const auto i = static_cast<std::size_t>(after - along_.begin());
        const double whole = along_[i] - along_[i - 1], part = along - along_[i - 1];
        if (!(whole > 0)) return sum_[i - 1];
        const glm::dvec2 there = glm::mix(values[i - 1], values[i % values.size()], part / whole);
        return sum_[i - 1] + 0.5 * part * (values[i - 1] + there);
    }

    bool closed_;
    std::vector<double> along_;  // of the points, and of the first again where the line is closed
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

/// The distance from each point to the nearest corner, up to the window.
std::vector<double> rooms_of(std::span<const LinePoint> points, bool closed, const Averages& line) {
    const std::vector<bool> is_corner = corners_of(points, closed);
    const std::size_t count = points.size();
    std::vector<double> room(count, std::min(window, 0.25 * line.length()));
    const std::size_t steps = closed ? 2 * count : count;
    const auto along = [&](std::size_t i) { return line.along(i % count) + (i < count ? 0.0 : line.length()); };
    double corner = -2 * window;
    for (std::size_t i = 0; i < steps; ++i) {
        if (is_corner[i % count]) corner = along(i);
        room[i % count] = std::min(room[i % count], along(i) - corner);
    }
    corner = 2 * (line.length() + window);
    for (std::size_t i = steps; i-- > 0;) {
        if (is_corner[i % count]) corner = along(i);
        room[i % count] = std::min(room[i % count], corner - along(i));
    }
    return room;
}

/// Averages over the window, twice. That alone would shrink round lines; so what it took away is averaged too and put
/// back: zigzags are gone from it, roundness is not.
void smooth(std::vector<LinePoint>& points, bool closed, double limit) {
    Averages line(points, closed);
    const std::vector<double> room = rooms_of(points, closed, line);
    std::vector<glm::dvec2> places, taken;
    for (const LinePoint& point : points) places.push_back(point.position);
    const std::vector<glm::dvec2> means = line.of(line.of(places, room), room);
    for (std::size_t i = 0; i < points.size(); ++i) taken.push_back(places[i] - means[i]);
    const std::vector<glm::dvec2> put_back = line.of(line.of(taken, room), room);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec2 shift = means[i] + put_back[i] - places[i];
        const double size = glm::length(shift);
        points[i].position += size > limit ? limit / size * shift : shift;
    }
}

std::vector<LinePoint> simplified(const std::vector<LinePoint>& points, bool closed, double detail) {
    std::vector<glm::dvec2> places;
    for (const LinePoint& point : points) places.push_back(point.position);
    std::vector<bool> needed(points.size(), false);
    needed.front() = needed.back() = true;
    const std::size_t middle = closed ? points.size() / 2 : 0;
    needed[middle] = true;
    mark_bends(places, 0, middle, detail, needed);
    mark_bends(places, middle, points.size() - 1, detail, needed);
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
