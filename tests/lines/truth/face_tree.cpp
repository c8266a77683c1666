#include "truth/face_tree.h"

#include <glm/common.hpp>
#include <numeric>

namespace croquis::lines::truth {

void Box::add(const glm::dvec3& point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
}

void Box::add(const Box& box) {
    low = glm::min(low, box.low);
    high = glm::max(high, box.high);
}

FaceTree::FaceTree(const Surface& surface) {
    for (const model::Face& face : surface.topology().faces) {
        const auto& [a, b, c] = face.vertices;
        corners_.push_back({surface.point(a), surface.point(b), surface.point(c)});
    }
    if (corners_.empty()) return;
    order_.resize(corners_.size());
    std::iota(order_.begin(), order_.end(), 0u);
    nodes_.reserve(corners_.size());
    nodes_.emplace_back();
    split(0, 0, static_cast<std::uint32_t>(order_.size()));
}

// Halves by the median of the corners along the longest side, so that the depth is the logarithm of the number of
// faces.
void FaceTree::split(std::uint32_t node, std::uint32_t begin, std::uint32_t end) {
    constexpr std::uint32_t most_in_leaf = 3;
    Box box;
    for (std::uint32_t i = begin; i < end; ++i) {
        for (const glm::dvec3& corner : corners_[order_[i]]) box.add(corner);
    }
    nodes_[node].box = box;
    if (end - begin <= most_in_leaf) {
        nodes_[node].first = begin;
        nodes_[node].count = end - begin;
        return;
    }
    const glm::dvec3 size = box.high - box.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t middle = begin + (end - begin) / 2;
    const auto key = [&](std::uint32_t face) {
        const auto& [a, b, c] = corners_[face];
        return a[axis] + b[axis] + c[axis];
    };
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](std::uint32_t one, std::uint32_t other) { return key(one) < key(other); });
    const auto first = static_cast<std::uint32_t>(nodes_.size());
    nodes_[node].first = first;
    nodes_.resize(nodes_.size() + 2);
    split(first, begin, middle);
    split(first + 1, middle, end);
}

// Slabs; a direction of 0 along an axis only asks whether the origin lies between.
bool FaceTree::meets(const Box& box, const glm::dvec3& origin, const glm::dvec3& direction, double low, double high,
                     double reach) {
    for (int axis = 0; axis < 3; ++axis) {
        const double to_low = box.low[axis] - reach - origin[axis];
        const double to_high = box.high[axis] + reach - origin[axis];
        if (direction[axis] == 0) {
            if (to_low > 0 || to_high < 0) return false;
            continue;
        }
        const double one = to_low / direction[axis], other = to_high / direction[axis];
        low = std::max(low, std::min(one, other));
        high = std::min(high, std::max(one, other));
        if (low > high) return false;
    }
    return true;
}

bool FaceTree::touches(const Box& one, const Box& other) {
    for (int axis = 0; axis < 3; ++axis) {
        if (one.low[axis] > other.high[axis] || other.low[axis] > one.high[axis]) return false;
    }
    return true;
}

}  // namespace croquis::lines::truth
