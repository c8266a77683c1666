// Joining lines end to end where one takes over from another: at the T-junctions along the outline of a bumpy surface a
// fold's line runs on inside for a few pixels while the next fold's begins. An illustrator draws one line.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "lines/cleaning.h"
#include "lines/segment_grid.h"

namespace croquis::lines {
namespace {

constexpr std::uint32_t none = 0xffffffffu;
constexpr double smallest_cosine = 0.6;
constexpr double look_back = 5;  // pixels of a line that tell where it is heading
/// Lines that lie apart pass into each other over this many times their distance to each side.
constexpr double passage = 1.5;

/// End 2 l is the start of line l, 2 l + 1 its end.
struct Joint {
    double cost = 0;
    std::uint32_t end = 0;    ///< an end that goes on as another line
    std::uint32_t other = 0;  ///< the end of that line which is cut off
    double spur = 0;          ///< pixels cut off there
    double apart = 0;         ///< pixels
};

class Joiner {
public:
    Joiner(const Drawing& drawing, const Viewpoint& view, const CleaningLimits& limits)
        : drawing_(drawing),
          view_(view),
          limits_(limits),
          grid_(drawing, limits.reach),
          partner_(drawing.lines.size() * 2, none),
          cut_(drawing.lines.size() * 2, 0.0) {
        for (const Line& line : drawing.lines) {
            const auto points = drawing.points_of(line);
            starts_.push_back(along_.size());
            double along = 0;
            for (std::size_t i = 0; i < points.size(); ++i) {
                if (i > 0) along += glm::distance(points[i - 1].position, points[i].position);
                along_.push_back(along);
            }
        }
        find_joints();
    }

    [[nodiscard]] Drawing joined(std::vector<Merit>& merits) const;

private:
    [[nodiscard]] double length(std::uint32_t line) const {
        return along_[starts_[line] + drawing_.lines[line].point_count - 1];
    }
    [[nodiscard]] bool may_join(std::uint32_t line) const {
        return drawing_.lines[line].visible() && !drawing_.lines[line].closed;
    }

    /// The point at a distance along a line, from its start.
    [[nodiscard]] LinePoint at(std::uint32_t line, double along) const {
        const auto points = drawing_.points_of(drawing_.lines[line]);
        const auto first = along_.begin() + static_cast<std::ptrdiff_t>(starts_[line]);
        const auto last = first + static_cast<std::ptrdiff_t>(points.size());
        const auto after = std::clamp(std::upper_bound(first, last, along), first + 1, last - 1);
        const auto i = static_cast<std::size_t>(after - first);
        const double whole = *after - *(after - 1);
        const double share = whole > 0 ? std::clamp((along - *(after - 1)) / whole, 0.0, 1.0) : 0.0;
        LinePoint point = points[i];
        point.position = glm::mix(points[i - 1].position, points[i].position, share);
        point.depth = points[i - 1].depth + share * (points[i].depth - points[i - 1].depth);
        return point;
    }

    /// A place along a line counted from one of its ends.
    [[nodiscard]] LinePoint from_end(std::uint32_t end, double distance) const {
        return at(end / 2, end % 2 == 0 ? distance : length(end / 2) - distance);
    }

    /// Where a line is heading at a distance from its end, towards that end.
    [[nodiscard]] glm::dvec2 heading(std::uint32_t end, double distance) const {
        const double back = std::min(distance + look_back, length(end / 2));
        const glm::dvec2 offset = from_end(end, distance).position - from_end(end, back).position;
        const double size = glm::length(offset);
        return size > 0 ? offset / size : glm::dvec2(0.0);
    }

    void find_joints() {
        std::vector<Joint> joints;
        for (std::uint32_t end = 0; end < partner_.size(); ++end) {
            if (may_join(end / 2)) find_joints_of(end, joints);
        }
        std::stable_sort(joints.begin(), joints.end(), [](const Joint& x, const Joint& y) { return x.cost < y.cost; });
        for (const Joint& joint : joints) {
            const bool free = partner_[joint.end] == none && partner_[joint.other] == none;
            const bool enough_left = length(joint.other / 2) - cut_[joint.other ^ 1u] > 2 * joint.spur;
            if (!free || !enough_left) continue;
            partner_[joint.end] = joint.other;
            partner_[joint.other] = joint.end;
            const auto shortened = [&](std::uint32_t one, double spur) {
                const double left = length(one / 2) - cut_[one ^ 1u] - spur;
                return spur + std::min(passage * joint.apart, 0.3 * std::max(left, 0.0));
            };
            cut_[joint.end] = shortened(joint.end, 0);
            cut_[joint.other] = shortened(joint.other, joint.spur);
        }
    }

