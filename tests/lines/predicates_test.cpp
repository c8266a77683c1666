// The orientation of three points against arithmetic in whole numbers, which rounds nothing.
#include "lines/predicates.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>

#include "base/random.h"

namespace croquis::lines {
namespace {

__extension__ using WideInteger = __int128;

/// A point on a grid. Coordinates of up to 60 bits leave the products of two differences within 128.
struct GridPoint {
    std::int64_t x = 0, y = 0;

    /// In units of 2^-bits; exact as long as the coordinates fit in a double.
    [[nodiscard]] glm::dvec2 scaled(int bits) const {
        return {std::ldexp(static_cast<double>(x), -bits), std::ldexp(static_cast<double>(y), -bits)};
    }
};

int sign_of(double value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

int exact_sign(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
    const WideInteger left = static_cast<WideInteger>(b.x - a.x) * (c.y - a.y);
    const WideInteger right = static_cast<WideInteger>(b.y - a.y) * (c.x - a.x);
    return left > right ? 1 : left < right ? -1 : 0;
}

int rounded_sign(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return sign_of((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

/// How many triples were looked at, and how many of them rounding alone gets wrong: a test without any is no test.
struct Tally {
    std::size_t triples = 0;
    std::size_t zero = 0;
    std::size_t hard = 0;
    std::size_t wrong = 0;

    void look_at(const std::array<GridPoint, 3>& points, int bits) {
        const glm::dvec2 a = points[0].scaled(bits), b = points[1].scaled(bits), c = points[2].scaled(bits);
        const int truth = exact_sign(points[0], points[1], points[2]);
        ++triples;
        zero += truth == 0 ? 1 : 0;
        hard += rounded_sign(a, b, c) != truth ? 1 : 0;
        const bool right = sign_of(orientation(a, b, c)) == truth && sign_of(orientation(b, c, a)) == truth &&
                           sign_of(orientation(c, b, a)) == -truth && sign_of(orientation(b, a, c)) == -truth &&
                           sign_of(exact_orientation(a, b, c)) == truth;
        wrong += right ? 0 : 1;
    }
};

class Numbers {
public:
    explicit Numbers(const char* purpose) : random_(11, purpose) {}
    std::int64_t between(std::int64_t low, std::int64_t high) {
        return low + static_cast<std::int64_t>(random_.bits(next_++) % static_cast<std::uint64_t>(high - low + 1));
    }

private:
    Random random_;
    std::uint64_t next_ = 0;
};

// The grid of neighbouring doubles about (1/2, 1/2), all within rounding of the diagonal.
TEST(Orientation, OfNeighboursOfADiagonal) {
    constexpr std::int64_t one = std::int64_t{1} << 53;
    Tally tally;
    for (std::int64_t i = 0; i < 160; ++i) {
        for (std::int64_t k = 0; k < 160; ++k) {
            tally.look_at({{{one / 2 + i, one / 2 + k}, {12 * one, 12 * one}, {24 * one, 24 * one}}}, 53);
        }
    }
    EXPECT_EQ(tally.wrong, 0u);
    EXPECT_EQ(tally.zero, 160u);
    EXPECT_GT(tally.hard, 1000u);
}

TEST(Orientation, OfPointsNearALine) {
    Numbers numbers("near a line");
    Tally tally;
    for (int i = 0; i < 60000; ++i) {
        constexpr std::int64_t large = std::int64_t{1} << 44;
        const GridPoint a{numbers.between(-large, large), numbers.between(-large, large)};
        const GridPoint step{numbers.between(-4096, 4096), numbers.between(-4096, 4096)};
        const std::int64_t m = numbers.between(-1000000000, 1000000000), n = numbers.between(-1000000000, 1000000000);
        const GridPoint b{a.x + m * step.x, a.y + m * step.y};
        const GridPoint c{a.x + n * step.x + numbers.between(-1, 1), a.y + n * step.y + numbers.between(-1, 1)};
        tally.look_at({a, b, c}, static_cast<int>(numbers.between(-20, 60)));
    }
    EXPECT_EQ(tally.wrong, 0u);
    EXPECT_GT(tally.zero, 1000u);
}

// Coordinates of which the differences do not fit in a double: the quick test cannot decide, and must know it.
TEST(Orientation, WhereDifferencesRound) {
    Numbers numbers("differences round");
    Tally tally;
    for (int i = 0; i < 60000; ++i) {
        // Large ones in steps of 128, so that they fit in a double; small ones as they are.
        const auto large = [&] { return 128 * numbers.between(-(std::int64_t{1} << 51), std::int64_t{1} << 51); };
        const GridPoint b{large(), large()};
        // Near the middle between b and its mirror image, which all lie on one line with the origin.
        const GridPoint a{-b.x, -b.y};
        const GridPoint c{numbers.between(-3, 3), numbers.between(-3, 3)};
        tally.look_at({a, b, c}, 58);
        tally.look_at({a, c, {b.x / 2 + c.x * 64, b.y / 2 + c.y * 64}}, 40);
    }
    EXPECT_EQ(tally.wrong, 0u);
    EXPECT_GT(tally.zero, 1000u);
    EXPECT_GT(tally.hard, 1000u);
}

TEST(Orientation, OfEqualPointsIsZero) {
    const glm::dvec2 a{0.1, 1e-17}, b{1e9, 0.3};
    for (const auto& [p, q, r] : {std::array{a, a, b}, std::array{a, b, a}, std::array{b, a, a}, std::array{a, a, a}}) {
        EXPECT_EQ(orientation(p, q, r), 0.0);
        EXPECT_EQ(exact_orientation(p, q, r), 0.0);
    }
}

TEST(Orientation, IsTwiceTheArea) {
    EXPECT_DOUBLE_EQ(orientation({1, 1}, {4, 1}, {1, 3}), 6.0);
    EXPECT_DOUBLE_EQ(exact_orientation({1, 1}, {4, 1}, {1, 3}), 6.0);
    EXPECT_DOUBLE_EQ(orientation({1, 1}, {1, 3}, {4, 1}), -6.0);
}

}  // namespace
}  // namespace croquis::lines
