// The splitter of fine crosshatching: no piece spans two levels, cuts lie on the shadow line, areas add up (row H2).
#include "model/shade_split.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "base/random.h"

namespace croquis::model {
namespace {

const std::vector<double> thresholds{0.15, 0.3, 0.45, 0.6, 0.75, 0.9};

double area(const ShadeTriangle& t) {
    return 0.5 * glm::length(glm::cross(t[1].position - t[0].position, t[2].position - t[0].position));
}

std::vector<ShadeTriangle> random_triangles(int count) {
    const Random random(1, "triangles");
    std::vector<ShadeTriangle> triangles;
    for (std::uint64_t i = 0; i < std::uint64_t(count); ++i) {
        ShadeTriangle t;
        for (std::uint64_t c = 0; c < 3; ++c) {
            const auto number = [&](std::uint64_t k) { return random.unit(16 * i + 4 * c + k); };
            t[c] = {{number(0), number(1), number(2)}, 2 * number(3) - 1};
        }
        triangles.push_back(t);
    }
    // Corners on thresholds, two of one level, all alike.
    triangles.push_back({ShadeCorner{{0, 0, 0}, 0.3}, ShadeCorner{{1, 0, 0}, 0.1}, ShadeCorner{{0, 1, 0}, 0.5}});
    triangles.push_back({ShadeCorner{{0, 0, 0}, 0.15}, ShadeCorner{{1, 0, 0}, 0.45}, ShadeCorner{{0, 1, 0}, 0.9}});
    triangles.push_back({ShadeCorner{{0, 0, 0}, 0.3}, ShadeCorner{{1, 0, 0}, 0.3}, ShadeCorner{{0, 1, 0}, -1}});
    triangles.push_back({ShadeCorner{{0, 0, 0}, 0.3}, ShadeCorner{{1, 0, 0}, 0.3}, ShadeCorner{{0, 1, 0}, 0.3}});
    return triangles;
}

TEST(ShadeSplit, NoPieceSpansTwoLevels) {
    for (const ShadeTriangle& triangle : random_triangles(300)) {
        for (const ShadePiece& piece : split_by_shade(triangle, thresholds, 0)) {
            const double low = piece.level == 0 ? -2 : thresholds[std::size_t(piece.level) - 1];
            const double high =
                std::size_t(piece.level) == thresholds.size() ? 2 : thresholds[std::size_t(piece.level)];
            for (const ShadeCorner& corner : piece.corners) {
                EXPECT_GE(corner.cosine, low);
                EXPECT_LE(corner.cosine, high);
            }
        }
    }
}

TEST(ShadeSplit, AreasAddUpAndPiecesLieInThePlane) {
    for (const ShadeTriangle& triangle : random_triangles(300)) {
        double sum = 0;
        for (const ShadePiece& piece : split_by_shade(triangle, thresholds, 0)) {
            sum += area(piece.corners);
            const glm::dvec3 normal =
                glm::cross(triangle[1].position - triangle[0].position, triangle[2].position - triangle[0].position);
            for (const ShadeCorner& corner : piece.corners) {
                EXPECT_NEAR(glm::dot(corner.position - triangle[0].position, normal), 0, 1e-12);
            }
        }
        EXPECT_NEAR(sum, area(triangle), 1e-12);
    }
}

// A square of two triangles on the plane z = 0 whose normals are those of a sphere of radius 2 below it, left as long
// as the plane makes them: then the cosine to a light along x is x / 2 everywhere, and shadow lines are straight.
TEST(ShadeSplit, CutsLieOnTheAnalyticShadowLine) {
    std::vector<glm::vec3> positions{{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}}, normals;
    for (const glm::vec3& p : positions) normals.emplace_back(p.x / 2, p.y / 2, 1.0f);
    const std::vector<std::uint32_t> triangles{0, 1, 2, 0, 2, 3};
    int cuts = 0;
    std::vector<double> widths(thresholds.size() + 1);
    for (const ShadePiece& piece : split_by_shade({positions, normals, triangles, {1, 0, 0, 0}}, thresholds, 0)) {
        widths[std::size_t(piece.level)] += area(piece.corners) / 4;
        for (const ShadeCorner& corner : piece.corners) {
            EXPECT_NEAR(corner.position.x / 2, corner.cosine, 1e-12);
            for (const double threshold : thresholds) cuts += std::abs(corner.position.x - 2 * threshold) < 1e-12;
        }
    }
    EXPECT_GT(cuts, 24);
    const std::vector<double> expected{2.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.2};
    for (std::size_t level = 0; level < expected.size(); ++level) EXPECT_NEAR(widths[level], expected[level], 1e-12);
}

// Equation 4.5 against the light of a point: the vertices' own directions count, as in algorithm 6.
TEST(ShadeSplit, APointLightIsSeenFromEachVertex) {
    const std::vector<glm::vec3> positions{{0, 0, 0}, {4, 0, 0}, {0, 3, 0}}, normals(3, {0, 0, 1});
    const std::vector<std::uint32_t> triangles{0, 1, 2};
    const auto pieces = split_by_shade({positions, normals, triangles, {0, 0, 1, 1}}, std::vector<double>{}, 0);
    ASSERT_EQ(pieces.size(), 1u);
    EXPECT_DOUBLE_EQ(pieces[0].corners[0].cosine, 1);
    EXPECT_DOUBLE_EQ(pieces[0].corners[1].cosine, 1 / std::sqrt(17.0));
    EXPECT_DOUBLE_EQ(pieces[0].corners[2].cosine, 1 / std::sqrt(10.0));
}

TEST(ShadeSplit, SmallTrianglesAreShadedWhole) {
    const ShadeTriangle triangle{ShadeCorner{{0, 0, 0}, 0.0}, ShadeCorner{{1, 0, 0}, 0.2}, ShadeCorner{{0, 1, 0}, 1.0}};
    const auto whole = split_by_shade(triangle, thresholds, 1.5);
    ASSERT_EQ(whole.size(), 1u);
    EXPECT_EQ(whole[0].level, 2) << "of the mean, 0.4";
    EXPECT_GT(split_by_shade(triangle, thresholds, 1.4).size(), 1u);
}

}  // namespace
}  // namespace croquis::model
