// Pieces joined into long curves: nothing is lost or drawn twice, outlines close, lines go straight on through
// junctions, and no point says what its neighbours say.
#include "lines/chains.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "lines/drafter.h"
#include "truth/ink.h"
#include "truth/view_truth.h"
#include "truth/views.h"

namespace croquis::lines {
namespace {

using namespace truth;

constexpr double pi = 3.14159265358979323846;
constexpr ViewOptions parallel{model::Projection::parallel};

struct Body {
    const char* name;
    Corners corners;
    int views = 8;
};

std::vector<Body> smooth_bodies() {
    return {{"sphere", sphere_corners(3), 6},
            {"torus", torus(1, 0.4, 48, 24)},
            {"thin torus", torus(1, 0.15, 60, 12)},
            {"waves", bumpy_sphere(3, 0.25, 0, 1)},
            {"knot", torus_knot(2, 3, 0.45, 120, 12)}};
}

std::vector<Body> all_bodies() {
    std::vector<Body> bodies = smooth_bodies();
    bodies.push_back({"gear", gear(9, 0.4)});
    bodies.push_back({"box", test_support::box_corners({-1, -0.6f, -0.3f}, {1, 0.6f, 0.3f})});
    bodies.push_back({"open sheet", wavy_sheet(24, 0.25, 1)});
    bodies.push_back({"noise", bumpy_sphere(3, 0.1, 0.02, 2)});
    return bodies;
}

Options exact_visible() {
    Options options;
    options.clean = false;
    return options;
}

/// The visible length of a view's edges in pixels: each sampled, and every change between two samples halved down.
double visible_length(const ViewTruth& truth) {
    double total = 0;
    for (const SeenEdge& edge : truth.edges()) {
        if (!edge.required) continue;
        const int samples = 4 + static_cast<int>(0.7 * edge.length());
        const auto is_visible = [&](double share) { return truth.sight(edge, edge.at(share)).layers == 0; };
        double visible = 0, before = 1e-6;
        bool was_visible = is_visible(before);
        for (int i = 1; i <= samples; ++i) {
            const double after = i == samples ? 1 - 1e-6 : (i + 0.137) / samples;
            const bool now_visible = is_visible(after);
            double low = before, high = after;
            while (now_visible != was_visible && high - low > 1e-9) {
                const double middle = 0.5 * (low + high);
                (is_visible(middle) == was_visible ? low : high) = middle;
            }
            if (was_visible) visible += (now_visible ? after : low) - before;
            if (now_visible && !was_visible) visible += after - high;
            before = after;
            was_visible = now_visible;
        }
        total += visible * edge.length();
    }
    return total;
}

TEST(Chains, HoldTheWholeVisibleLength) {
    for (const Body& body : smooth_bodies()) {
        const SurfacePointer surface = surface_of({body.corners});
        const SurfaceTruth surface_truth(surface, Options{}.crease_angle);
        for (const Visibility visibility : {Visibility::quantitative, Visibility::ray_cast}) {
            Options options = exact_visible();
            options.visibility = visibility;
            Drafter drafter(surface, options);
            for (int v = 0; v < fewer_if_slow(body.views); ++v) {
                const Viewpoint view = random_view(*surface, 3, static_cast<std::uint64_t>(v));
                const double expected = visible_length(ViewTruth(surface_truth, view));
                EXPECT_NEAR(length_of(drafter.draw(view)), expected, 0.1 + 5e-5 * expected)
                    << body.name << ", view " << v << ", visibility " << static_cast<int>(visibility);
            }
        }
    }
}

TEST(Chains, TheOutlineOfAConvexBodyIsOneClosedLine) {
    for (const Body& body : {Body{"sphere", sphere_corners(3)}, Body{"box", all_bodies()[6].corners},
                             Body{"egg", shaped(sphere_corners(3), [](const glm::dvec3& p) {
                                      return glm::dvec3(p.x, 1.7 * p.y, 0.6 * p.z);
                                  })}}) {
        const SurfacePointer surface = surface_of({body.corners});
        Options options = exact_visible();
        options.classes = {LineClass::contour};
        Drafter drafter(surface, options);
        for (int v = 0; v < fewer_if_slow(40); ++v) {
            const glm::dvec3 direction(std::cos(2.4 * v), 0.11 + 0.04 * (v - 20), std::sin(2.4 * v));
            const Drawing drawing = drafter.draw(view_from(*surface, direction, v % 2 == 0 ? parallel : ViewOptions{}));
            ASSERT_EQ(drawing.lines.size(), 1u) << body.name << ", view " << v << "\n" << text_of(drawing);
            EXPECT_TRUE(drawing.lines[0].closed) << body.name << ", view " << v;
            EXPECT_EQ(drawing.lines[0].line_class, LineClass::contour) << body.name << ", view " << v;
        }
    }
}

TEST(Chains, ACubesOutlineHasItsSixCorners) {
    const SurfacePointer surface = surface_of(test_support::cube());
    for (const LineClasses classes : {LineClasses{LineClass::contour}, LineClasses::all()}) {
        Options options = exact_visible();
        options.classes = classes;
        for (const glm::dvec3& direction :
             {glm::dvec3(1, 0.7, 1.3), glm::dvec3(-0.5, 0.8, 1.1), glm::dvec3(2, -1, -3)}) {
            const Viewpoint view = view_from(*surface, direction);
            const Drawing drawing = draw(surface, view, options);
            const auto contour = std::find_if(drawing.lines.begin(), drawing.lines.end(),
                                              [](const Line& line) { return line.line_class == LineClass::contour; });
            ASSERT_NE(contour, drawing.lines.end());
            EXPECT_TRUE(contour->closed);
            ASSERT_EQ(contour->point_count, 6u) << text_of(drawing);
            for (const LinePoint& point : drawing.points_of(*contour)) {
                double nearest = 1e300;
                for (int corner = 0; corner < 8; ++corner) {
                    const glm::dvec3 place(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
                    nearest = std::min(nearest,
                                       glm::distance(view.project(in_scene(*surface, place)).position, point.position));
                }
                EXPECT_LT(nearest, 1e-5);
            }
            EXPECT_EQ(drawing.lines.size(), classes == LineClasses::all() ? 3u : 1u)
                << "of three creases that meet at an angle two make one line\n"
                << text_of(drawing);
        }
    }
}

TEST(Chains, ATorusSeenAlongItsAxisIsTwoCircles) {
    const SurfacePointer surface = surface_of({torus(1, 0.4, 48, 25)});
    const Viewpoint view = view_from(*surface, {0.01, 0.02, 1});
    const Drawing drawing = draw(surface, view, exact_visible());
    ASSERT_EQ(drawing.lines.size(), 2u) << text_of(drawing);
    for (const Line& line : drawing.lines) {
        EXPECT_TRUE(line.closed);
        EXPECT_EQ(line.line_class, LineClass::contour);
    }
}

TEST(Chains, AClosedLineThatTheFrameCutsIsOpen) {
    const SurfacePointer surface = surface_of({sphere_corners(3)});
    ViewOptions options;
    options.zoom = 1.35;  // the circle leaves the frame above and below, not at its sides
    const Viewpoint view = view_from(*surface, {0.3, 0.2, 1}, options);
    const Drawing drawing = draw(surface, view, exact_visible());
    EXPECT_EQ(drawing.lines.size(), 2u) << text_of(drawing);
    for (const Line& line : drawing.lines) {
        EXPECT_FALSE(line.closed);
        const auto points = drawing.points_of(line);
        for (const LinePoint& end : {points.front(), points.back()}) {
            EXPECT_LT(std::min(std::abs(end.position.y), std::abs(view.height - end.position.y)), 1e-6);
        }
    }
}

// Folds that meet at a point, in turn up and down, as rays from the middle of a star.
struct Star {
    std::vector<double> angles;

    [[nodiscard]] glm::dvec3 end(std::size_t ray) const {
        const std::size_t i = ray % angles.size();
        return {std::cos(angles[i]), std::sin(angles[i]), i % 2 == 0 ? 0.0 : -1.2};
    }
    [[nodiscard]] Corners corners() const {
        Corners corners;
        for (std::size_t i = 0; i < angles.size(); ++i) {
            for (const glm::dvec3& p : {glm::dvec3(0.0), end(i), end(i + 1)}) corners.emplace_back(p);
        }
        return corners;
    }
};

TEST(Chains, GoOnThroughJunctionsByLeastTurn) {
    struct Case {
        std::vector<double> degrees;
        std::vector<std::array<std::size_t, 2>> joined;  // rays that are one line
    };
    const std::vector<Case> cases{
        {{0, 45, 90, 135, 180, 225, 270, 315}, {{0, 4}, {1, 5}, {2, 6}, {3, 7}}},
        // Turns of 10, 20, 5 and 15 degrees.
        {{0, 45, 90, 135, 190, 245, 265, 330}, {{0, 4}, {1, 5}, {2, 6}, {3, 7}}},
        // Ray 0 could go on as 2 or as 3, by 20 and by 10 degrees; what is left turns too much.
        {{0, 70, 160, 190, 250, 290}, {{0, 3}, {1, 4}}},
        {{0, 100, 150, 200}, {{0, 3}}},  // 0 to 3: 20 degrees, 0 to 2: 30, 1 to 3: 80
        {{10, 60, 110, 135}, {}},        // no two within 45 degrees of straight on
    };
    for (std::size_t c = 0; c < cases.size(); ++c) {
        Star star;
        for (const double degrees : cases[c].degrees) star.angles.push_back(degrees * pi / 180 + 0.1);
        const SurfacePointer surface = surface_of({star.corners()});
        const Viewpoint view = view_from(*surface, {0, 0, 1}, parallel);
        Options options = exact_visible();
        options.classes = {LineClass::crease};
        options.crease_angle = 0.2;
        const Drawing drawing = draw(surface, view, options);
        const auto ray_at = [&](const LinePoint& point) {
            for (std::size_t i = 0; i < star.angles.size(); ++i) {
                if (glm::distance(view.project(in_scene(*surface, star.end(i))).position, point.position) < 1e-5)
                    return i;
            }
            return star.angles.size();
        };
        std::vector<std::array<std::size_t, 2>> joined;
        for (const Line& line : drawing.lines) {
            const auto points = drawing.points_of(line);
            std::array<std::size_t, 2> ends{ray_at(points.front()), ray_at(points.back())};
            std::sort(ends.begin(), ends.end());
            if (ends[1] < star.angles.size()) joined.push_back(ends);
        }
        std::sort(joined.begin(), joined.end());
        EXPECT_EQ(joined, cases[c].joined) << "case " << c << "\n" << text_of(drawing);
        EXPECT_EQ(drawing.lines.size(), star.angles.size() - joined.size()) << "case " << c;
    }
}

/// An end of a line, with the direction in which the line goes on into it.
struct LineEnd {
    std::size_t line;
    glm::dvec2 onward;
};

// No two ends are left at one place that would go on into each other.
void expect_no_more_to_join(const Drawing& drawing, const std::string& name) {
    using Place = std::tuple<LineClass, std::uint32_t, std::uint32_t, long, long, long>;
    std::map<Place, std::vector<LineEnd>> ends;
    for (std::size_t l = 0; l < drawing.lines.size(); ++l) {
        const Line& line = drawing.lines[l];
        if (line.closed) continue;
        const auto points = drawing.points_of(line);
        ASSERT_GE(points.size(), 2u) << name;
        const auto add = [&](const LinePoint& end, const LinePoint& next) {
            const glm::dvec2 onward = end.position - next.position;
            const auto rounded = [](double value) { return std::lround(value * 1e6); };
            ends[{line.line_class, line.mesh, line.layers, rounded(end.position.x), rounded(end.position.y),
                  rounded(end.depth)}]
                .push_back({l, onward / std::max(glm::length(onward), 1e-300)});
        };
        add(points.front(), points[1]);
        add(points.back(), points[points.size() - 2]);
    }
    for (const auto& [place, here] : ends) {
        for (std::size_t i = 0; i < here.size(); ++i) {
            for (std::size_t k = i + 1; k < here.size(); ++k) {
                const double cosine = -glm::dot(here[i].onward, here[k].onward);
                EXPECT_LT(cosine, 0.7072) << name << ": lines " << here[i].line << " and " << here[k].line << " at ("
                                          << static_cast<double>(std::get<3>(place)) * 1e-6 << ", "
                                          << static_cast<double>(std::get<4>(place)) * 1e-6 << ")";
            }
        }
    }
}

// No point stands on its neighbour, or on the straight way between its neighbours, in the picture and in depth.
void expect_no_idle_points(const Drawing& drawing, const std::string& name) {
    std::size_t equal = 0, idle = 0;
    std::string first;
    for (const Line& line : drawing.lines) {
        const auto points = drawing.points_of(line);
        const std::size_t count = points.size();
        for (std::size_t i = 0; i < count; ++i) {
            if (!line.closed && i + 1 == count) break;
            const LinePoint &point = points[i], &next = points[(i + 1) % count];
            if (glm::distance(point.position, next.position) < 1e-7) ++equal;
            if (!line.closed && i == 0) continue;
            const LinePoint& before = points[(i + count - 1) % count];
            const glm::dvec2 whole = next.position - before.position, part = point.position - before.position;
            const double length = glm::length(whole), share = glm::dot(whole, part) / (length * length);
            if (!(share > 0 && share < 1)) continue;
            const double aside = std::abs(whole.x * part.y - whole.y * part.x) / length;
            const double depth = before.depth + share * (next.depth - before.depth);
            if (aside < 1e-6 && std::abs(depth - point.depth) < 1e-8) {
                ++idle;
                if (first.empty()) {
                    first =
                        fmt::format("point {} of {} at ({:.4f}, {:.4f})", i, count, point.position.x, point.position.y);
                }
            }
        }
    }
    EXPECT_EQ(equal, 0u) << name;
    EXPECT_EQ(idle, 0u) << name << ": " << first;
}

TEST(Chains, AreAsLongAsTheyCanBe) {
    for (const Body& body : all_bodies()) {
        const SurfacePointer surface = surface_of({body.corners});
        for (const bool hidden : {false, true}) {
            Options options = exact_visible();
            options.hidden = hidden;
            Drafter drafter(surface, options);
            for (int v = 0; v < fewer_if_slow(body.views); ++v) {
                const Viewpoint view = random_view(*surface, 5, static_cast<std::uint64_t>(v));
                expect_no_more_to_join(drafter.draw(view),
                                       fmt::format("{}, view {}, {}", body.name, v, hidden ? "hidden too" : "visible"));
            }
        }
    }
}

TEST(Chains, HaveNoPointThatSaysNothing) {
    for (const Body& body : all_bodies()) {
        const SurfacePointer surface = surface_of({body.corners});
        for (const bool hidden : {false, true}) {
            Options options = exact_visible();
            options.hidden = hidden;
            Drafter drafter(surface, options);
            for (int v = 0; v < fewer_if_slow(body.views); ++v) {
                const Viewpoint view = random_view(*surface, 5, static_cast<std::uint64_t>(v));
                expect_no_idle_points(drafter.draw(view),
                                      fmt::format("{}, view {}, {}", body.name, v, hidden ? "hidden too" : "visible"));
            }
        }
    }
}

// A plate with edges cut into many pieces has four sides all the same, wherever its outline begins.
TEST(Chains, LeaveOutThePointsOfStraightEdges) {
    const Corners plate = grid_of({9, 7}, [](double u, double v) { return glm::dvec3(2 * u - 1, 2 * v - 1, 0); });
    for (int first = 0; first < 6; ++first) {
        Corners corners = plate;
        std::rotate(corners.begin(), corners.begin() + 3 * 17 * first, corners.end());
        const SurfacePointer surface = surface_of({corners});
        const Drawing drawing = draw(surface, view_from(*surface, {0.2, 0.3, 1}), exact_visible());
        ASSERT_EQ(drawing.lines.size(), 1u);
        EXPECT_TRUE(drawing.lines[0].closed);
        EXPECT_EQ(drawing.lines[0].point_count, 4u) << text_of(drawing);
    }
}

// A fine mesh turns so little at each vertex that every one of them seems to say nothing.
TEST(Chains, KeepTheShapeOfFineCurves) {
    const int sides = 2000 + fewer_if_slow(58000);
    const Corners ring = grid_of({sides, 1, true, false}, [](double u, double v) {
        return (1 - 0.5 * v) * glm::dvec3(std::cos(2 * pi * u), std::sin(2 * pi * u), 0.0);
    });
    const SurfacePointer surface = surface_of({ring});
    const Viewpoint view = view_from(*surface, {0, 0, 1}, parallel);
    Options options = exact_visible();
    options.classes = {LineClass::border};
    const Drawing drawing = draw(surface, view, options);
    ASSERT_EQ(drawing.lines.size(), 2u);
    const glm::dvec2 middle(0.5 * view.width, 0.5 * view.height);
    const double outer = glm::distance(view.project(in_scene(*surface, {1, 0, 0})).position, middle);
    double farthest = 0;
    for (const Line& line : drawing.lines) {
        const auto points = drawing.points_of(line);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const glm::dvec2 half = 0.5 * (points[i].position + points[(i + 1) % points.size()].position);
            const double radius = glm::distance(half, middle);
            farthest = std::max(farthest, std::min(std::abs(radius - outer), std::abs(radius - 0.5 * outer)));
        }
    }
    EXPECT_LT(farthest, 5e-3);
}

}  // namespace
}  // namespace croquis::lines
