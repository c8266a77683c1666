#include "lines/overlap_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "lines/radix_order.h"

namespace croquis::lines {
namespace {

constexpr std::size_t items_a_piece = 8192;

// Ten bits spread to every third place.
std::uint32_t spread(std::uint32_t bits) {
    bits = (bits | bits << 16) & 0x030000ff;
    bits = (bits | bits << 8) & 0x0300f00f;
    bits = (bits | bits << 4) & 0x030c30c3;
    return (bits | bits << 2) & 0x09249249;
}

std::uint32_t morton_key(const std::array<std::uint32_t, 3>& cell, int shift) {
    const auto digits = [&](std::size_t axis) { return spread(cell[axis] >> shift & 0x3ff); };
    return digits(0) | digits(1) << 1 | digits(2) << 2;
}

// The neighbouring floats: a box may not lose what rounding cuts off.
float rounded_down(double x) { return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::lowest()); }
float rounded_up(double x) { return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::max()); }

}  // namespace

OverlapTree::OverlapTree(std::span<const model::Face> faces, const GeneralPosition& points) {
    sort_faces(faces, points);
    make_boxes(faces, points);
    make_levels();
}

// Along the Morton curve of ten bits an axis; of twenty, if too many faces share a cell then: the lower half of the
// bits first and, keeping that order, the upper.
void OverlapTree::sort_faces(std::span<const model::Face> faces, const GeneralPosition& points) {
    constexpr double cells = 0x1p20;
    const double scale = 0.5 * cells / (3 * points.extent());
    const auto cell_of = [&](std::uint32_t face) {
        const auto& [a, b, c] = faces[face].vertices;
        const glm::dvec3 middle = scale * (points[a] + points[b] + points[c]) + 0.5 * cells;
        std::array<std::uint32_t, 3> cell{};
        for (int axis = 0; axis < 3; ++axis) {
            cell[std::size_t(axis)] = static_cast<std::uint32_t>(std::clamp(middle[axis], 0.0, cells - 1));
        }
        return cell;
    };
    std::vector<KeyedNumber> sorted(faces.size());
    parallel_for(sorted.size(), items_a_piece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) sorted[i].number = static_cast<std::uint32_t>(i);
    });
    const auto sort_by_bits = [&](int shift) {
        parallel_for(sorted.size(), items_a_piece, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) sorted[i].key = morton_key(cell_of(sorted[i].number), shift);
        });
        radix_sort(sorted);
    };
    sort_by_bits(10);
    std::size_t crowded = 0;
    for (std::size_t i = 2 * faces_a_leaf; i < sorted.size(); ++i) {
        if (sorted[i].key == sorted[i - 2 * faces_a_leaf].key) ++crowded;
    }
    if (crowded > sorted.size() / 16) {
        sort_by_bits(0);
        sort_by_bits(10);
    }
    order_.resize(sorted.size());
    for (std::size_t i = 0; i < sorted.size(); ++i) order_[i] = sorted[i].number;
}

void OverlapTree::make_boxes(std::span<const model::Face> faces, const GeneralPosition& points) {
    boxes_.resize(order_.size());
    parallel_for(boxes_.size(), items_a_piece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto& [a, b, c] = faces[order_[i]].vertices;
            for (int axis = 0; axis < 3; ++axis) {
                const auto [low, high] = std::minmax({points[a][axis], points[b][axis], points[c][axis]});
                boxes_[i].low[std::size_t(axis)] = rounded_down(low);
                boxes_[i].high[std::size_t(axis)] = rounded_up(high);
            }
        }
    });
}

void OverlapTree::make_levels() {
    const auto unite = [](const std::vector<Box>& parts, std::size_t part_count) {
        std::vector<Box> wholes((parts.size() + part_count - 1) / part_count);
        parallel_for(wholes.size(), items_a_piece, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                wholes[i] = parts[i * part_count];
                for (std::size_t p = i * part_count; p < std::min(parts.size(), (i + 1) * part_count); ++p) {
                    for (std::size_t axis = 0; axis < 3; ++axis) {
                        wholes[i].low[axis] = std::min(wholes[i].low[axis], parts[p].low[axis]);
                        wholes[i].high[axis] = std::max(wholes[i].high[axis], parts[p].high[axis]);
                    }
                }
            }
        });
        return wholes;
    };
    if (boxes_.empty()) return;
    levels_.push_back(unite(boxes_, faces_a_leaf));
    while (levels_.back().size() > 1) levels_.push_back(unite(levels_.back(), 2));
}

std::vector<OverlapTree::NodePair> OverlapTree::shares() const {
    constexpr std::size_t enough = 512;
    std::vector<NodePair> pairs, finer;
    if (levels_.empty()) return pairs;
    pairs.push_back({static_cast<std::uint32_t>(levels_.size() - 1), 0, 0});
    while (!pairs.empty() && pairs.size() < enough && pairs.front().level > 0) {
        finer.clear();
        for (const NodePair& pair : pairs) {
            for_children(pair, [&](const NodePair& children) { finer.push_back(children); });
        }
        pairs.swap(finer);
    }
    return pairs;
}

}  // namespace croquis::lines
