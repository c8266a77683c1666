// From lines to strokes: widths, tapers, dashes, light, depth, layers, classes, corners.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "stroke_drawings.h"

namespace croquis::lines {
namespace {

using Unit = Length::Unit;

TEST(Strokes, PlainOnesAreTheLines) {
    Drawing drawing = drawing_of(wave());
    add_line(drawing, circle(50, 40), LineClass::crease, 0, true);
    const Strokes strokes = make_strokes(drawing, {});
    ASSERT_EQ(strokes.strokes.size(), 2u);
    EXPECT_EQ(strokes.strokes[0].line, 1u) << "creases are painted before silhouettes";
    EXPECT_TRUE(strokes.strokes[0].closed);
    EXPECT_EQ(positions(strokes, strokes.strokes[0]), circle(50, 40));
    EXPECT_EQ(positions(strokes, strokes.strokes[1]), wave());
    EXPECT_FLOAT_EQ(strokes.points[0].width, static_cast<float>(0.25 * 96 / 25.4)) << "0.25 mm";
    EXPECT_FLOAT_EQ(strokes.points.back().width, static_cast<float>(0.35 * 96 / 25.4));
    EXPECT_NEAR(strokes.points.back().along, length_of(wave()), 1e-2);
    for (const Stroke& stroke : strokes.strokes) EXPECT_TRUE(is_even(strokes, stroke));
}

TEST(Strokes, TaperAtOpenEndsOnly) {
    StrokeStyle style;
    style.taper_start = {20, Unit::pixels};
    style.taper_end = {0.25, Unit::share};
    style.taper_to = 0.2;
    Drawing drawing = drawing_of({{0, 10}, {200, 10}});
    add_line(drawing, circle(50, 40), LineClass::contour, 0, true);
    const Strokes strokes = make_strokes(drawing, options_of(style));
    ASSERT_EQ(strokes.strokes.size(), 2u);
    ASSERT_FALSE(strokes.strokes[0].closed);
    EXPECT_GT(strokes.strokes[0].point_count, 16u);
    for (const StrokePoint& point : strokes.points_of(strokes.strokes[0])) {
        const double x = point.position.x;
        const auto rise = [](double t) { return 0.2 + 0.8 * std::sin(t * std::numbers::pi / 2); };
        const double expected = x < 20 ? rise(x / 20) : x > 150 ? rise((200 - x) / 50) : 1;
        EXPECT_NEAR(point.width, 4 * expected, 1e-5) << x;
    }
    EXPECT_FALSE(is_even(strokes, strokes.strokes[0]));
    EXPECT_TRUE(is_even(strokes, strokes.strokes[1])) << "a closed line has no end";
}

TEST(Strokes, LongTapersShareAShortLine) {
    StrokeStyle style;
    style.taper_start = style.taper_end = {100, Unit::pixels};
    const Strokes strokes = make_strokes(drawing_of({{0, 10}, {40, 10}}), options_of(style));
    float widest = 0;
    for (const StrokePoint& point : strokes.points) widest = std::max(widest, point.width);
    EXPECT_NEAR(widest, 4, 1e-5);
    EXPECT_EQ(strokes.points.front().width, 0);
    EXPECT_NEAR(strokes.points.back().width, 0, 1e-6);
}

TEST(Strokes, DashesMeasureArcLength) {
    StrokeStyle style;
    style.dash = {{12, Unit::pixels}, {3, Unit::pixels}, {1, Unit::widths}, {5, Unit::pixels}};
    const Strokes strokes = make_strokes(drawing_of(wave()), options_of(style));
    const double line = length_of(wave());
    double begin = 0;
    for (std::size_t i = 0; i < strokes.strokes.size(); ++i) {
        const double expected = std::min(i % 2 == 0 ? 12.0 : 4.0, line - begin);
        const Polyline dash = positions(strokes, strokes.strokes[i]);
        EXPECT_NEAR(length_of(dash), expected, 1e-6);
        EXPECT_NEAR(glm::distance(dash.front(), walk(wave(), begin)), 0, 1e-9);
        begin += i % 2 == 0 ? 15 : 9;
    }
    EXPECT_GT(begin, line);
    EXPECT_LE(begin - 9, line + 6);
}

TEST(Strokes, FittedDashesEndLinesWithADash) {
    StrokeStyle style;
    style.dash = {{12, Unit::pixels}, {3, Unit::pixels}};
    style.dash_fit = true;
    for (const double length : {5.0, 13.0, 22.0, 60.0, 100.3, 777.0}) {
        const Strokes strokes = make_strokes(drawing_of({{0, 10}, {length, 10}}), options_of(style));
        EXPECT_EQ(strokes.points.front().position.x, 0);
        EXPECT_NEAR(strokes.points.back().position.x, length, 1e-9);
        const double first = length_of(positions(strokes, strokes.strokes.front()));
        const double last = length_of(positions(strokes, strokes.strokes.back()));
        EXPECT_NEAR(first, last, 1e-6);
        if (length > 20) {
            EXPECT_NEAR(first, 12, 4);
        }
    }
    const Polyline ring = circle(50, 100);
    const Strokes strokes = make_strokes(drawing_of(ring, true), options_of(style));
    EXPECT_EQ(strokes.strokes.size(), 21u) << "314 pixels by 15";
    const double gap = glm::distance(strokes.points.back().position, strokes.points.front().position);
    EXPECT_NEAR(gap, 3 * 314.0 / 315, 0.02);
}

TEST(Strokes, OvershootGoesStraightOn) {
    StrokeStyle style;
    style.overshoot = {10, Unit::pixels};
    const Strokes even = make_strokes(drawing_of({{100, 100}, {130, 140}}), options_of(style));
    EXPECT_NEAR(glm::distance(even.points.front().position, {94, 92}), 0, 1e-9);
    EXPECT_NEAR(glm::distance(even.points.back().position, {136, 148}), 0, 1e-9);

    const Strokes brief = make_strokes(drawing_of({{100, 100}, {112, 100}}), options_of(style));
    EXPECT_NEAR(brief.points.back().position.x, 115, 1e-9) << "at most a quarter of the line";

    style.overshoot_variation = 0.5;
    style.passes = 16;
    const Strokes varied = make_strokes(drawing_of({{100, 100}, {200, 100}}), options_of(style));
    double least = 100, most = 0;
    for (const Stroke& stroke : varied.strokes) {
        const double length = 100 - varied.points_of(stroke).front().position.x;
        least = std::min(least, length);
        most = std::max(most, length);
    }
    EXPECT_GE(least, 5);
    EXPECT_LE(most, 10);
    EXPECT_GT(most - least, 1);
}

TEST(Strokes, WidthByLight) {
    StrokeStyle style;
    style.width_by_light = WidthRange{2, 0.5};
    Drawing drawing = drawing_of({{0, 0}, {50, 0}, {100, 0}});
    drawing.points[0].normal = {0, 1, 0};
    drawing.points[1].normal = {1, 0, 0};
    drawing.points[2].normal = {0, -1, 0};
    StrokeOptions options = options_of(style);
    options.light = {0, 7, 0};
    const Strokes strokes = make_strokes(drawing, options);
    ASSERT_EQ(strokes.points.size(), 3u);
    EXPECT_FLOAT_EQ(strokes.points[0].width, 4 * 0.5f) << "thin where it faces the light";
    EXPECT_FLOAT_EQ(strokes.points[1].width, 4 * 1.25f);
    EXPECT_FLOAT_EQ(strokes.points[2].width, 4 * 2.0f) << "thick where it is turned from the light";
}

TEST(Strokes, WidthByDepth) {
    StrokeStyle style;
    style.width_by_depth = WidthRange{3, 1};
    Drawing drawing = drawing_of({{0, 0}, {50, 0}, {100, 0}});
    for (std::size_t i = 0; i < 3; ++i) drawing.points[i].depth = 2 + static_cast<double>(i);
    StrokeOptions options = options_of(style);
    const Strokes own = make_strokes(drawing, options);
    EXPECT_FLOAT_EQ(own.points[0].width, 12);
    EXPECT_FLOAT_EQ(own.points[1].width, 8);
    EXPECT_FLOAT_EQ(own.points[2].width, 4);
    options.depth_range = DepthRange{3, 7};
    const Strokes given = make_strokes(drawing, options);
    EXPECT_FLOAT_EQ(given.points[0].width, 12) << "nearer than the nearest";
    EXPECT_FLOAT_EQ(given.points[2].width, 10);
}

TEST(Strokes, LayersAndClassesChooseStyles) {
    Drawing drawing{1000, 1000, {}, {}};
    for (const std::uint32_t layers : {0u, 3u, 1u, 7u, 2u}) {
        add_line(drawing, {{0, 10}, {100, 10}}, LineClass::crease, layers);
    }
    add_line(drawing, {{0, 10}, {100, 10}}, LineClass::contour);
    StrokeOptions options = options_of({});
    const auto mark_style = [](StrokeStyle& style, float mark) { style.color.r = mark; };
    for (std::size_t i = 0; i < 3; ++i) {
        options.styles.hidden[i] = {};
        mark_style(options.styles.hidden[i], 0.1f * static_cast<float>(i + 1));
    }
    mark_style(options.styles.visible[static_cast<std::size_t>(LineClass::crease)], 0.9f);
    options.hidden_width = 2;

    const Strokes strokes = make_strokes(drawing, options);
    const std::vector<std::uint32_t> lines{3, 1, 4, 2, 0, 5};  // 7, 3, 2, 1 layers, crease, contour
    const std::vector<float> marks{0.3f, 0.3f, 0.2f, 0.1f, 0.9f, 0.0f};
    ASSERT_EQ(strokes.strokes.size(), 6u);
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(strokes.strokes[i].line, lines[i]);
        const StrokePoint& point = strokes.points_of(strokes.strokes[i])[0];
        EXPECT_EQ(point.color.r, marks[i]);
        EXPECT_EQ(point.width, i < 4 ? 2 : 4);
    }
    options.hidden = false;
    EXPECT_EQ(make_strokes(drawing, options).strokes.size(), 2u);
}

TEST(Strokes, BreakAtCorners) {
    StrokeStyle style;
    style.corner_angle = std::numbers::pi / 4;
    const Polyline square{{0, 0}, {50, 0}, {100, 0}, {100, 100}, {0, 100}};
    const Strokes open = make_strokes(drawing_of(square), options_of(style));
    ASSERT_EQ(open.strokes.size(), 3u);
    EXPECT_EQ(positions(open, open.strokes[0]), (Polyline{{0, 0}, {50, 0}, {100, 0}}));
    const Strokes closed = make_strokes(drawing_of(square, true), options_of(style));
    ASSERT_EQ(closed.strokes.size(), 4u);
    double length = 0;
    for (const Stroke& stroke : closed.strokes) {
        EXPECT_FALSE(stroke.closed);
        length += length_of(positions(closed, stroke));
    }
    EXPECT_NEAR(length, 400, 1e-9);
    const Strokes round = make_strokes(drawing_of(circle(40, 60), true), options_of(style));
    ASSERT_EQ(round.strokes.size(), 1u);
    EXPECT_TRUE(round.strokes[0].closed);
}

TEST(Strokes, ZigzagsAndSmallCirclesHaveNoCorners) {
    StrokeStyle style;
    style.corner_angle = std::numbers::pi / 4;
    Polyline zigzag;
    for (int i = 0; i < 300; ++i) zigzag.emplace_back(20 + 0.5 * i, 100 + (i % 2) * 0.4);
    EXPECT_EQ(make_strokes(drawing_of(zigzag), options_of(style)).strokes.size(), 1u);
    EXPECT_EQ(make_strokes(drawing_of(circle(5, 40), true), options_of(style)).strokes.size(), 1u);
    for (int i = 0; i < 300; ++i) zigzag.emplace_back(169.5 + (i % 2) * 0.4, 101 + 0.5 * i);  // and round a real one
    EXPECT_EQ(make_strokes(drawing_of(zigzag), options_of(style)).strokes.size(), 2u);
}

TEST(Strokes, ShortLinesAreThinner) {
    StrokeStyle style;
    style.full_width_from = {50, Unit::pixels};
    const auto width = [&](double length) {
        return make_strokes(drawing_of({{0, 10}, {length, 10}}), options_of(style)).points[0].width;
    };
    EXPECT_FLOAT_EQ(width(60), 4);
    EXPECT_FLOAT_EQ(width(50), 4);
    EXPECT_FLOAT_EQ(width(10), 0.8f);
}

TEST(Strokes, ScaleEnlargesWidthsAndStyles) {
    StrokeStyle style;
    style.dash = {{10, Unit::pixels}, {1, Unit::millimetres}};
    StrokeOptions options = options_of(style);
    options.scale = 3;
    const Strokes strokes = make_strokes(drawing_of({{0, 0}, {500, 0}}), options);
    EXPECT_FLOAT_EQ(strokes.points[0].width, 12);
    EXPECT_NEAR(strokes.points[1].position.x, 30, 1e-9);
    EXPECT_NEAR(strokes.points[2].position.x, 30 + 3 * 96 / 25.4, 1e-9);
}

TEST(Strokes, OddLinesAreDrawnOrLeftOut) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Drawing drawing{100, 100, {}, {}};
    add_line(drawing, {});
    add_line(drawing, {{1, 1}});
    add_line(drawing, {{1, 1}, {1, 1}});
    add_line(drawing, {{1, 1}, {nan, 1}});
    add_line(drawing, {{1, 1}, {1e300, 1}});
    add_line(drawing, {{5, 5}, {5, 5}}, LineClass::crease, 0, true);
    add_line(drawing, {{1, 1}, {1, 1}, {9, 1}, {9, 1}, {1, 1}}, LineClass::crease, 0, true);
    StrokeStyle style;
    style.overshoot = {3, Unit::pixels};
    style.corner_angle = 0.5;
    style.wobbles.push_back({{1}, {1}, {10}});
    style.taper_start = {5, Unit::pixels};
    const Strokes strokes = make_strokes(drawing, options_of(style));
    EXPECT_GE(strokes.strokes.size(), 1u);
    for (const Stroke& stroke : strokes.strokes) EXPECT_EQ(stroke.line, 6u);
    for (const StrokePoint& point : strokes.points) {
        EXPECT_TRUE(std::isfinite(point.position.x) && std::isfinite(point.width));
    }
    EXPECT_TRUE(make_strokes({}, {}).strokes.empty());
}

TEST(Strokes, DoNotDependOnTheNumberOfThreads) {
    Drawing drawing{1000, 1000, {}, {}};
    for (int i = 0; i < 700; ++i) {
        Polyline line = wave(12);
        for (glm::dvec2& point : line) point += glm::dvec2(7 * (i % 90), i / 2.0);
        add_line(drawing, line, LineClass::crease, static_cast<std::uint32_t>(i % 3));
    }
    StrokeStyle style;
    style.wobbles.push_back({{2}, {2}, {30}});
    const Strokes several = make_strokes(drawing, options_of(style));
    const tbb::global_control alone(tbb::global_control::max_allowed_parallelism, 1);
    const Strokes one = make_strokes(drawing, options_of(style));
    ASSERT_EQ(several.points.size(), one.points.size());
    for (std::size_t i = 0; i < one.points.size(); ++i) ASSERT_EQ(several.points[i].position, one.points[i].position);
    for (std::size_t i = 0; i < one.strokes.size(); ++i) ASSERT_EQ(several.strokes[i].line, one.strokes[i].line);
}

}  // namespace
}  // namespace croquis::lines
