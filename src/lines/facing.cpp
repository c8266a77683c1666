#include "lines/facing.h"

#include <algorithm>
#include <array>

namespace croquis::lines {

// The edges lie all over memory: one short loop a step keeps many loads under way.
void Facing::append_silhouettes(std::span<const std::uint32_t> edges, std::vector<std::uint32_t>& found) const {
    constexpr std::size_t most = 512;
    std::array<FacePair, most> pairs;
    std::array<float, most> first, second;
    for (; !edges.empty(); edges = edges.subspan(std::min(most, edges.size()))) {
        const std::size_t count = std::min(most, edges.size());
        for (std::size_t i = 0; i < count; ++i) pairs[i] = surface_.pairs()[edges[i]];
        for (std::size_t i = 0; i < count; ++i) {
            first[i] = height_(planes_[pairs[i].first]);
            second[i] = height_(planes_[pairs[i].second]);
        }
        std::size_t next = found.size();
        found.resize(next + count);
        for (std::size_t i = 0; i < count; ++i) {
            found[next] = edges[i];
            next += differ(pairs[i], first[i], second[i]) ? 1 : 0;
        }
        found.resize(next);
    }
}

}  // namespace croquis::lines
