#include "truth/segment_index.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace croquis::lines::truth {
namespace {

constexpr double cell_size = 8, margin = 0.02;  // pixels

/// Where on a segment the point nearest to `point` is, 0 to 1.
double share_at(const glm::dvec2& begin, const glm::dvec2& end, const glm::dvec2& point) {
    const glm::dvec2 along = end - begin;
    const double square = glm::dot(along, along);
    return square > 0 ? std::clamp(glm::dot(point - begin, along) / square, 0.0, 1.0) : 0.0;
}

}  // namespace

SegmentIndex::SegmentIndex(const Viewpoint& view, Depth depth)
    : view_(view),
      depth_(depth),
      columns_(static_cast<std::size_t>(view.width / cell_size) + 1),
      rows_(static_cast<std::size_t>(view.height / cell_size) + 1),
      cells_(columns_ * rows_) {}

std::size_t SegmentIndex::column_of(double x) const {
    return static_cast<std::size_t>(std::clamp(x / cell_size, 0.0, static_cast<double>(columns_ - 1)));
}

std::size_t SegmentIndex::row_of(double y) const {
    return static_cast<std::size_t>(std::clamp(y / cell_size, 0.0, static_cast<double>(rows_ - 1)));
}

void SegmentIndex::add(std::uint32_t id, const ImagePoint& begin, const ImagePoint& end) {
    const auto number = static_cast<std::uint32_t>(segments_.size());
    segments_.push_back({id, begin, end});
    const auto [left, right] = std::minmax(begin.position.x, end.position.x);
    const auto [top, bottom] = std::minmax(begin.position.y, end.position.y);
    for (std::size_t row = row_of(top - margin); row <= row_of(bottom + margin); ++row) {
        for (std::size_t column = column_of(left - margin); column <= column_of(right + margin); ++column) {
            // Cells at the rim stand for all that lies beyond.
            const bool at_rim = row == 0 || column == 0 || row + 1 == rows_ || column + 1 == columns_;
            const glm::dvec2 middle((static_cast<double>(column) + 0.5) * cell_size,
                                    (static_cast<double>(row) + 0.5) * cell_size);
            const double share = share_at(begin.position, end.position, middle);
            const glm::dvec2 nearest = begin.position + (end.position - begin.position) * share;
            if (at_rim || glm::distance(nearest, middle) < cell_size) cells_[row * columns_ + column].push_back(number);
        }
    }
}

std::vector<SegmentIndex::Found> SegmentIndex::at(const ImagePoint& point, double reach) const {
    std::vector<Found> found;
    const double distance = view_.distance_of(point.nearness);
    for (const std::uint32_t number : cells_[row_of(point.position.y) * columns_ + column_of(point.position.x)]) {
        const Segment& segment = segments_[number];
        const double share = share_at(segment.begin.position, segment.end.position, point.position);
        const glm::dvec2 nearest = segment.begin.position + (segment.end.position - segment.begin.position) * share;
        const double pixels = glm::distance(nearest, point.position);
        if (pixels > reach) continue;
        const double nearness = segment.begin.nearness + (segment.end.nearness - segment.begin.nearness) * share;
        const double apart = std::abs(view_.distance_of(nearness) - distance);
        if (depth_ == Depth::compared && apart > 1e-5 * (1 + std::abs(distance))) continue;
        found.push_back({segment.id, pixels, nearness});
    }
    std::sort(found.begin(), found.end(), [](const Found& a, const Found& b) { return a.pixels < b.pixels; });
    return found;
}

}  // namespace croquis::lines::truth
