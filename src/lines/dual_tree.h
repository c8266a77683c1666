// Edges as segments in dual space, in a tree of boxes: which of them a view may cut.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "lines/facing.h"
#include "lines/surface.h"

namespace croquis::lines {

/// A face is the point (n, w) of its plane n · x + w = 0 in a space of four dimensions, an edge the segment between its
/// two faces. A view is a hyperplane through the origin there: (e, 1) for an eye at e, (d, 0) for the direction d of a
/// parallel projection (EyeFunction, up to a factor). The silhouettes are the segments that it cuts. So one tree serves
/// all views of both projections.
///
/// Segments are sorted along a curve that fills that space, which brings those together that are of like direction and
/// height, wherever they lie on the model. Each four make a leaf, each eight leaves or nodes a node. A node holds its
/// children's boxes in 8 bits a side, as parts of its own box and rounded outwards: 64 bytes. All together takes less
/// than 10 bytes a triangle.
class DualTree {
public:
    explicit DualTree(const Surface& surface);

    /// A node, with its box.
    struct Place {
        std::uint32_t level = 0;  ///< 0: its children are leaves
        std::uint32_t node = 0;   ///< within the level
        glm::vec4 low{0.0f};
        glm::vec4 step{0.0f};  ///< a 255th of its size
    };

    /// Replaces `nodes` by some of one level that together hold all edges that a view may cut: at least `enough`, if
    /// the tree has as many that it cuts.
    void choose(const EyeFunction& height, std::size_t enough, std::vector<Place>& nodes) const;

    /// Appends the edges below nodes of one level that the view may cut. Uses up `nodes`.
    void append_edges(const EyeFunction& height, std::vector<Place>& nodes, std::vector<std::uint32_t>& edges) const;

    /// Bytes.
    [[nodiscard]] std::size_t memory() const;

private:
    static constexpr std::size_t children = 8;
    static constexpr std::size_t edges_a_leaf = 4;

    /// The sides of the children's boxes, each side of all children together.
    struct alignas(64) Node {
        std::array<std::array<std::uint8_t, children>, 4> low;
        std::array<std::array<std::uint8_t, children>, 4> high;
    };

    struct Box {
        glm::vec4 low, high;
    };

    void sort_edges(const Surface& surface);
    [[nodiscard]] std::vector<Box> leaf_boxes(const Surface& surface) const;
    void make_nodes(std::vector<Box> leaves);
    void round_level(std::size_t level, const std::vector<Box>& below, std::vector<Place>& places);
    static std::vector<Box> joined(const std::vector<Box>& below);
    static Node rounded(std::span<const Box> boxes, const Place& place);
    static Place child_of(const Node& node, const Place& place, std::size_t child);
    [[nodiscard]] std::uint32_t cut_children(const EyeFunction& height, const Place& place) const;
    void descend(const EyeFunction& height, std::vector<Place>& nodes) const;

    /// How many leaves, or nodes, the nodes of a level have for children.
    [[nodiscard]] std::size_t size_below(std::size_t level) const {
        return level > 0 ? levels_[level - 1].size() : (edges_.size() + edges_a_leaf - 1) / edges_a_leaf;
    }

    std::vector<std::uint32_t> edges_;       // the regular ones, sorted
    std::vector<std::vector<Node>> levels_;  // the last one has one node
    Place root_;
};

}  // namespace croquis::lines
