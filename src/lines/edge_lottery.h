// Drawing edges by chance, sharp ones more often (seed D).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/random.h"
#include "lines/surface.h"

namespace croquis::lines {

/// The regular edges of a surface in the order of their dihedral angle, the sharpest first. Over all directions of view
/// an edge is a silhouette with a probability in proportion to pi less its dihedral angle: so it is drawn.
class EdgeLottery {
public:
    EdgeLottery(const Surface& surface, std::uint64_t seed);

    /// How many edges there are to draw from.
    [[nodiscard]] std::size_t size() const { return edges_.size(); }

    /// Appends `count` edges, some perhaps twice: the draws with the numbers from `first`.
    void draw(std::uint64_t first, std::size_t count, std::vector<std::uint32_t>& edges) const;

private:
    // Edges of about one angle stand together in a class, all classes of one size: to draw is to choose a class by its
    // angle, then any of its edges.
    static constexpr std::size_t classes = 64;

    Random random_;
    std::vector<std::uint32_t> edges_;
    std::array<double, classes> up_to_{};  // the probability of this class and all before it
};

}  // namespace croquis::lines
