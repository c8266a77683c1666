// Ribbons and outlines against the area that they stand for: all points within half a width of the spine.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "base/random.h"
#include "lines/stroke_mesh.h"
#include "stroke_drawings.h"

namespace croquis::lines {
namespace {

Strokes stroke_of(const Polyline& points, double width, StrokeEnds ends = StrokeEnds::butt, bool closed = false) {
    StrokeStyle style;
    style.width = {width, Length::Unit::pixels};
    style.ends = ends;
    return make_strokes(drawing_of(points, closed), options_of(style));
}

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

glm::dvec2 corner(const StrokeMesh& mesh, std::size_t index) { return mesh.vertices[mesh.indices[index]].position; }

double sum_of_triangles(const StrokeMesh& mesh) {
    double sum = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        sum += std::abs(cross(corner(mesh, i + 1) - corner(mesh, i), corner(mesh, i + 2) - corner(mesh, i))) / 2;
    }
    return sum;
}

// A raster over the picture's first `size` pixels, each cut in `fine` by `fine` samples.
struct Raster {
    static constexpr int size = 400, fine = 2;
    std::vector<int> counts = std::vector<int>(size * fine * size * fine, 0);

    [[nodiscard]] static glm::dvec2 place(int column, int row) {
        // Off the middle, so that no border runs through a row of samples.
        return (glm::dvec2(column, row) + glm::dvec2(0.5313, 0.4871)) / double{fine};
    }
    // Calls visit(count, place) for the samples of a box.
    template <typename Visit>
    void each_in(const glm::dvec2& low, const glm::dvec2& high, const Visit& visit) {
        const auto clamped = [](double x) { return std::clamp(static_cast<int>(x * fine), 0, size * fine - 1); };
        for (int row = clamped(low.y - 1); row <= clamped(high.y + 1); ++row) {
            for (int column = clamped(low.x - 1); column <= clamped(high.x + 1); ++column) {
                visit(counts[static_cast<std::size_t>(row * size * fine + column)], place(column, row));
            }
        }
    }
    // The area that is covered at least so many times.
    [[nodiscard]] double area(int times = 1) const {
        const auto covered = [&](int count) { return std::abs(count) >= times; };
        return static_cast<double>(std::count_if(counts.begin(), counts.end(), covered)) / (fine * fine);
    }
};

Raster raster_of(const StrokeMesh& mesh) {
    Raster raster;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec2 a = corner(mesh, i), b = corner(mesh, i + 1), c = corner(mesh, i + 2);
        raster.each_in(glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c)), [&](int& count, const glm::dvec2& p) {
            const double u = cross(b - a, p - a), v = cross(c - b, p - b), w = cross(a - c, p - c);
            if ((u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0)) ++count;
        });
    }
    return raster;
}

// Samples within half a width of the spine, with round ends.
Raster raster_of(const Strokes& strokes, const Stroke& stroke) {
    Raster raster;
    const std::span<const StrokePoint> points = strokes.points_of(stroke);
    for (std::size_t i = 0; i + (stroke.closed ? 0 : 1) < points.size(); ++i) {
        const StrokePoint &from = points[i], &to = points[(i + 1) % points.size()];
        const glm::dvec2 a = from.position, b = to.position;
        const double reach = std::max(from.width, to.width);
        raster.each_in(glm::min(a, b) - reach, glm::max(a, b) + reach, [&](int& count, const glm::dvec2& p) {
            const double t = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
            if (glm::distance(p, glm::mix(a, b, t)) < 0.5 * glm::mix(from.width, to.width, static_cast<float>(t))) {
                count = 1;
            }
        });
    }
    return raster;
}

// Samples that the rings wind round at all.
Raster raster_of(const std::vector<Ring>& rings) {
    Raster raster;
    for (const Ring& ring : rings) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const glm::dvec2 a = ring[i], b = ring[(i + 1) % ring.size()];
            raster.each_in({0, std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)},
                           [&](int& winding, const glm::dvec2& p) {
                               if ((a.y > p.y) == (b.y > p.y)) return;
                               if (p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) winding += b.y > a.y ? 1 : -1;
                           });
        }
    }
    return raster;
}

double difference(const Raster& a, const Raster& b) {
    int different = 0;
    for (std::size_t i = 0; i < a.counts.size(); ++i) different += (a.counts[i] != 0) != (b.counts[i] != 0);
    return different / double{Raster::fine * Raster::fine};
}

