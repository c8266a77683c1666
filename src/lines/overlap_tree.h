// Which faces of a surface are near each other: a tree of boxes, walked against itself.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lines/general_position.h"
#include "model/topology.h"

namespace croquis::lines {

/// A tree over the boxes of faces. Faces are sorted along a curve that fills space; each eight make a leaf, each two
/// leaves or nodes a node. Building takes time and memory in proportion to the faces.
class OverlapTree {
public:
    OverlapTree(std::span<const model::Face> faces, const GeneralPosition& points);

    /// Two nodes of one level whose boxes overlap; or a node twice, for the pairs within it.
    struct NodePair {
        std::uint32_t level = 0, first = 0, second = 0;
    };

    /// Node pairs that together hold every pair of faces with overlapping boxes once: some hundred, for threads to
    /// share out. The same ones however many threads there are.
    [[nodiscard]] std::vector<NodePair> shares() const;

    /// Calls `visit(face, others)` for faces below two nodes, with the faces whose boxes overlap the face's: each pair
    /// once, until `is_enough()`.
    template <typename Visit, typename Enough>
    void visit_overlaps(const NodePair& pair, const Visit& visit, const Enough& is_enough) const {
        if (is_enough()) return;
        if (pair.level == 0) return visit_leaves(pair.first, pair.second, visit);
        for_children(pair, [&](const NodePair& children) { visit_overlaps(children, visit, is_enough); });
    }

private:
    static constexpr std::uint32_t faces_a_leaf = 8;

    struct Box {
        std::array<float, 3> low, high;
        [[nodiscard]] bool overlaps(const Box& other) const {
            return low[0] <= other.high[0] && other.low[0] <= high[0] && low[1] <= other.high[1] &&
                   other.low[1] <= high[1] && low[2] <= other.high[2] && other.low[2] <= high[2];
        }
    };

    void sort_faces(std::span<const model::Face> faces, const GeneralPosition& points);
    void make_boxes(std::span<const model::Face> faces, const GeneralPosition& points);
    void make_levels();

    template <typename Each>
    void for_children(const NodePair& pair, const Each& each) const {
        const std::vector<Box>& below = levels_[pair.level - 1];
        const auto count = static_cast<std::uint32_t>(below.size());
        const std::uint32_t a = 2 * pair.first, b = 2 * pair.second;
        const auto look_at = [&](std::uint32_t i, std::uint32_t j) {
            if (j < count && below[i].overlaps(below[j])) each(NodePair{pair.level - 1, i, j});
        };
        look_at(a, b);
        look_at(a, b + 1);
        if (a + 1 >= count) return;
        if (a != b) look_at(a + 1, b);
        look_at(a + 1, b + 1);
    }

    template <typename Visit>
    void visit_leaves(std::uint32_t a, std::uint32_t b, const Visit& visit) const {
        const auto count = static_cast<std::uint32_t>(order_.size());
        const std::uint32_t a_end = std::min(count, (a + 1) * faces_a_leaf);
        const std::uint32_t b_end = std::min(count, (b + 1) * faces_a_leaf);
        std::array<std::uint32_t, faces_a_leaf> reaching{};  // faces of leaf b that reach the box of leaf a
        std::size_t reaching_count = 0;
        for (std::uint32_t j = b * faces_a_leaf; j < b_end; ++j) {
            if (boxes_[j].overlaps(levels_[0][a])) reaching[reaching_count++] = j;
        }
        std::array<std::uint32_t, faces_a_leaf> others{};
        for (std::uint32_t i = a * faces_a_leaf; i < a_end; ++i) {
            if (!boxes_[i].overlaps(levels_[0][b])) continue;
            std::size_t other_count = 0;
            for (const std::uint32_t j : std::span(reaching).first(reaching_count)) {
                if ((a != b || i < j) && boxes_[i].overlaps(boxes_[j])) others[other_count++] = order_[j];
            }
            if (other_count > 0) visit(order_[i], std::span<const std::uint32_t>(others).first(other_count));
        }
    }

    std::vector<std::uint32_t> order_;      // faces along the curve
    std::vector<Box> boxes_;                // theirs
    std::vector<std::vector<Box>> levels_;  // leaves first; the last one has one node
};

}  // namespace croquis::lines
