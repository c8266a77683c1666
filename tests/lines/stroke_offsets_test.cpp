// Offset patterns: p' = p + o_t t + o_n n, with p and its frame walked here by hand.
#include <gtest/gtest.h>

#include <algorithm>

#include "lines/stroke_pen.h"
#include "stroke_drawings.h"

namespace croquis::lines {
namespace {

StrokeStyle patterned(OffsetPattern pattern, OffsetRun run = OffsetRun::repeat) {
    StrokeStyle style;
    style.offsets = "test";
    style.pattern = std::make_shared<const OffsetPattern>(std::move(pattern));
    style.offset_run = run;
    return style;
}

// A pattern that doubles back, forms a loop and has a break.
OffsetPattern loopy() {
    return {
        "",
        20,
        {{0, 0, 0, true}, {6, 5, 3, true}, {12, -7, 4, true}, {9, 1.5, -2, true}, {14, 0, 6, false}, {20, 0, 0, true}}};
}

// The formula, with the frame that docs/strokes.md gives: the chord from 2 pixels before to 2 pixels behind.
glm::dvec2 displaced(const Polyline& points, double along, double tangent, double normal) {
    const glm::dvec2 chord = walk(points, along + 2) - walk(points, along - 2);
    const glm::dvec2 t = chord / std::hypot(chord.x, chord.y);
    return walk(points, along) + tangent * t + normal * glm::dvec2(t.y, -t.x);
}

// All vertices of the pattern's repetitions are vertices of the strokes, in order.
void expect_pattern(const Polyline& points, const OffsetPattern& pattern, const Strokes& strokes) {
    std::size_t next = 0, found = 0, expected = 0;
    for (int repeat = 0; (repeat + 1) * pattern.length <= length_of(points); ++repeat) {
        for (const OffsetPoint& point : pattern.points) {
            const glm::dvec2 place =
                displaced(points, repeat * pattern.length + point.along, point.tangent, point.normal);
            ++expected;
            std::size_t i = next;
            while (i < strokes.points.size() && glm::distance(strokes.points[i].position, place) > 1e-6) ++i;
            if (i == strokes.points.size()) continue;
            ++found;
            next = i;
        }
    }
    EXPECT_GT(expected, 30u);
    EXPECT_EQ(found, expected);
}

TEST(StrokeOffsets, AreExactOnAStraightLine) {
    const Polyline line{{100, 300}, {300, 300}};
    const Strokes strokes = make_strokes(drawing_of(line), options_of(patterned(loopy())));
    expect_pattern(line, loopy(), strokes);
    for (const StrokePoint& point : strokes.points) {  // and in numbers, once
        if (std::abs(point.position.x - (100 + 40 + 12 - 7)) < 1e-9 && point.position.y == 300 - 4) return;
    }
    ADD_FAILURE() << "the third point of the third repetition is missing";
}

TEST(StrokeOffsets, AreExactOnACurve) {
    expect_pattern(wave(), loopy(), make_strokes(drawing_of(wave()), options_of(patterned(loopy()))));
}

TEST(StrokeOffsets, FollowTheCurveBetweenTheirPoints) {
    // A pattern of constant offset (0, 10) is a parallel curve: on a circle, a circle.
    const OffsetPattern parallel{"", 100, {{0, 0, 10, true}, {100, 0, 10, true}}};
    const Strokes strokes =
        make_strokes(drawing_of(circle(80, 720), true), options_of(patterned(parallel, OffsetRun::fit)));
    ASSERT_EQ(strokes.strokes.size(), 1u);
    EXPECT_GT(strokes.points.size(), 700u);
    // fit: 502.65 pixels take 5 patterns of 100.5
    const double distance = 10 * 2 * 3.14159265358979323846 * 80 / 500;
    for (const StrokePoint& point : strokes.points) {
        // Clockwise on the page, so that the left is outside.
        EXPECT_NEAR(glm::distance(point.position, glm::dvec2(300)), 80 + distance, 0.01);
    }
}

TEST(StrokeOffsets, BreaksPartStrokes) {
    const Polyline line{{100, 300}, {300, 300}};
    const Strokes strokes = make_strokes(drawing_of(line), options_of(patterned(loopy())));
    // Each of the 10 patterns is broken once; its end joins the next one's beginning.
    EXPECT_EQ(strokes.strokes.size(), 11u);
    OffsetPattern dashes{"", 10, {{0, 0, 0, false}, {6, 0, 0, true}}};
    const Strokes dashed = make_strokes(drawing_of(line), options_of(patterned(dashes)));
    ASSERT_EQ(dashed.strokes.size(), 20u);
    for (std::size_t i = 0; i < 20; ++i) {
        const Polyline dash = positions(dashed, dashed.strokes[i]);
        ASSERT_EQ(dash.size(), 2u);
        EXPECT_NEAR(dash[0].x, 100 + 10.0 * static_cast<double>(i), 1e-9);
        EXPECT_NEAR(dash[1].x, 106 + 10.0 * static_cast<double>(i), 1e-9);
    }
}

TEST(StrokeOffsets, EndWithTheLine) {
    const OffsetPattern slope{"", 40, {{0, 0, 0, true}, {40, 0, 8, true}}};
    const Strokes strokes = make_strokes(drawing_of({{0, 100}, {50, 100}}), options_of(patterned(slope)));
    ASSERT_EQ(strokes.strokes.size(), 1u);
    const Polyline points = positions(strokes, strokes.strokes[0]);
    ASSERT_EQ(points.size(), 4u);
    EXPECT_NEAR(points[3].x, 50, 1e-9);
    EXPECT_NEAR(points[3].y, 98, 1e-9) << "a quarter of the second slope";
}

TEST(StrokeOffsets, ScaleAndRun) {
    const Polyline line{{0, 100}, {110, 100}};
    const auto count = [&](OffsetRun run, double scale) {
        StrokeStyle style = patterned({"", 20, {{0, 0, 0, false}, {10, 0, 5, true}}}, run);
        style.offset_scale = scale;
        const Strokes strokes = make_strokes(drawing_of(line), options_of(style));
        EXPECT_NEAR(strokes.points[1].position.y - 100, -strokes.points[1].position.x / 2, 1e-9) << "shapes are kept";
        return std::pair(strokes.strokes.size(), strokes.points[1].position.x);
    };
    EXPECT_EQ(count(OffsetRun::repeat, 1).first, 6u);
    EXPECT_NEAR(count(OffsetRun::repeat, 1).second, 10, 1e-9);
    EXPECT_EQ(count(OffsetRun::repeat, 2).first, 3u);
    EXPECT_NEAR(count(OffsetRun::repeat, 2).second, 20, 1e-9);
    EXPECT_EQ(count(OffsetRun::fit, 1).first, 6u);
    EXPECT_NEAR(count(OffsetRun::fit, 1).second, 110.0 / 12, 1e-9);
    EXPECT_EQ(count(OffsetRun::once, 1).first, 1u);
    EXPECT_NEAR(count(OffsetRun::once, 1).second, 55, 1e-9);
}

TEST(StrokeOffsets, DensePatternsAreBounded) {
    OffsetPattern dense{"", 1, std::vector<OffsetPoint>(most_offset_points, OffsetPoint{0.5, 0, 0, true})};
    StrokeStyle style = patterned(dense);
    style.offset_scale = 0.1;
    const Strokes strokes = make_strokes(drawing_of({{0, 0}, {900, 0}}), options_of(style));
    EXPECT_LT(strokes.points.size(), 900u * 16 + most_offset_points + 10);
}

}  // namespace
}  // namespace croquis::lines