Polyline arc(double radius, double degrees, int count) {
    Polyline points;
    for (int i = 0; i <= count; ++i) {
        const double angle = degrees * i / count * std::numbers::pi / 180;
        points.push_back(glm::dvec2(200, 200) + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return points;
}

// Two straight legs joined by an arc of some degrees.
Polyline bend_of(double radius, double degrees, double leg, int count) {
    Polyline points = arc(radius, degrees, count);
    const auto onwards = [](const glm::dvec2& a, const glm::dvec2& b, double length) {
        return b + length * glm::normalize(b - a);
    };
    points.insert(points.begin(), {200 + radius, 200 - leg});
    points.push_back(onwards(points[points.size() - 2], points.back(), leg));
    return points;
}

// Long legs at random turns, now and then with a rounded corner.
Polyline ramble(std::uint64_t seed) {
    const Random random(seed, "ramble");
    Polyline points{{60, 200}};
    double heading = 0;
    for (std::uint64_t i = 0; i < 7; ++i) {
        const double turn = random.between(-2.2, 2.2, 10 * i) - 0.6 * heading;
        const int steps = random.unit(10 * i + 1) < 0.5 ? 1 : 6;
        for (int step = 0; step < steps; ++step) {
            heading += turn / steps;
            const double length = step + 1 == steps ? 42 : 4;
            points.push_back(points.back() + length * glm::dvec2(std::cos(heading), std::sin(heading)));
        }
    }
    return points;
}

TEST(StrokeMesh, AreaOfAnArc) {
    // Width by length of the spine, whatever the radius, as long as that exceeds half the width.
    for (const double radius : {20.0, 50.0, 150.0}) {
        const StrokeMesh mesh = make_stroke_mesh(stroke_of(arc(radius, 140, 200), 30));
        EXPECT_NEAR(sum_of_triangles(mesh), 30 * radius * 140 * std::numbers::pi / 180, 0.003 * 30 * radius * 2.4);
    }
}

TEST(StrokeMesh, AreaOfRoundEnds) {
    const StrokeMesh mesh = make_stroke_mesh(stroke_of({{50, 100}, {150, 100}}, 30, StrokeEnds::round));
    EXPECT_NEAR(sum_of_triangles(mesh), 3000 + std::numbers::pi * 225, 10);
    const StrokeMesh butt = make_stroke_mesh(stroke_of({{50, 100}, {150, 100}}, 30));
    EXPECT_NEAR(sum_of_triangles(butt), 3000, 1e-2);
    EXPECT_EQ(butt.indices.size(), 6u) << "two triangles are enough for a straight stroke";
}

struct Bend {
    const char* name;
    Polyline points;
    double width;
    bool closed = false;
};

std::vector<Bend> bends() {
    std::vector<Bend> all{{"right angle", {{100, 100}, {250, 100}, {250, 250}}, 30},
                          {"sharp angle", {{100, 100}, {250, 100}, {120, 140}}, 20},
                          {"many points before a corner", {}, 24},
                          {"points before a corner only", {}, 24},
                          {"hairpin", bend_of(8, 180, 90, 24), 14},
                          {"tight hairpin", bend_of(3, 170, 90, 24), 5},
                          {"right angle, tighter than the width", bend_of(4, 90, 90, 24), 30},
                          {"a third of a turn, tighter than the width", bend_of(6, 120, 90, 40), 40},
                          {"coarse", bend_of(6, 120, 90, 4), 40},
                          {"square", {{100, 100}, {250, 100}, {250, 250}, {100, 250}}, 30, true},
                          {"ring", circle(60, 90), 40, true},
                          {"wave", wave(), 16}};
    for (int i = 0; i <= 30; ++i) all[2].points.emplace_back(100 + 3 * i, 100);
    all[3].points = all[2].points;
    for (int i = 1; i <= 30; ++i) all[2].points.emplace_back(190, 100 + 3 * i);
    all[3].points.emplace_back(190, 190);
    return all;
}

TEST(StrokeMesh, BendsAreCoveredOnceAndWhole) {
    for (const Bend& bend : bends()) {
        SCOPED_TRACE(bend.name);
        const Strokes strokes = stroke_of(bend.points, bend.width, StrokeEnds::round, bend.closed);
        const StrokeMesh mesh = make_stroke_mesh(strokes);
        const Raster covered = raster_of(mesh), ideal = raster_of(strokes, strokes.strokes[0]);
        const double area = ideal.area();
        EXPECT_NEAR(sum_of_triangles(mesh), covered.area(), 0.01 * area);
        EXPECT_LT(covered.area(2), 0.01 * area);
        EXPECT_LT(difference(covered, ideal), 0.015 * area);
    }
}

TEST(StrokeMesh, RamblesAreCoveredOnceAndWholeButForLoops) {
    int checked = 0;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        SCOPED_TRACE(seed);
        const Strokes strokes = stroke_of(ramble(seed), 12, StrokeEnds::round);
        const StrokeMesh mesh = make_stroke_mesh(strokes);
        const Raster covered = raster_of(mesh), ideal = raster_of(strokes, strokes.strokes[0]);
        const double area = ideal.area();
        EXPECT_LT(difference(covered, ideal), 0.02 * area);
        if (area < 0.985 * (12 * length_of(ramble(seed)) + 36 * std::numbers::pi)) continue;  // comes back over itself
        EXPECT_LT(covered.area(2), 0.01 * area);
        ++checked;
    }
    EXPECT_GT(checked, 2);
}

TEST(StrokeMesh, TextureKeepsItsProportions) {
    const Strokes strokes = stroke_of({{50, 100}, {350, 100}}, 20);
    const StrokeMesh mesh = make_stroke_mesh(strokes, [](const std::string&) { return 99.0; });
    // Without a texture the proportions are 1: it repeats every 20 pixels.
    for (const StrokeVertex& vertex : mesh.vertices) {
        EXPECT_NEAR(vertex.texture.x, (vertex.position.x - 50) / 20, 1e-5);
        EXPECT_NEAR(vertex.texture.y, 0.5 + (vertex.position.y - 100) / 20, 1e-5) << "0 at the left, which is up";
    }
    Strokes textured = strokes;
    textured.brushes[0].texture = "chalk";
    for (const StrokeVertex& vertex : make_stroke_mesh(textured, [](const std::string& name) {
                                          EXPECT_EQ(name, "chalk");
                                          return 4.0;
                                      }).vertices) {
        EXPECT_NEAR(vertex.texture.x, (vertex.position.x - 50) / 80, 1e-5);
    }
    EXPECT_FALSE(is_even(textured, textured.strokes[0]));
}

TEST(StrokeMesh, TextureRepeatsWholeTimesAroundClosedStrokes) {
    const StrokeMesh mesh = make_stroke_mesh(stroke_of(circle(60, 90), 20, StrokeEnds::round, true));
    float longest = 0;
    for (const StrokeVertex& vertex : mesh.vertices) longest = std::max(longest, vertex.texture.x);
    EXPECT_NEAR(longest, 19, 1e-4) << "377 pixels by 20";
}

TEST(StrokeMesh, PartsFollowBrushes) {
    Drawing drawing{500, 500, {}, {}};
    add_line(drawing, {{0, 10}, {100, 10}}, LineClass::contour);
    add_line(drawing, {{0, 20}, {100, 20}}, LineClass::crease);
    add_line(drawing, {{0, 30}, {100, 30}}, LineClass::crease);
    StrokeOptions options = options_of({});
    options.styles.visible[static_cast<std::size_t>(LineClass::crease)].texture = "chalk";
    const Strokes strokes = make_strokes(drawing, options);
    const StrokeMesh mesh = make_stroke_mesh(strokes, [](const std::string&) { return 1.0; });
    ASSERT_EQ(mesh.parts.size(), 2u);
    EXPECT_EQ(strokes.brushes[mesh.parts[0].brush].texture, "chalk");
    EXPECT_EQ(mesh.parts[0].first_index, 0u);
    EXPECT_EQ(mesh.parts[1].first_index, mesh.parts[0].index_count);
    EXPECT_EQ(mesh.parts[1].first_index + mesh.parts[1].index_count, mesh.indices.size());
}

TEST(StrokeOutline, FillsExactlyTheStroke) {
    std::vector<Bend> all = bends();
    for (std::uint64_t seed = 0; seed < 3; ++seed) all.push_back({"ramble", ramble(seed), 26});
    for (const Bend& bend : all) {
        SCOPED_TRACE(bend.name);
        const Strokes strokes = stroke_of(bend.points, bend.width, StrokeEnds::round, bend.closed);
        const std::vector<Ring> rings = outline_of(strokes, strokes.strokes[0]);
        EXPECT_EQ(rings.size(), bend.closed ? 2u : 1u);
        const Raster ideal = raster_of(strokes, strokes.strokes[0]);
        EXPECT_LT(difference(raster_of(rings), ideal), 0.006 * ideal.area());
    }
}

TEST(StrokeOutline, FollowsTheTaper) {
    StrokeStyle style;
    style.width = {20, Length::Unit::pixels};
    style.taper_start = style.taper_end = {0.5, Length::Unit::share};
    const Strokes strokes = make_strokes(drawing_of({{50, 200}, {350, 200}}), options_of(style));
    const Raster filled = raster_of(outline_of(strokes, strokes.strokes[0]));
    // The integral of a quarter of a sine is 2 / pi of its box.
    EXPECT_NEAR(filled.area(), 300 * 20 * 2 / std::numbers::pi, 40);
}

TEST(StrokeOutline, DegenerateStrokesHaveNone) {
    Strokes strokes;
    strokes.points = {{{5, 5}, 1, 3}, {{5, 5}, 1, 3}};
    strokes.strokes = {{0, false, 0, 2, 0}, {0, false, 0, 0, 0}, {0, true, 0, 1, 0}};
    for (const Stroke& stroke : strokes.strokes) EXPECT_TRUE(outline_of(strokes, stroke).empty());
    EXPECT_TRUE(make_stroke_mesh(strokes).indices.empty());
}

}  // namespace
}  // namespace croquis::lines
