#include "lines/dual_tree.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <utility>

#include "base/parallel.h"
#include "lines/radix_order.h"

namespace croquis::lines {
namespace {

constexpr std::size_t edges_a_piece = 16384;
constexpr std::size_t nodes_a_piece = 512;

// A box is given up only beyond this height: EyeFunction::doubt, and more than the boxes' arithmetic loses.
constexpr float slack = EyeFunction::doubt + 4e-6f;

// Makes a box a little too large, so that its 255th part is not rounded to less.
constexpr float step_of_size = 1.000001f / 255.0f;

/// The whole numbers from 0 to 2^bits - 1 for -1 to 1.
std::uint32_t quantised(float value, int bits) {
    const auto top = static_cast<float>((1 << bits) - 1);
    return static_cast<std::uint32_t>(std::clamp((0.5f + 0.5f * value) * top, 0.0f, top));
}

/// A direction on the square from -1 to 1: the octahedron's sides folded out.
glm::vec2 on_square(const glm::vec3& direction) {
    const float sum = std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z);
    if (!(sum > 0)) return glm::vec2(0.0f);
    const glm::vec2 upper = glm::vec2(direction) / sum;
    if (direction.z >= 0) return upper;
    return {std::copysign(1.0f - std::abs(upper.y), upper.x), std::copysign(1.0f - std::abs(upper.x), upper.y)};
}

/// The place of a segment's middle along a Morton curve: 11 bits for each coordinate of the direction, 7 for the
/// height. The height comes later, for it matters less: an eye stands a few units off.
std::uint32_t key_of(const glm::vec4& a, const glm::vec4& b) {
    const glm::vec4 middle = 0.5f * (a + b);
    const glm::vec2 direction = on_square(glm::vec3(middle));
    const std::uint32_t u = quantised(direction.x, 11), v = quantised(direction.y, 11), w = quantised(middle.w, 7);
    std::uint32_t key = 0;
    for (int bit = 10; bit >= 0; --bit) {
        const int height_bit = bit - 2;
        if (height_bit >= 0 && height_bit < 7) key = key << 1 | (w >> height_bit & 1);
        key = key << 2 | (u >> bit & 1) << 1 | (v >> bit & 1);
    }
    return key;
}

}  // namespace

DualTree::DualTree(const Surface& surface) {
    sort_edges(surface);
    make_nodes(leaf_boxes(surface));
}

void DualTree::sort_edges(const Surface& surface) {
    const std::span<const FacePair> pairs = surface.pairs();
    const std::span<const glm::vec4> planes = surface.planes();
    std::vector<KeyedNumber> items;
    items.reserve(pairs.size());
    for (std::uint32_t e = 0; e < pairs.size(); ++e) {
        if (pairs[e].first != pairs[e].second) items.push_back({0, e});
    }
    parallel_for(items.size(), edges_a_piece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const FacePair& pair = pairs[items[i].number];
            items[i].key = key_of(planes[pair.first], planes[pair.second]);
        }
    });
    radix_sort(items);
    edges_.resize(items.size());
    parallel_for(items.size(), edges_a_piece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) edges_[i] = items[i].number;
    });
}

std::vector<DualTree::Box> DualTree::leaf_boxes(const Surface& surface) const {
    const std::span<const FacePair> pairs = surface.pairs();
    const std::span<const glm::vec4> planes = surface.planes();
    std::vector<Box> boxes((edges_.size() + edges_a_leaf - 1) / edges_a_leaf);
    parallel_for(boxes.size(), nodes_a_piece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t leaf = begin; leaf < end; ++leaf) {
            const std::size_t first = leaf * edges_a_leaf, last = std::min(first + edges_a_leaf, edges_.size());
            Box box{planes[pairs[edges_[first]].first], planes[pairs[edges_[first]].first]};
            for (std::size_t i = first; i < last; ++i) {
                const glm::vec4 &a = planes[pairs[edges_[i]].first], &b = planes[pairs[edges_[i]].second];
                box = {glm::min(box.low, glm::min(a, b)), glm::max(box.high, glm::max(a, b))};
            }
            boxes[leaf] = box;
        }
    });
    return boxes;
}

/// The boxes upwards, exact; then the nodes downwards, each rounded within its parent's box as that was rounded.
void DualTree::make_nodes(std::vector<Box> leaves) {
    if (leaves.empty()) return;
    std::vector<std::vector<Box>> boxes;
    boxes.push_back(std::move(leaves));
    do {
        boxes.push_back(joined(boxes.back()));
    } while (boxes.back().size() > 1);
    const Box& all = boxes.back().front();
    levels_.resize(boxes.size() - 1);
    root_ = {static_cast<std::uint32_t>(levels_.size()) - 1, 0, all.low, (all.high - all.low) * step_of_size};
    std::vector<Place> places{root_};
    for (std::size_t level = levels_.size(); level-- > 0;) round_level(level, boxes[level], places);
}

/// The boxes of the next level.
std::vector<DualTree::Box> DualTree::joined(const std::vector<Box>& below) {
    std::vector<Box> level((below.size() + children - 1) / children);
    parallel_for(level.size(), nodes_a_piece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t node = begin; node < end; ++node) {
            Box box = below[node * children];
            for (std::size_t c = node * children + 1; c < std::min((node + 1) * children, below.size()); ++c) {
                box = {glm::min(box.low, below[c].low), glm::max(box.high, below[c].high)};
            }
            level[node] = box;
        }
    });
    return level;
}