    void find_joints_of(std::uint32_t end, std::vector<Joint>& joints) const {
        const LinePoint here = from_end(end, 0);
        const glm::dvec2 onward = heading(end, 0);
        grid_.visit_near(here.position, limits_.reach, [&](const SegmentGrid::Nearest& nearest) {
            const std::uint32_t line = nearest.line;
            if (nearest.distance > limits_.reach || line == end / 2 || !may_join(line)) return;
            if (drawing_.lines[line].line_class != drawing_.lines[end / 2].line_class) return;
            const std::size_t i = starts_[line] + nearest.segment;
            const double along = along_[i] + nearest.share * (along_[i + 1] - along_[i]);
            for (const std::uint32_t other : {2 * line, 2 * line + 1}) {
                const double spur = other % 2 == 0 ? along : length(line) - along;
                if (spur > limits_.longest_spur || spur > 0.45 * length(line)) continue;
                const double cosine = -glm::dot(onward, heading(other, spur));
                const LinePoint there = from_end(other, spur);
                const double depth =
                    std::abs(there.depth - here.depth) / view_.units_a_pixel(view_.nearness_of(here.depth));
                if (cosine < smallest_cosine || depth > limits_.joint_depth) continue;
                joints.push_back(
                    {nearest.distance + 0.3 * spur + 4.0 * (1.0 - cosine), end, other, spur, nearest.distance});
            }
        });
    }

    void append(Drawing& drawing, std::uint32_t line, bool reversed) const {
        const double first = cut_[2 * line], last = length(line) - cut_[2 * line + 1];
        const auto points = drawing_.points_of(drawing_.lines[line]);
        std::vector<LinePoint> part;
        part.push_back(at(line, first));
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double along = along_[starts_[line] + i];
            if (along > first + 1e-6 && along < last - 1e-6) part.push_back(points[i]);
        }
        part.push_back(at(line, last));
        if (reversed) std::reverse(part.begin(), part.end());
        drawing.points.insert(drawing.points.end(), part.begin(), part.end());
    }

    const Drawing& drawing_;
    const Viewpoint& view_;
    const CleaningLimits& limits_;
    SegmentGrid grid_;
    std::vector<std::size_t> starts_;  // of lines in along_
    std::vector<double> along_;        // of each point, pixels from its line's start
    std::vector<std::uint32_t> partner_;
    std::vector<double> cut_;
};

Drawing Joiner::joined(std::vector<Merit>& merits) const {
    Drawing drawing{drawing_.width, drawing_.height, {}, {}};
    drawing.points.reserve(drawing_.points.size());
    std::vector<Merit> sums;
    std::vector<bool> taken(drawing_.lines.size(), false);
    const auto follow = [&](std::uint32_t start, bool closed) {
        Line line = drawing_.lines[start / 2];
        line.first_point = static_cast<std::uint32_t>(drawing.points.size());
        line.closed = line.closed || closed;
        Merit sum;
        std::uint32_t end = start;
        while (end != none && !taken[end / 2]) {
            const Merit& merit = merits[end / 2];
            sum.length += merit.length;
            sum.length_with_step += merit.length_with_step;
            sum.sharp_length += merit.sharp_length;
            sum.company += merit.company;
            taken[end / 2] = true;
            append(drawing, end / 2, end % 2 == 1);
            end = partner_[end ^ 1u];
        }
        line.point_count = static_cast<std::uint32_t>(drawing.points.size()) - line.first_point;
        drawing.lines.push_back(line);
        sums.push_back(sum);
    };
    for (std::uint32_t l = 0; l < taken.size(); ++l) {
        if (taken[l]) continue;
        if (partner_[2 * l] == none) {
            follow(2 * l, false);
        } else if (partner_[2 * l + 1] == none) {
            follow(2 * l + 1, false);
        }
    }
    for (std::uint32_t l = 0; l < taken.size(); ++l) {
        if (!taken[l]) follow(2 * l, true);
    }
    merits = std::move(sums);
    return drawing;
}

}  // namespace

Drawing join_lines(const Drawing& drawing, const Viewpoint& view, const CleaningLimits& limits,
                   std::vector<Merit>& merits) {
    return Joiner(drawing, view, limits).joined(merits);
}

}  // namespace croquis::lines
