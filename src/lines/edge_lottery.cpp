#include "lines/edge_lottery.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "lines/radix_order.h"

namespace croquis::lines {
namespace {

constexpr std::size_t edges_a_piece = 16384;

/// Pi less the dihedral angle: 0 of a flat surface. From the distance of the normals, which is exact for small angles.
float bend(const Surface& surface, const FacePair& pair) {
    const glm::vec3 first(surface.planes()[pair.first]), second(surface.planes()[pair.second]);
    return 2.0f * std::asin(std::min(1.0f, 0.5f * glm::distance(first, second)));
}

}  // namespace

EdgeLottery::EdgeLottery(const Surface& surface, std::uint64_t seed) : random_(seed, "edge lottery") {
    const std::span<const FacePair> pairs = surface.pairs();
    std::vector<KeyedNumber> items;
    items.reserve(pairs.size());
    for (std::uint32_t e = 0; e < pairs.size(); ++e) {
        if (pairs[e].first != pairs[e].second) items.push_back({0, e});
    }
    // The bits of positive numbers are in the order of the numbers; inverted, in the opposite one.
    parallel_for(items.size(), edges_a_piece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            items[i].key = ~std::bit_cast<std::uint32_t>(bend(surface, pairs[items[i].number]));
        }
    });
    radix_sort(items);
    edges_.reserve(items.size());
    for (const KeyedNumber& item : items) edges_.push_back(item.number);
    if (edges_.empty()) return;

    // A class weighs as its middle edge bends; a flat one may still be met.
    double sum = 0;
    for (std::size_t c = 0; c < classes; ++c) {
        const std::size_t middle = (2 * c + 1) * edges_.size() / (2 * classes);
        sum += bend(surface, pairs[edges_[middle]]) + 1e-6;
        up_to_[c] = sum;
    }
    for (double& probability : up_to_) probability /= sum;
}

void EdgeLottery::draw(std::uint64_t first, std::size_t count, std::vector<std::uint32_t>& edges) const {
    for (std::uint64_t i = first; i < first + count; ++i) {
        const double chance = random_.unit(i);
        const auto chosen = static_cast<std::size_t>(
            std::min(std::upper_bound(up_to_.begin(), up_to_.end(), chance), up_to_.end() - 1) - up_to_.begin());
        const double before = chosen > 0 ? up_to_[chosen - 1] : 0.0;
        // What the choice of the class leaves of the random number chooses the edge.
        const double part = std::min((chance - before) / (up_to_[chosen] - before), 1.0);
        const double place = (static_cast<double>(chosen) + part) / classes * static_cast<double>(edges_.size());
        edges.push_back(edges_[std::min(static_cast<std::size_t>(place), edges_.size() - 1)]);
    }
}

}  // namespace croquis::lines
