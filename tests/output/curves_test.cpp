// Curves fitted to points against closed forms, and against what is asked of every fit: near the points, near the line
// between them, of one direction but at corners.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "base/random.h"
#include "output/curves.h"

namespace croquis::output {
namespace {

using Points = std::vector<glm::dvec2>;
constexpr double pi = std::numbers::pi;
constexpr auto straight = CurvePiece::Kind::straight;

Points points_of(std::size_t count, bool closed, const std::function<glm::dvec2(double)>& place) {
    Points points;
    const double last = closed ? double(count) : double(count - 1);
    for (std::size_t i = 0; i < count; ++i) points.push_back(place(double(i) / last));
    return points;
}

// Places along a curve, by de Casteljau's construction.
Points walk(const Curve& curve, int steps = 64) {
    Points places{curve.start};
    glm::dvec2 from = curve.start;
    for (const CurvePiece& piece : curve.pieces) {
        const bool is_straight = piece.kind == straight;
        const glm::dvec2 a = is_straight ? glm::mix(from, piece.end, 1.0 / 3) : piece.leaving;
        const glm::dvec2 b = is_straight ? glm::mix(from, piece.end, 2.0 / 3) : piece.arriving;
        for (int i = 1; i <= steps; ++i) {
            const double t = double(i) / steps;
            const glm::dvec2 ab = glm::mix(a, b, t);
            const glm::dvec2 left = glm::mix(glm::mix(from, a, t), ab, t);
            const glm::dvec2 right = glm::mix(ab, glm::mix(b, piece.end, t), t);
            places.push_back(glm::mix(left, right, t));
        }
        from = piece.end;
    }
    return places;
}

double distance_to(const Points& chain, const glm::dvec2& point) {
    double nearest = glm::distance(chain.front(), point);
    for (std::size_t i = 1; i < chain.size(); ++i) {
        const glm::dvec2 along = chain[i] - chain[i - 1];
        const double square = glm::dot(along, along);
        const double share = square > 0 ? std::clamp(glm::dot(point - chain[i - 1], along) / square, 0.0, 1.0) : 0.0;
        nearest = std::min(nearest, glm::distance(chain[i - 1] + share * along, point));
    }
    return nearest;
}

double farthest(const Points& points, const Points& chain) {
    double far = 0;
    for (const glm::dvec2& point : points) far = std::max(far, distance_to(chain, point));
    return far;
}

double degrees_between(const glm::dvec2& a, const glm::dvec2& b) {
    return 180 / pi * std::abs(std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b)));
}

// The turn of the curve wherever two pieces meet, with that of a closed curve's start last; degrees.
std::vector<double> turns_of(const Curve& curve) {
    std::vector<std::array<glm::dvec2, 2>> directions;
    glm::dvec2 from = curve.start;
    for (const CurvePiece& piece : curve.pieces) {
        const bool is_straight = piece.kind == straight;
        directions.push_back(
            {(is_straight ? piece.end : piece.leaving) - from, piece.end - (is_straight ? from : piece.arriving)});
        from = piece.end;
    }
    std::vector<double> turns;
    for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < directions.size(); ++i) {
        turns.push_back(degrees_between(directions[i][1], directions[(i + 1) % directions.size()][0]));
    }
    return turns;
}

// What every fit keeps to.
void expect_near(const Points& points, bool closed, const Curve& curve, const CurveLimits& limits, int steps = 64) {
    Points chain = points;
    if (closed) chain.push_back(points.front());
    const Points places = walk(curve, steps);
    EXPECT_EQ(curve.closed, closed);
    EXPECT_EQ(curve.start, points.front());
    EXPECT_EQ(places.back(), chain.back());
    EXPECT_LE(farthest(points, places), 1.05 * limits.tolerance);
    EXPECT_LE(farthest(places, chain), limits.tolerance + limits.bulge);
}

TEST(Curves, CircleIsACircle) {
    for (const double radius : {3.0, 40.0, 1000.0}) {
        const std::size_t count = std::size_t(16 + 8 * std::sqrt(radius));
        const glm::dvec2 middle(300, 200);
        const Points points = points_of(count, true, [&](double share) {
            return middle + radius * glm::dvec2(std::cos(2 * pi * share), std::sin(2 * pi * share));
        });
        const CurveLimits limits{.tolerance = 0.05, .bulge = 0.6};
        const Curve curve = fit_curve(points, true, limits);
        expect_near(points, true, curve, limits, 400);
        for (const glm::dvec2& place : walk(curve)) EXPECT_NEAR(glm::distance(place, middle), radius, 0.051);
        EXPECT_LE(curve.pieces.size(), 9u);
        for (const double turn : turns_of(curve)) EXPECT_LT(turn, 0.1);
    }
}

