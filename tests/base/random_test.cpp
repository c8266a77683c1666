// Random numbers: the same for the same seed, purpose and index, unlike for others, and evenly spread.
#include "base/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

namespace croquis {
namespace {

TEST(Random, IsAFunctionOfSeedPurposeAndIndex) {
    const Random one(7, "strokes"), same(7, "strokes");
    std::vector<std::uint64_t> forwards, backwards;
    for (std::uint64_t i = 0; i < 100; ++i) forwards.push_back(one.bits(i));
    for (std::uint64_t i = 100; i-- > 0;) backwards.insert(backwards.begin(), same.bits(i));
    EXPECT_EQ(forwards, backwards);
}

TEST(Random, StaysTheSameFromVersionToVersion) {
    // Drawings made with a seed must come out alike next year.
    const Random random(42, "tiles");
    const std::vector<std::uint64_t> now{random.bits(0), random.bits(1), random.bits(1000000)};
    const Random again(42, "tiles");
    EXPECT_EQ(now, (std::vector<std::uint64_t>{again.bits(0), again.bits(1), again.bits(1000000)}));
}

TEST(Random, DiffersWithSeedPurposeAndIndex) {
    std::set<std::uint64_t> seen;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        for (const char* purpose : {"", "a", "b", "ab", "ba", "tiles"}) {
            for (std::uint64_t i = 0; i < 20; ++i) seen.insert(Random(seed, purpose).bits(i));
        }
    }
    EXPECT_EQ(seen.size(), 20u * 6u * 20u);
}

// The sum of squared deviations from an even spread over bins, which for even numbers is near the number of bins.
double chi_squared(const Random& random, std::size_t bins, std::uint64_t count) {
    std::vector<double> hits(bins);
    for (std::uint64_t i = 0; i < count; ++i) hits[std::size_t(random.unit(i) * double(bins))] += 1;
    const double expected = double(count) / double(bins);
    double sum = 0;
    for (const double n : hits) sum += (n - expected) * (n - expected) / expected;
    return sum;
}

TEST(Random, IsEvenlySpread) {
    constexpr std::size_t bins = 256;
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        const double chi = chi_squared(Random(seed, "spread"), bins, 100000);
        // Six standard deviations about the mean of 255.
        EXPECT_NEAR(chi, 255.0, 6.0 * std::sqrt(2.0 * 255.0)) << "seed " << seed;
    }
}

TEST(Random, NeighboursAreIndependent) {
    const Random random(3, "pairs");
    constexpr int count = 100000;
    double sum = 0;
    for (std::uint64_t i = 0; i < count; ++i) sum += (random.unit(i) - 0.5) * (random.unit(i + 1) - 0.5);
    EXPECT_LT(std::abs(sum / count), 6.0 / 12.0 / std::sqrt(double(count)));
}

TEST(Random, StaysInItsRange) {
    const Random random(1, "range");
    for (std::uint64_t i = 0; i < 10000; ++i) {
        ASSERT_GE(random.unit(i), 0.0);
        ASSERT_LT(random.unit(i), 1.0);
        ASSERT_GE(random.between(-3, 5, i), -3.0);
        ASSERT_LT(random.between(-3, 5, i), 5.0);
    }
}

TEST(Random, StaysBelowTheUpperEndOfANarrowRange) {
    const Random random(1, "narrow");
    const double high = std::nextafter(1.0, 2.0);
    for (std::uint64_t i = 0; i < 100; ++i) {
        ASSERT_LT(random.between(1.0, high, i), high);
        ASSERT_EQ(random.between(1.0, 1.0, i), 1.0);
    }
}

TEST(Random, AcceptsEndsTheOtherWayRound) {
    const Random random(1, "reversed");
    for (std::uint64_t i = 0; i < 100; ++i) {
        ASSERT_LE(random.between(5, -3, i), 5.0);
        ASSERT_GT(random.between(5, -3, i), -3.0);
    }
}

}  // namespace
}  // namespace croquis
