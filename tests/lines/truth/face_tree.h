// A model's faces in double precision in a tree of boxes: only makes the brute force of the line tests bearable. Which
// faces a ray meets is decided by its users, one face at a time.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "lines/surface.h"

namespace croquis::lines::truth {

struct Box {
    glm::dvec3 low{1e300};
    glm::dvec3 high{-1e300};

    void add(const glm::dvec3& point);
    void add(const Box& box);
};

class FaceTree {
public:
    explicit FaceTree(const Surface& surface);

    [[nodiscard]] const std::array<glm::dvec3, 3>& corners(std::uint32_t face) const { return corners_[face]; }
    [[nodiscard]] std::size_t face_count() const { return corners_.size(); }

    /// Calls `visit(face)` for each face that may come within `reach` of origin + t · direction, low ≤ t ≤ high, and
    /// for others.
    template <typename Visit>
    void for_each_near_ray(const glm::dvec3& origin, const glm::dvec3& direction, double low, double high, double reach,
                           const Visit& visit) const {
        descend([&](const Box& box) { return meets(box, origin, direction, low, high, reach); }, visit);
    }

    /// Calls `visit(face)` for each face whose box touches a box.
    template <typename Visit>
    void for_each_in(const Box& other, const Visit& visit) const {
        descend([&](const Box& box) { return touches(box, other); }, visit);
    }

private:
    // Children of an inner node are `first` and `first + 1`; a leaf holds `count` faces from `first` in the order.
    struct Node {
        Box box;
        std::uint32_t first = 0;
        std::uint32_t count = 0;
    };

    template <typename Wanted, typename Visit>
    void descend(const Wanted& wanted, const Visit& visit) const {
        std::array<std::uint32_t, 64> open{};
        std::size_t open_count = corners_.empty() ? 0 : 1;
        while (open_count > 0) {
            const Node& node = nodes_[open[--open_count]];
            if (!wanted(node.box)) continue;
            if (node.count > 0) {
                for (std::uint32_t i = 0; i < node.count; ++i) visit(order_[node.first + i]);
            } else {
                open[open_count++] = node.first;
                open[open_count++] = node.first + 1;
            }
        }
    }

    static bool meets(const Box& box, const glm::dvec3& origin, const glm::dvec3& direction, double low, double high,
                      double reach);
    static bool touches(const Box& one, const Box& other);
    void split(std::uint32_t node, std::uint32_t begin, std::uint32_t end);

    std::vector<std::array<glm::dvec3, 3>> corners_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace croquis::lines::truth
