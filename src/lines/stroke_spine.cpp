#include "lines/stroke_spine.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace croquis::lines {
namespace {

constexpr double same_place = 1e-6;  // pixels

SpinePoint between(const SpinePoint& a, const SpinePoint& b, double t) {
    return {glm::mix(a.position, b.position, t), glm::mix(a.depth, b.depth, t), glm::mix(a.light, b.light, t)};
}

}  // namespace

void Spine::assign(std::span<const SpinePoint> points, bool closed) {
    points_.clear();
    along_.clear();
    last_segment_ = 0;
    closed_ = closed;
    const auto add = [&](const SpinePoint& point) {
        const double step = points_.empty() ? 0 : glm::distance(points_.back().position, point.position);
        if (!points_.empty() && step < same_place) return;
        along_.push_back(points_.empty() ? 0 : along_.back() + step);
        points_.push_back(point);
    };
    for (const SpinePoint& point : points) add(point);
    if (closed && points_.size() > 1) add(points_.front());
    if (closed && points_.size() < 4) closed_ = false;  // back and forth, or nothing
}

std::size_t Spine::segment_at(double along) const {
    std::size_t i = std::min(last_segment_, along_.size() - 2);
    const bool is_near = along_[i] <= along && (i + 8 >= along_.size() || along <= along_[i + 8]);
    if (!is_near) {
        const auto after = std::upper_bound(along_.begin() + 1, along_.end() - 1, along);
        i = static_cast<std::size_t>(after - along_.begin()) - 1;
    }
    while (i + 2 < along_.size() && along_[i + 1] <= along) ++i;
    return last_segment_ = i;
}

SpinePoint Spine::at(double along) const {
    if (closed_) {
        along = along - length() * std::floor(along / length());
    } else {
        along = std::clamp(along, 0.0, length());
    }
    const std::size_t i = segment_at(along);
    return between(points_[i], points_[i + 1], (along - along_[i]) / (along_[i + 1] - along_[i]));
}

glm::dvec2 Spine::tangent(double along, double reach) const {
    const double shorter = std::min(reach, length() / 4);  // a closed line must not meet itself
    const glm::dvec2 chord = at(along + shorter).position - at(along - shorter).position;
    const double size = glm::length(chord);
    if (size > same_place) return chord / size;
    const std::size_t i = segment_at(closed_ ? along - length() * std::floor(along / length()) : along);
    return glm::normalize(points_[i + 1].position - points_[i].position);
}

void Spine::extend(double at_start, double at_end, double reach) {
    if (closed_) return;
    SpinePoint first = points_.front(), last = points_.back();
    first.position -= at_start * tangent(0, reach);
    last.position += at_end * tangent(length(), reach);
    if (at_end > same_place) {
        points_.push_back(last);
        along_.push_back(along_.back() + at_end);
    }
    if (at_start > same_place) {
        points_.insert(points_.begin(), first);
        along_.insert(along_.begin(), 0);
        for (std::size_t i = 1; i < along_.size(); ++i) along_[i] += at_start;
    }
}

}  // namespace croquis::lines
