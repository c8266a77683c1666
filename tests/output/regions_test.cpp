// Regions against a function that tells them at each point, filled by adding up angles.
#include "output/vector_regions.h"

#include <gtest/gtest.h>

#include <array>

#include "base/random.h"
#include "output/winding.h"

namespace croquis::output {
namespace {

using test_support::distance_to;
using test_support::winding_number;

constexpr double width = 200, height = 150;

// Triangles over each other like leaves of paper; the last one at a point is what is seen there.
struct Leaves {
    std::vector<std::array<glm::dvec2, 3>> corners;

    Leaves(std::size_t count, std::uint64_t seed, bool on_grid) {
        const Random random(seed, "leaves");
        std::uint64_t next = 0;
        for (std::size_t i = 0; i < count; ++i) {
            std::array<glm::dvec2, 3> leaf;
            for (glm::dvec2& corner : leaf) {
                corner = {random.between(0, width, next), random.between(0, height, next + 1)};
                next += 2;
                if (on_grid) corner = {10 * std::round(corner.x / 10), 10 * std::round(corner.y / 10)};
            }
            corners.push_back(leaf);
        }
    }

    [[nodiscard]] std::uint32_t at(const glm::dvec2& point) const {
        for (std::size_t i = corners.size(); i-- > 0;) {
            const auto side = [&](const glm::dvec2& a, const glm::dvec2& b) {
                return (b.x - a.x) * (point.y - a.y) - (b.y - a.y) * (point.x - a.x);
            };
            const auto& [a, b, c] = corners[i];
            const double ab = side(a, b), bc = side(b, c), ca = side(c, a);
            if ((ab > 0 && bc > 0 && ca > 0) || (ab < 0 && bc < 0 && ca < 0)) return std::uint32_t(i);
        }
        return no_region;
    }

    [[nodiscard]] std::vector<BoundaryPiece> pieces() const {
        std::vector<BoundaryPiece> pieces;
        for (const auto& [a, b, c] : corners) pieces.insert(pieces.end(), {{a, b}, {b, c}, {c, a}});
        return pieces;
    }
};

// How many of many points away from all lines lie in another region than they should.
std::size_t count_wrong(const Leaves& leaves, const std::vector<std::vector<Ring>>& regions) {
    const Random random(99, "points");
    std::vector<Ring> borders;
    for (const auto& leaf : leaves.corners) borders.push_back({{leaf.begin(), leaf.end()}, true});
    std::size_t wrong = 0;
    for (std::uint64_t i = 0; i < 600; ++i) {
        const glm::dvec2 point(random.between(1, width - 1, 2 * i), random.between(1, height - 1, 2 * i + 1));
        if (distance_to(borders, point) < 0.05) continue;
        const std::uint32_t truth = leaves.at(point);
        for (std::uint32_t region = 0; region < regions.size(); ++region) {
            const int winding = winding_number(regions[region], point);
            if (winding != (region == truth ? 1 : 0)) ++wrong;
        }
    }
    return wrong;
}

TEST(Regions, AreWhatIsSeen) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        const bool on_grid = seed % 2 == 1;  // many level pieces, many corners at one place
        const Leaves leaves(9, seed, on_grid);
        const auto regions =
            regions_between(leaves.pieces(), width, height, 9, [&](const auto& point) { return leaves.at(point); });
        ASSERT_EQ(regions.size(), 9u);
        EXPECT_EQ(count_wrong(leaves, regions), 0u) << seed;
    }
}

// Gaps in the lines move borders near the gaps and flood nothing.
TEST(Regions, GapsDoNotFlood) {
    const Leaves leaves(6, 4, false);
    std::vector<BoundaryPiece> pieces;
    for (const BoundaryPiece& piece : leaves.pieces()) {
        pieces.push_back({piece.from + 0.004 * (piece.to - piece.from), piece.to - 0.004 * (piece.to - piece.from)});
    }
    const auto regions = regions_between(pieces, width, height, 6, [&](const auto& point) { return leaves.at(point); });
    EXPECT_LT(count_wrong(leaves, regions), 30u);  // of 3,600 answers
}

TEST(Regions, WithoutLinesOneRegionFillsTheFrame) {
    const auto regions = regions_between({}, width, height, 2, [](const auto&) { return 1u; });
    EXPECT_TRUE(regions[0].empty());
    ASSERT_EQ(regions[1].size(), 1u);
    EXPECT_EQ(regions[1][0].points.size(), 4u);
    const auto none = regions_between({}, width, height, 1, [](const auto&) { return no_region; });
    EXPECT_TRUE(none[0].empty());
}

}  // namespace
}  // namespace croquis::output