TEST(Curves, EllipseIsSmooth) {
    const auto place = [](double share) {
        return glm::dvec2(200 * std::cos(2 * pi * share), 50 * std::sin(2 * pi * share));
    };
    const Points points = points_of(120, true, place), exact = points_of(20'000, true, place);
    const CurveLimits limits;
    const Curve curve = fit_curve(points, true, limits);
    expect_near(points, true, curve, limits);
    EXPECT_LE(farthest(walk(curve), exact), 0.12);
    EXPECT_LE(curve.pieces.size(), 12u);
    for (const double turn : turns_of(curve)) EXPECT_LT(turn, 1.5);
}

TEST(Curves, WaveTakesFewPieces) {
    const Points points =
        points_of(300, false, [](double share) { return glm::dvec2(900 * share, 60 * std::sin(6 * pi * share)); });
    const CurveLimits limits;
    const Curve curve = fit_curve(points, false, limits);
    expect_near(points, false, curve, limits);
    EXPECT_LE(curve.pieces.size(), 16u);
    for (const double turn : turns_of(curve)) EXPECT_LT(turn, 1.5);
}

TEST(Curves, PolygonsKeepTheirCorners) {
    for (const std::size_t sides : {3u, 4u, 6u, 12u}) {
        const Points points = points_of(sides, true, [](double share) {
            return glm::dvec2(500, 400) + 100.0 * glm::dvec2(std::cos(2 * pi * share), std::sin(2 * pi * share));
        });
        const Curve curve = fit_curve(points, true);
        ASSERT_EQ(curve.pieces.size(), sides);
        for (std::size_t i = 0; i < sides; ++i) {
            EXPECT_EQ(curve.pieces[i].kind, straight);
            EXPECT_EQ(curve.pieces[i].end, points[(i + 1) % sides]);
        }
    }
}

TEST(Curves, StraightLineIsOnePiece) {
    for (const std::size_t count : {2u, 3u, 50u}) {
        const Points points =
            points_of(count, false, [](double share) { return glm::dvec2(3 + 80 * share, 7 - 30 * share); });
        const Curve curve = fit_curve(points, false);
        ASSERT_EQ(curve.pieces.size(), 1u);
        EXPECT_EQ(curve.pieces[0].kind, straight);
        EXPECT_EQ(curve.pieces[0].end, points.back());
    }
}

// A slot: straight sides go over into half circles without a corner.
TEST(Curves, StraightPiecesMeetArcsSmoothly) {
    Points points;
    for (int i = 0; i <= 40; ++i) points.push_back({200 + 30 * std::sin(pi * i / 40), 30 - 30 * std::cos(pi * i / 40)});
    for (int i = 0; i <= 40; ++i) points.push_back({-30 * std::sin(pi * i / 40), 30 + 30 * std::cos(pi * i / 40)});
    const CurveLimits limits;
    const Curve curve = fit_curve(points, true, limits);
    expect_near(points, true, curve, limits);
    const auto sides = std::count_if(curve.pieces.begin(), curve.pieces.end(),
                                     [](const CurvePiece& piece) { return piece.kind == straight; });
    EXPECT_EQ(sides, 2);
    EXPECT_LE(curve.pieces.size(), 10u);
    for (const double turn : turns_of(curve)) EXPECT_LT(turn, 1.5);
}

TEST(Curves, CornersBetweenArcsStay) {
    // Three arcs that meet at right angles and more.
    Points points;
    for (int arc = 0; arc < 3; ++arc) {
        for (int i = arc == 0 ? 0 : 1; i <= 30; ++i) {
            points.push_back({100 * arc + 50 - 50 * std::cos(pi * i / 30), 40 * std::sin(pi * i / 30)});
        }
    }
    const CurveLimits limits;
    const Curve curve = fit_curve(points, false, limits);
    expect_near(points, false, curve, limits);
    const std::vector<double> turns = turns_of(curve);
    EXPECT_EQ(std::count_if(turns.begin(), turns.end(), [](double turn) { return turn > 90; }), 2);
    EXPECT_EQ(std::count_if(turns.begin(), turns.end(), [](double turn) { return turn < 1.5; }),
              std::ptrdiff_t(turns.size() - 2));
    glm::dvec2 from = curve.start;
    std::size_t corners = 0;
    for (std::size_t i = 0; i < turns.size(); ++i) {
        from = curve.pieces[i].end;
        if (turns[i] > 90) {
            EXPECT_EQ(from, points[30 * ++corners]);
        }
    }
}

TEST(Curves, FinePointsKeepCorners) {
    Points points;
    for (int i = 0; i <= 200; ++i) points.push_back({0.2 * i, 0});
    for (int i = 1; i <= 200; ++i) points.push_back({40, 0.2 * i});
    const Curve curve = fit_curve(points, false);
    ASSERT_EQ(curve.pieces.size(), 2u);
    EXPECT_EQ(curve.pieces[0].kind, straight);
    EXPECT_EQ(curve.pieces[0].end, glm::dvec2(40, 0));
    EXPECT_EQ(curve.pieces[1].kind, straight);
}

// A straight piece that an arc leaves at 40 degrees: the arc is one from the corner on.
TEST(Curves, ArcBeginsAtACorner) {
    Points points{{-100, 0}};
    const auto place = [](double angle) { return 60.0 * glm::dvec2(std::sin(angle), -std::cos(angle)); };
    const double first = 40 * pi / 180;
    for (int i = 0; i <= 30; ++i) points.push_back(place(first + 0.04 * i) - place(first));
    const CurveLimits limits;
    const Curve curve = fit_curve(points, false, limits);
    expect_near(points, false, curve, limits);
    ASSERT_GE(curve.pieces.size(), 2u);
    EXPECT_EQ(curve.pieces[0].end, glm::dvec2(0, 0));
    for (std::size_t i = 1; i < curve.pieces.size(); ++i) EXPECT_EQ(curve.pieces[i].kind, CurvePiece::Kind::cubic);
    EXPECT_NEAR(turns_of(curve)[0], 40, 1);
}

// Chains with steps of all lengths and turns, as no good line has them.
TEST(Curves, RandomChainsAreKept) {
    const Random chance(7, "chains");
    std::uint64_t drawn = 0;
    for (int round = 0; round < 40; ++round) {
        const bool closed = round % 2 == 1;
        const double wild = 0.02 + 0.1 * round;
        Points points{{0, 0}};
        double direction = 0;
        for (int i = 0; i < 60; ++i) {
            direction += wild * chance.between(-0.5, 0.5, drawn++);
            const double step = std::exp(chance.between(-2, 2, drawn++));
            points.push_back(points.back() + step * glm::dvec2(std::cos(direction), std::sin(direction)));
        }
        const CurveLimits limits;
        const Curve curve = fit_curve(points, closed, limits);
        expect_near(points, closed, curve, limits);
        if (testing::Test::HasFailure()) FAIL() << "round " << round;
    }
}

TEST(Curves, PlaceAndScaleChangeNothing) {
    const auto wave = [](double scale, const glm::dvec2& corner) {
        return points_of(100, false, [&](double share) {
            return corner + scale * glm::dvec2(400 * share, 30 * std::sin(9 * share) + 10 * std::sin(31 * share));
        });
    };
    const Curve plain = fit_curve(wave(1, {}), false);
    const Curve large = fit_curve(wave(1e6, {}), false, {.tolerance = 0.1e6, .bulge = 0.2e6});
    const Curve far = fit_curve(wave(1, {1e9, -1e9}), false);
    ASSERT_EQ(plain.pieces.size(), large.pieces.size());
    ASSERT_EQ(plain.pieces.size(), far.pieces.size());
    for (std::size_t i = 0; i < plain.pieces.size(); ++i) {
        EXPECT_LT(glm::distance(plain.pieces[i].leaving, 1e-6 * large.pieces[i].leaving), 1e-6);
        EXPECT_LT(glm::distance(plain.pieces[i].leaving, far.pieces[i].leaving - glm::dvec2(1e9, -1e9)), 1e-3);
    }
}

TEST(Curves, DegenerateInput) {
    EXPECT_TRUE(fit_curve(Points{}, false).pieces.empty());
    EXPECT_TRUE(fit_curve(Points{{1, 2}}, true).pieces.empty());
    EXPECT_TRUE(fit_curve(Points{{1, 2}, {1, 2}, {1, 2}}, false).pieces.empty());
    EXPECT_TRUE(fit_curve(Points{{1, 2}, {1, 2}, {1, 2}}, true).pieces.empty());
    for (const bool closed : {false, true}) {
        // There and, closed, back again.
        const Curve two = fit_curve(Points{{0, 0}, {0, 0}, {5, 1}, {5, 1}}, closed);
        EXPECT_EQ(two.pieces.size(), closed ? 2u : 1u);
        EXPECT_EQ(two.pieces[0].end, glm::dvec2(5, 1));
        // Back along itself.
        const Points back{{0, 0}, {10, 0}, {5, 0}, {20, 0}};
        expect_near(back, closed, fit_curve(back, closed), {});
    }
    const double lowest = std::numeric_limits<double>::denorm_min();
    EXPECT_LE(fit_curve(Points{{0, 0}, {lowest, 0}, {0, lowest}}, false).pieces.size(), 2u);
}

}  // namespace
}  // namespace croquis::output
