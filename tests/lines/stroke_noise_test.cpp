// Noise: a function of the place and the seed, smooth, and never longer than 1.
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "lines/stroke_noise.h"
#include "stroke_drawings.h"

namespace croquis::lines {
namespace {

TEST(StrokeNoise, IsBoundedAndFillsItsBounds) {
    const PerlinNoise noise(7, "test");
    const Random random(1, "places");
    double longest = 0;
    glm::dvec2 sum(0);
    constexpr int count = 20000;
    for (std::uint64_t i = 0; i < count; ++i) {
        const glm::dvec2 value = noise.at({random.between(-1e4, 1e4, 2 * i), random.between(-1e4, 1e4, 2 * i + 1)});
        longest = std::max(longest, glm::length(value));
        sum += value;
    }
    EXPECT_LE(longest, 1 + 1e-12);
    EXPECT_GT(longest, 0.95);
    EXPECT_LT(glm::length(sum) / count, 0.01) << "no direction is preferred";
}

TEST(StrokeNoise, IsSmoothAndZeroAtLatticePoints) {
    const PerlinNoise noise(7, "test");
    constexpr double step = 1e-4;
    for (int i = 0; i < 4000; ++i) {
        const glm::dvec2 place(-3.3 + 0.0017 * i, 2.1 - 0.0011 * i);
        EXPECT_LT(glm::distance(noise.at(place), noise.at(place + glm::dvec2(step, -step))), 8 * step);
    }
    EXPECT_EQ(noise.at({4, -9}), glm::dvec2(0));
}

TEST(StrokeNoise, DependsOnSeedAndPurpose) {
    const glm::dvec2 place(3.3, 8.6);
    const glm::dvec2 value = PerlinNoise(1, "a").at(place);
    EXPECT_EQ(value, PerlinNoise(1, "a").at(place));
    EXPECT_NE(value, PerlinNoise(2, "a").at(place));
    EXPECT_NE(value, PerlinNoise(1, "b").at(place));
}

StrokeStyle wobbly(double across, double along, double every) {
    StrokeStyle style;
    style.wobbles.push_back({{across}, {along}, {every}});
    return style;
}

// A straight line's displacement, along it and across it.
TEST(StrokeNoise, DisplacesAtMostByTheAmplitude) {
    const Drawing drawing = drawing_of({{10, 50.5}, {900, 50.5}});
    double farthest_across = 0, farthest_along = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        StrokeOptions options = options_of(wobbly(3, 2, 25));
        options.seed = seed;
        const Strokes strokes = make_strokes(drawing, options);
        ASSERT_EQ(strokes.strokes.size(), 1u);
        const auto count = static_cast<double>(strokes.points.size() - 1);
        ASSERT_GE(count, 890 * 6 / 25.0);
        for (std::size_t i = 0; i < strokes.points.size(); ++i) {
            const glm::dvec2 still(10 + 890 * static_cast<double>(i) / count, 50.5);
            const glm::dvec2 moved = strokes.points[i].position - still;
            farthest_along = std::max(farthest_along, std::abs(moved.x));
            farthest_across = std::max(farthest_across, std::abs(moved.y));
        }
    }
    EXPECT_LE(farthest_across, 3);
    EXPECT_GT(farthest_across, 2);
    EXPECT_LE(farthest_along, 2);
    EXPECT_GT(farthest_along, 1.3);
}

TEST(StrokeNoise, NeighboursMoveAlikeWhicheverWayTheyRun) {
    Drawing drawing{1000, 1000, {}, {}};
    add_line(drawing, {{10, 80}, {700, 80}});
    add_line(drawing, {{700, 80}, {10, 80}});
    add_line(drawing, {{10, 81}, {700, 81}});
    const Strokes strokes = make_strokes(drawing, options_of(wobbly(3, 3, 40)));
    ASSERT_EQ(strokes.strokes.size(), 3u);
    const Polyline there = positions(strokes, strokes.strokes[0]), beside = positions(strokes, strokes.strokes[2]);
    Polyline back = positions(strokes, strokes.strokes[1]);
    std::reverse(back.begin(), back.end());
    ASSERT_EQ(there.size(), back.size());
    for (std::size_t i = 0; i < there.size(); ++i) {
        EXPECT_NEAR(glm::distance(there[i], back[i]), 0, 1e-9);
        EXPECT_LT(glm::distance(there[i] + glm::dvec2(0, 1), beside[i]), 0.4);
    }
}

TEST(StrokeNoise, PassesDiffer) {
    StrokeStyle style = wobbly(2, 2, 30);
    style.passes = 3;
    const Strokes strokes = make_strokes(drawing_of(wave()), options_of(style));
    ASSERT_EQ(strokes.strokes.size(), 3u);
    EXPECT_NE(positions(strokes, strokes.strokes[0]), positions(strokes, strokes.strokes[1]));
    EXPECT_NE(positions(strokes, strokes.strokes[1]), positions(strokes, strokes.strokes[2]));
}

TEST(StrokeNoise, VariesWidthOpacityAndColorWithinTheirAmounts) {
    StrokeStyle style;
    style.color = glm::vec3(0.5f);
    style.opacity = 0.8f;
    style.vary_width = {0.5, {20}};
    style.vary_opacity = {0.25, {20}};
    style.vary_color = {0.4, {20}};
    const Strokes strokes = make_strokes(drawing_of(wave(200)), options_of(style));
    float thinnest = 100, widest = 0, palest = 1, least = 1, most = 0;
    for (const StrokePoint& point : strokes.points) {
        thinnest = std::min(thinnest, point.width);
        widest = std::max(widest, point.width);
        palest = std::min(palest, point.color.a);
        least = std::min(least, point.color.r);
        most = std::max(most, point.color.r);
    }
    EXPECT_GE(thinnest, 2);
    EXPECT_LT(thinnest, 2.8f);
    EXPECT_LE(widest, 6);
    EXPECT_GT(widest, 5.2f);
    EXPECT_GE(palest, 0.6f);
    EXPECT_LT(palest, 0.7f);
    EXPECT_GE(least, 0.3f - 1e-6f);
    EXPECT_LE(most, 0.7f + 1e-6f);
}

}  // namespace
}  // namespace croquis::lines
