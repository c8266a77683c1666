// What a plotter gets: the same ink, fewer and longer paths, a short way for the lifted pen.
#include "output/plotter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/random.h"

namespace croquis::output {
namespace {

constexpr double pi = 3.14159265358979323846;

Ring line(const glm::dvec2& a, const glm::dvec2& b) { return {{a, b}, false}; }

// Wavy strokes all over an A4 sheet, in no order.
std::vector<Ring> scribble(std::size_t count, std::uint64_t seed) {
    const Random random(seed, "scribble");
    std::vector<Ring> rings;
    for (std::size_t i = 0; i < count; ++i) {
        Ring ring;
        const glm::dvec2 start(random.between(10, 200, 4 * i), random.between(10, 280, 4 * i + 1));
        const double turn = random.between(0, 2 * pi, 4 * i + 2);
        ring.closed = random.unit(4 * i + 3) < 0.2;
        const double bend = ring.closed ? 2 * pi / 12 : 0.2;
        for (int k = 0; k < 12; ++k) {
            const double angle = turn + bend * k;
            ring.points.push_back((k == 0 ? start : ring.points.back()) +
                                  0.7 * glm::dvec2(std::cos(angle), std::sin(angle)));
        }
        rings.push_back(std::move(ring));
    }
    return rings;
}

// A ring cut into pieces of a few points, shuffled, every second one turned round.
std::vector<Ring> pieces_of(const Ring& ring, std::uint64_t seed) {
    std::vector<glm::dvec2> points = ring.points;
    if (ring.closed) points.push_back(points.front());
    std::vector<Ring> pieces;
    for (std::size_t i = 0; i + 1 < points.size(); i += 3) {
        const std::size_t end = std::min(i + 4, points.size());
        pieces.push_back({{points.begin() + std::ptrdiff_t(i), points.begin() + std::ptrdiff_t(end)}, false});
        if (pieces.size() % 2 == 0) std::reverse(pieces.back().points.begin(), pieces.back().points.end());
    }
    const Random random(seed, "shuffle");
    for (std::size_t i = pieces.size(); i > 1; --i) std::swap(pieces[i - 1], pieces[random.bits(i) % i]);
    return pieces;
}

Ring wave(bool closed) {
    Ring ring;
    ring.closed = closed;
    for (int i = 0; i < 61; ++i) {
        const double angle = (closed ? 2 * pi : 5.0) * i / 61;
        ring.points.push_back(glm::dvec2(100, 100) +
                              (30 + 4 * std::sin(7 * angle)) * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return ring;
}

TEST(Plotter, WayIsUnderAQuarterAndInkTheSame) {
    for (const std::size_t count : {200u, 500u}) {
        const std::vector<Ring> rings = scribble(count, 7);
        std::vector<Ring> ordered = rings;
        order_rings(ordered);
        ASSERT_EQ(ordered.size(), rings.size());
        EXPECT_NEAR(ink_of(ordered), ink_of(rings), 1e-9 * ink_of(rings));
        EXPECT_LT(travel_of(ordered), 0.25 * travel_of(rings));
    }
}

// With few rings, all orders and turns can be tried.
TEST(Plotter, OrderIsNearTheBest) {
    double sum = 0, best_sum = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        std::vector<Ring> rings = scribble(5, seed);
        for (Ring& ring : rings) ring.closed = false;
        double best = 1e30;
        std::vector<std::size_t> order{0, 1, 2, 3, 4};
        do {
            for (unsigned turns = 0; turns < 32; ++turns) {
                std::vector<Ring> tried;
                for (const std::size_t i : order) {
                    tried.push_back(rings[i]);
                    if ((turns >> i & 1u) != 0) std::reverse(tried.back().points.begin(), tried.back().points.end());
                }
                best = std::min(best, travel_of(tried));
            }
        } while (std::next_permutation(order.begin(), order.end()));
        order_rings(rings);
        EXPECT_GE(travel_of(rings), best - 1e-9);
        sum += travel_of(rings);
        best_sum += best;
    }
    EXPECT_LT(sum, 1.1 * best_sum);
}

TEST(Plotter, PiecesBecomeOnePathAgain) {
    for (const bool closed : {false, true}) {
        const Ring whole = wave(closed);
        std::vector<Ring> pieces = pieces_of(whole, 3);
        ASSERT_GT(pieces.size(), 15u);
        join_ends(pieces, 0.02);
        ASSERT_EQ(pieces.size(), 1u);
        EXPECT_EQ(pieces[0].closed, closed);
        EXPECT_EQ(pieces[0].points.size(), whole.points.size());
        EXPECT_NEAR(ink_of(pieces), ink_of(std::vector<Ring>{whole}), 1e-9);
    }
}

TEST(Plotter, StraightOnAtACrossing) {
    std::vector<Ring> star;
    for (int i = 0; i < 6; ++i) {
        star.push_back(
            line({50, 50}, glm::dvec2(50, 50) + 10.0 * glm::dvec2(std::cos(i * pi / 3), std::sin(i * pi / 3))));
    }
    join_ends(star, 0.02);
    ASSERT_EQ(star.size(), 3u);
    for (const Ring& ring : star) EXPECT_NEAR(glm::distance(ring.points.front(), ring.points.back()), 20, 1e-9);
}

TEST(Plotter, EndsApartStayApart) {
    std::vector<Ring> two{line({0, 0}, {10, 0}), line({10.05, 0}, {20, 0})};
    join_ends(two, 0.02);
    EXPECT_EQ(two.size(), 2u);
}

// Stretches of one slanting line, against the length of their union by sorting.
TEST(Plotter, OverlapsAreDrawnOnce) {
    const Random random(5, "stretches");
    const glm::dvec2 start(20, 30), direction(0.8, 0.6);
    std::vector<Ring> rings;
    std::vector<std::pair<double, double>> stretches;
    for (std::uint64_t i = 0; i < 60; ++i) {
        const double from = random.between(0, 180, 2 * i), to = from + random.between(0.5, 9, 2 * i + 1);
        stretches.emplace_back(from, to);
        rings.push_back(i % 2 == 0 ? line(start + from * direction, start + to * direction)
                                   : line(start + to * direction, start + from * direction));
        // Lines across are none of the business.
        const glm::dvec2 foot = start + 3.0 * double(i) * direction;
        rings.push_back(line(foot, foot + 5.0 * glm::dvec2(-0.6, 0.8)));
    }
    std::sort(stretches.begin(), stretches.end());
    double covered = 0, at = -1;
    for (const auto& [from, to] : stretches) {
        covered += std::max(0.0, to - std::max(from, at));
        at = std::max(at, to);
    }
    drop_overlaps(rings, 0.02);
    EXPECT_NEAR(ink_of(rings), covered + 60 * 5, 60 * 0.02);
}

TEST(Plotter, ACloseParallelAndAFineFanAreKept) {
    std::vector<Ring> rings{line({0, 0}, {100, 0}), line({0, 0.1}, {100, 0.1}), line({0, 0}, {100, 0.5})};
    const double ink = ink_of(rings);
    drop_overlaps(rings, 0.02);
    EXPECT_NEAR(ink_of(rings), ink, 5);
}

TEST(Plotter, AClosedRingOverAnother) {
    std::vector<Ring> rings{wave(true), wave(true), wave(true)};
    std::rotate(rings[1].points.begin(), rings[1].points.begin() + 17, rings[1].points.end());
    std::reverse(rings[2].points.begin(), rings[2].points.end());
    drop_overlaps(rings, 0.02);
    EXPECT_EQ(rings.size(), 1u);
}

TEST(Plotter, IdlePointsGo) {
    Ring square{{}, true};
    for (const glm::dvec2& corner :
         {glm::dvec2(5, 0), glm::dvec2(10, 0), glm::dvec2(10, 10), glm::dvec2(0, 10), glm::dvec2(0, 0)}) {
        square.points.push_back(corner);
        square.points.push_back(corner);
    }
    std::vector<Ring> rings{square, line({1, 1}, {1, 1}), {{{0, 0}, {1, 0.001}, {2, 0}, {3, 1}}, false}};
    drop_idle_points(rings, 0.005);
    ASSERT_EQ(rings.size(), 2u);
    EXPECT_EQ(rings[0].points.size(), 4u);
    EXPECT_NEAR(ink_of(std::span(rings).first(1)), 40, 1e-9);
    EXPECT_EQ(rings[1].points.size(), 3u);
}

TEST(Plotter, TheWholePlanKeepsTheInk) {
    std::vector<Ring> rings;
    double ink = 0;
    for (int i = 0; i < 8; ++i) {
        Ring ring = wave(i % 2 == 0);
        for (glm::dvec2& point : ring.points) point += glm::dvec2(7.3 * i, 11.1 * i);
        ink += ink_of(std::span(&ring, 1));
        for (Ring& piece : pieces_of(ring, std::uint64_t(i))) rings.push_back(std::move(piece));
    }
    const std::vector<Ring> planned = plan_pen(rings);
    EXPECT_NEAR(ink_of(planned), ink, 0.001 * ink);
    EXPECT_LT(planned.size(), 40u);
    EXPECT_LT(travel_of(planned), 0.25 * travel_of(rings));
    EXPECT_TRUE(plan_pen({}).empty());
}

}  // namespace
}  // namespace croquis::output