/// Makes a level's nodes, given their places, which are replaced by those of their children.
void DualTree::round_level(std::size_t level, const std::vector<Box>& below, std::vector<Place>& places) {
    levels_[level].resize(places.size());
    std::vector<Place> places_below(below.size());
    parallel_for(places.size(), nodes_a_piece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t node = begin; node < end; ++node) {
            const std::size_t first = node * children, count = std::min(children, below.size() - first);
            levels_[level][node] = rounded(std::span(below).subspan(first, count), places[node]);
            for (std::size_t c = 0; c < count; ++c) {
                places_below[first + c] = child_of(levels_[level][node], places[node], c);
            }
        }
    });
    places.swap(places_below);
}

DualTree::Node DualTree::rounded(std::span<const Box> boxes, const Place& place) {
    Node node{};
    for (std::size_t c = 0; c < boxes.size(); ++c) {
        for (int side = 0; side < 4; ++side) {
            const float low = place.low[side], step = place.step[side];
            const float scale = step > 0 ? 1.0f / step : 0.0f;
            const auto value = [&](int part) { return low + static_cast<float>(part) * step; };
            int from = std::clamp(static_cast<int>((boxes[c].low[side] - low) * scale), 0, 255);
            int to = std::clamp(static_cast<int>((boxes[c].high[side] - low) * scale) + 1, 0, 255);
            while (from > 0 && value(from) > boxes[c].low[side]) --from;
            while (to < 255 && value(to) < boxes[c].high[side]) ++to;
            node.low[static_cast<std::size_t>(side)][c] = static_cast<std::uint8_t>(from);
            node.high[static_cast<std::size_t>(side)][c] = static_cast<std::uint8_t>(to);
        }
    }
    return node;
}

DualTree::Place DualTree::child_of(const Node& node, const Place& place, std::size_t child) {
    glm::vec4 from, parts;
    for (int side = 0; side < 4; ++side) {
        const int low = node.low[static_cast<std::size_t>(side)][child];
        const int high = node.high[static_cast<std::size_t>(side)][child];
        from[side] = static_cast<float>(low);
        parts[side] = static_cast<float>(high - low);
    }
    return {place.level - 1, static_cast<std::uint32_t>(place.node * children + child), place.low + from * place.step,
            place.step * parts * step_of_size};
}

/// The children whose boxes the view cuts, a bit each. Of a box, the corner that lies highest and the one that lies
/// lowest decide; both are sums of one side's height in each dimension.
std::uint32_t DualTree::cut_children(const EyeFunction& height, const Place& place) const {
    const Node& node = levels_[place.level][place.node];
    const glm::vec4 rise = place.step * height.factors();
    std::array<float, children> lowest, highest;
    lowest.fill(height(place.low));
    highest.fill(height(place.low));
    for (std::size_t side = 0; side < 4; ++side) {
        const float a_step = rise[static_cast<int>(side)];
        const auto& upper = a_step > 0 ? node.high[side] : node.low[side];
        const auto& lower = a_step > 0 ? node.low[side] : node.high[side];
        for (std::size_t c = 0; c < children; ++c) {
            highest[c] += a_step * static_cast<float>(upper[c]);
            lowest[c] += a_step * static_cast<float>(lower[c]);
        }
    }
    std::uint32_t cut = 0;
    for (std::size_t c = 0; c < children; ++c) {
        const bool beside = lowest[c] > slack || highest[c] < -slack;
        cut |= (beside ? 0u : 1u) << c;
    }
    const std::size_t count = std::min(children, size_below(place.level) - place.node * children);
    return cut & ((1u << count) - 1);
}

/// Replaces nodes by those of their children, nodes too, that the view cuts.
void DualTree::descend(const EyeFunction& height, std::vector<Place>& nodes) const {
    std::vector<Place> below;
    below.reserve(2 * nodes.size());
    for (const Place& place : nodes) {
        const Node& node = levels_[place.level][place.node];
        for (std::uint32_t cut = cut_children(height, place); cut != 0; cut &= cut - 1) {
            below.push_back(child_of(node, place, static_cast<std::size_t>(__builtin_ctz(cut))));
            __builtin_prefetch(&levels_[below.back().level][below.back().node]);
        }
    }
    nodes.swap(below);
}

void DualTree::choose(const EyeFunction& height, std::size_t enough, std::vector<Place>& nodes) const {
    nodes.clear();
    if (levels_.empty()) return;
    nodes.push_back(root_);
    while (nodes.size() < enough && !nodes.empty() && nodes.front().level > 0) descend(height, nodes);
}

void DualTree::append_edges(const EyeFunction& height, std::vector<Place>& nodes,
                            std::vector<std::uint32_t>& edges) const {
    while (!nodes.empty() && nodes.front().level > 0) descend(height, nodes);
    for (const Place& place : nodes) {
        for (std::uint32_t cut = cut_children(height, place); cut != 0; cut &= cut - 1) {
            const std::size_t leaf = place.node * children + static_cast<std::size_t>(__builtin_ctz(cut));
            const std::size_t first = leaf * edges_a_leaf, last = std::min(first + edges_a_leaf, edges_.size());
            for (std::size_t i = first; i < last; ++i) edges.push_back(edges_[i]);
        }
    }
}

std::size_t DualTree::memory() const {
    std::size_t bytes = edges_.capacity() * sizeof(std::uint32_t);
    for (const std::vector<Node>& level : levels_) bytes += level.capacity() * sizeof(Node);
    return bytes;
}

}  // namespace croquis::lines
