// Which edges are lines and what they are called, against solids whose lines are counted by hand.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "lines/drafter.h"
#include "model/load.h"
#include "support/temporary_folder.h"
#include "truth/ink.h"
#include "truth/views.h"

namespace croquis::lines {
namespace {

using namespace truth;
using model::Projection;
using test_support::quad_corners;

constexpr double degree = 0.017453292519943295;
constexpr ViewOptions parallel{Projection::parallel};

/// A convex solid by its corners and its faces' corners, counter-clockwise from outside.
struct Solid {
    const char* name;
    std::vector<glm::dvec3> points;
    std::vector<std::vector<std::size_t>> faces;
    bool has_creases = true;  ///< its faces bend by more than 60 degrees
};

Solid cube() {
    return {"cube",
            {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}},
            {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
}

Solid tetrahedron() {
    return {"tetrahedron",
            {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
            {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
}

// Neighbouring faces bend by 70.5 degrees.
Solid octahedron() {
    return {"octahedron",
            {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
            {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

// Neighbouring faces bend by 41.8 degrees: no creases.
Solid icosahedron() {
    const Corners corners = sphere_corners(0);
    Solid solid{"icosahedron", {}, {}, false};
    for (std::size_t i = 0; i < corners.size(); i += 3) {
        std::vector<std::size_t>& face = solid.faces.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 corner(corners[i + k]);
            auto found = std::find(solid.points.begin(), solid.points.end(), corner);
            if (found == solid.points.end()) found = solid.points.insert(found, corner);
            face.push_back(static_cast<std::size_t>(found - solid.points.begin()));
        }
    }
    return solid;
}

Corners corners_of(const Solid& solid) {
    Corners corners;
    for (const auto& face : solid.faces) {
        for (std::size_t k = 2; k < face.size(); ++k) {
            for (const std::size_t corner : {face[0], face[k - 1], face[k]}) corners.emplace_back(solid.points[corner]);
        }
    }
    return corners;
}

// A convex solid's edges: the outline where one face looks at the eye, visible between two that do, behind one layer
// between two that do not.
std::vector<Stroke3> strokes_of(const Solid& solid, const Surface& surface, const Viewpoint& view) {
    const auto point = [&](std::size_t corner) { return in_scene(surface, solid.points[corner]); };
    const auto faces_eye = [&](const std::vector<std::size_t>& face) {
        const glm::dvec3 a = point(face[0]);
        return glm::dot(glm::cross(point(face[1]) - a, point(face[2]) - a), view.towards_eye(a)) > 0;
    };
    std::vector<Stroke3> strokes;
    for (const auto& one : solid.faces) {
        for (const auto& other : solid.faces) {
            for (std::size_t k = 0; k < one.size(); ++k) {
                const std::size_t a = one[k], b = one[(k + 1) % one.size()];
                bool joined = false;
                for (std::size_t j = 0; j < other.size(); ++j) {
                    joined = joined || (other[j] == b && other[(j + 1) % other.size()] == a);
                }
                if (!joined || a > b) continue;
                const bool front = faces_eye(one), other_front = faces_eye(other);
                Stroke3 stroke{point(a), point(b), LineClass::contour};
                if (front == other_front) {
                    stroke.line_class = LineClass::crease;
                    stroke.layers = front ? 0 : 1;
                    if (!solid.has_creases) continue;
                }
                strokes.push_back(stroke);
            }
        }
    }
    return strokes;
}

void expect_strokes(const Surface& surface, const Viewpoint& view, const Drawing& drawing,
                    const std::vector<Stroke3>& strokes, const Alike& alike = {}) {
    std::string text;
    const double apart = difference(view, drawing, drawing_of(view, strokes), text, alike);
    EXPECT_EQ(apart, 0.0) << "the first is what was drawn, the second what was expected of "
                          << surface.model().meshes[0].name << "\n"
                          << text << text_of(drawing);
}

TEST(Features, OfConvexSolidsFromEverywhere) {
    for (const Solid& solid : {cube(), tetrahedron(), octahedron(), icosahedron()}) {
        const SurfacePointer surface = surface_of({corners_of(solid)});
        for (const Visibility visibility : {Visibility::automatic, Visibility::quantitative, Visibility::ray_cast}) {
            Drafter drafter(surface, exact_options(visibility));
            for (const Projection projection : {Projection::perspective, Projection::parallel}) {
                for (int i = 0; i < 12; ++i) {
                    const glm::dvec3 direction(std::cos(2.39 * i + 0.3), 0.13 + 0.15 * (i - 6),
                                               std::sin(2.39 * i + 0.3));
                    const Viewpoint view = view_from(*surface, direction, {projection});
                    SCOPED_TRACE(fmt::format("{} from {} {}", solid.name, i, projection == Projection::parallel));
                    expect_strokes(*surface, view, drafter.draw(view), strokes_of(solid, *surface, view));
                }
            }
        }
    }
}

TEST(Features, OfABoxWithoutLid) {
    const Solid solid = cube();
    Solid box = solid;
    box.faces.erase(box.faces.begin() + 4);  // y = 1
    const SurfacePointer surface = surface_of({corners_of(box)});
    const Viewpoint view = view_from(*surface, {0.1, 1, 0.15});
    std::vector<Stroke3> strokes;
    const auto add = [&](std::size_t a, std::size_t b, LineClass line_class) {
        strokes.push_back({in_scene(*surface, solid.points[a]), in_scene(*surface, solid.points[b]), line_class});
    };
    constexpr std::array<std::array<std::size_t, 2>, 4> rim{{{2, 3}, {3, 7}, {7, 6}, {6, 2}}};
    constexpr std::array<std::array<std::size_t, 2>, 8> inside{
        {{0, 1}, {1, 5}, {5, 4}, {4, 0}, {0, 3}, {1, 2}, {5, 6}, {4, 7}}};
    for (const auto& [a, b] : rim) add(a, b, LineClass::contour);
    for (const auto& [a, b] : inside) add(a, b, LineClass::crease);
    expect_strokes(*surface, view, draw(surface, view, exact_options()), strokes);
}

TEST(Features, MaterialBoundariesAndMeshes) {
    const SurfacePointer surface = surface_of(test_support::two_material_board());
    const Viewpoint view = view_from(*surface, {0.2, 0.1, 1});
    const auto at = [&](double x, double y) { return in_scene(*surface, {x, y, 0}); };
    const float y = 0.7f;
    std::vector<Stroke3> outline;
    for (const double side : {-1.0, 1.0}) {
        const std::uint32_t mesh = side < 0 ? 0 : 1;
        outline.push_back({at(0, -y), at(side, -y), LineClass::contour, 0, mesh});
        outline.push_back({at(side, -y), at(side, y), LineClass::contour, 0, mesh});
        outline.push_back({at(side, y), at(0, y), LineClass::contour, 0, mesh});
    }
    Options options = exact_options();
    options.classes.remove(LineClass::material);
    expect_strokes(*surface, view, draw(surface, view, options), outline, {.mesh = true});
    outline.push_back({at(0, -y), at(0, y), LineClass::material});
    expect_strokes(*surface, view, draw(surface, view, exact_options()), outline);
}

TEST(Features, ACreaseBendsByMoreThanTheAngle) {
    constexpr std::array bends{50.0, 59.9, 60.1, 70.0};  // up and down in turn, so that all faces look up
    std::vector<glm::dvec2> profile{{0, 0}};
    double tilt = 25;
    const auto step = [&] {
        profile.push_back(profile.back() + glm::dvec2(std::cos(tilt * degree), std::sin(tilt * degree)));
    };
    step();
    for (std::size_t i = 0; i < bends.size(); ++i) {
        tilt += i % 2 == 0 ? -bends[i] : bends[i];
        step();
    }
    Corners corners;
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
        const glm::vec2 a(profile[i]), b(profile[i + 1]);
        const Corners quad = quad_corners({a.x, a.y, 2}, {b.x, b.y, 2}, {b.x, b.y, -2}, {a.x, a.y, -2});
        corners.insert(corners.end(), quad.begin(), quad.end());
    }
    const SurfacePointer surface = surface_of({corners});
    const Viewpoint view = view_from(*surface, {0.05, 1, 0.1}, parallel);
    for (const double angle : {45.0, 55.0, 60.0, 65.0, 89.0}) {
        Options options = exact_options();
        options.crease_angle = angle * degree;
        options.classes = {LineClass::crease};
        std::vector<Stroke3> strokes;
        for (std::size_t i = 0; i < bends.size(); ++i) {
            const glm::vec2 at(profile[i + 1]);
            if (bends[i] < angle) continue;
            strokes.push_back(
                {in_scene(*surface, {at.x, at.y, 2}), in_scene(*surface, {at.x, at.y, -2}), LineClass::crease});
        }
        SCOPED_TRACE(angle);
        expect_strokes(*surface, view, draw(surface, view, options), strokes);
    }
}

TEST(Features, TaggedEdgesYieldToOutlinesOnly) {
    std::string text;
    for (const glm::dvec3& p : cube().points) text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
    for (const auto& face : cube().faces)
        text += fmt::format("f {} {} {} {}\n", face[0] + 1, face[1] + 1, face[2] + 1, face[3] + 1);
    text += "l 7 8\nl 6 7\nl 5 6 2\nl 1 2\n";  // two creases that are seen, two of the outline, one hidden
    const test_support::TemporaryFolder folder;
    const SurfacePointer surface = surface_of(model::load(folder.write("cube.obj", text)));
    const Viewpoint view = view_from(*surface, {1, 0.7, 1.3});
    std::vector<Stroke3> strokes = strokes_of(cube(), *surface, view);
    const auto tag = [&](std::size_t a, std::size_t b) {
        const glm::dvec3 one = in_scene(*surface, cube().points[a]), other = in_scene(*surface, cube().points[b]);
        for (Stroke3& stroke : strokes) {
            const bool same = (stroke.from == one && stroke.to == other) || (stroke.from == other && stroke.to == one);
            if (same && stroke.line_class == LineClass::crease) stroke.line_class = LineClass::tagged;
        }
    };
    tag(6, 7);
    tag(5, 6);
    tag(4, 5);
    tag(5, 1);
    tag(0, 1);
    expect_strokes(*surface, view, draw(surface, view, exact_options()), strokes);
}

// A square before part of another: outlines turn from contour to border where the one behind ends.
TEST(Features, TheContourEndsWhereSomethingLiesBehind) {
    const SurfacePointer surface =
        surface_of({quad_corners({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}),
                    quad_corners({0.5f, -0.5f, 1}, {2.5f, -0.5f, 1}, {2.5f, 0.5f, 1}, {0.5f, 0.5f, 1})});
    const Viewpoint view = view_from(*surface, {0, 0, 1}, parallel);
    std::vector<Stroke3> strokes;
    const auto add = [&](std::uint32_t mesh, const glm::dvec2& a, const glm::dvec2& b, LineClass line_class,
                         std::uint32_t layers = 0) {
        strokes.push_back({in_scene(*surface, {a, mesh}), in_scene(*surface, {b, mesh}), line_class, layers, mesh});
    };
    add(0, {-1, -1}, {1, -1}, LineClass::contour);
    add(0, {-1, 1}, {1, 1}, LineClass::contour);
    add(0, {-1, -1}, {-1, 1}, LineClass::contour);
    add(0, {1, -1}, {1, -0.5}, LineClass::contour);
    add(0, {1, 0.5}, {1, 1}, LineClass::contour);
    for (const double y : {-0.5, 0.5}) {
        add(1, {0.5, y}, {1, y}, LineClass::border);
        add(1, {1, y}, {2.5, y}, LineClass::contour);
    }
    add(1, {0.5, -0.5}, {0.5, 0.5}, LineClass::border);
    add(1, {2.5, -0.5}, {2.5, 0.5}, LineClass::contour);
    Options options = exact_options();
    options.hidden = false;
    expect_strokes(*surface, view, draw(surface, view, options), strokes, {.mesh = true});
    // The hidden piece is an outline too; whether it is called contour is not said.
    const Drawing all = draw(surface, view, exact_options());
    EXPECT_NEAR(length_of(all, LineClass::contour, 1) + length_of(all, LineClass::border, 1),
                view.scale * glm::distance(in_scene(*surface, {1, -0.5, 0}), in_scene(*surface, {1, 0.5, 0})), 1e-6);
}

TEST(Features, ABallBeforeABiggerOne) {
    const SurfacePointer surface = surface_of({sphere_corners(3), moved(sphere_corners(3), {0.1, 0.05, 3}, 0.3)});
    const Viewpoint view = view_from(*surface, {0, 0, 1}, parallel);
    const Drawing drawing = draw(surface, view, exact_options());
    for (const Line& line : drawing.lines) {
        EXPECT_EQ(line.layers, 0u);
        EXPECT_EQ(line.line_class, line.mesh == 0 ? LineClass::contour : LineClass::silhouette);
        EXPECT_TRUE(line.closed);
    }
    EXPECT_EQ(drawing.lines.size(), 2u) << text_of(drawing);
}

TEST(Features, BoardsThroughEachOther) {
    const SurfacePointer surface = surface_of(
        {quad_corners({-1, -0.8f, 0.6f}, {1, -0.8f, -0.6f}, {1, 0.8f, -0.6f}, {-1, 0.8f, 0.6f}),
         quad_corners({-0.75f, -0.5f, -0.45f}, {0.75f, -0.5f, 0.45f}, {0.75f, 0.5f, 0.45f}, {-0.75f, 0.5f, -0.45f})});
    const Viewpoint view = view_from(*surface, {0, 0, 1}, parallel);
    std::vector<Stroke3> strokes;
    const auto add = [&](double slope, const glm::dvec2& a, const glm::dvec2& b, LineClass line_class,
                         std::uint32_t layers = 0) {
        strokes.push_back(
            {in_scene(*surface, {a, slope * a.x}), in_scene(*surface, {b, slope * b.x}), line_class, layers});
    };
    constexpr double y = 0.8f;
    add(-0.6, {-1, -y}, {1, -y}, LineClass::contour);
    add(-0.6, {-1, y}, {1, y}, LineClass::contour);
    add(-0.6, {-1, -y}, {-1, y}, LineClass::contour);
    add(-0.6, {1, -y}, {1, y}, LineClass::contour);
    for (const double side : {-0.5, 0.5}) {
        add(0.6, {0, side}, {0.75, side}, LineClass::border);
        add(0.6, {-0.75, side}, {0, side}, LineClass::border, 1);
    }
    add(0.6, {0.75, -0.5}, {0.75, 0.5}, LineClass::border);
    add(0.6, {-0.75, -0.5}, {-0.75, 0.5}, LineClass::border, 1);
    add(0, {0, -0.5}, {0, 0.5}, LineClass::intersection);
    for (const Visibility visibility : {Visibility::automatic, Visibility::quantitative, Visibility::ray_cast}) {
        SCOPED_TRACE(static_cast<int>(visibility));
        expect_strokes(*surface, view, draw(surface, view, exact_options(visibility)), strokes);
    }
}

TEST(Features, APostThroughATable) {
    const SurfacePointer surface = surface_of({test_support::box_corners({-1, -0.1f, -1}, {1, 0.1f, 1}),
                                               test_support::box_corners({-0.25f, -1, -0.125f}, {0.25f, 1, 0.125f})});
    const Viewpoint view = view_from(*surface, {0.4, 0.6, 1});
    Options options = exact_options();
    options.classes = {LineClass::intersection};
    const Drawing drawing = draw(surface, view, options);
    const auto at = [&](double x, double y, double z) { return in_scene(*surface, {x, y, z}); };
    std::vector<Stroke3> strokes;
    // Seen from above: the post hides what is at its back, the table's top what is at its underside.
    for (const double y : {0.1f, -0.1f}) {
        const std::uint32_t layers = y > 0 ? 0 : 1;
        strokes.push_back({at(-0.25, y, 0.125), at(0.25, y, 0.125), LineClass::intersection, layers});
        strokes.push_back({at(0.25, y, -0.125), at(0.25, y, 0.125), LineClass::intersection, layers});
        strokes.push_back({at(-0.25, y, -0.125), at(0.25, y, -0.125), LineClass::intersection, layers + 1});
        strokes.push_back({at(-0.25, y, -0.125), at(-0.25, y, 0.125), LineClass::intersection, layers + 1});
    }
    expect_strokes(*surface, view, drawing, strokes);
}

TEST(Features, AClassLeftOutIsNotDrawn) {
    const SurfacePointer surface = surface_of({corners_of(cube())});
    const Viewpoint view = view_from(*surface, {1, 0.7, 1.3});
    std::vector<Stroke3> strokes = strokes_of(cube(), *surface, view);
    std::erase_if(strokes, [](const Stroke3& stroke) { return stroke.line_class != LineClass::contour; });
    Options options = exact_options();
    options.classes = {LineClass::contour, LineClass::silhouette};
    expect_strokes(*surface, view, draw(surface, view, options), strokes);
    options.classes = {LineClass::contour};
    expect_strokes(*surface, view, draw(surface, view, options), strokes);
    options.classes = {};
    EXPECT_TRUE(draw(surface, view, options).lines.empty());
}

TEST(Features, WithoutVisibilityEverythingIsDrawn) {
    const SurfacePointer surface = surface_of({corners_of(cube())});
    const Viewpoint view = view_from(*surface, {1, 0.7, 1.3});
    std::vector<Stroke3> strokes = strokes_of(cube(), *surface, view);
    for (Stroke3& stroke : strokes) stroke.layers = 0;
    expect_strokes(*surface, view, draw(surface, view, exact_options(Visibility::none)), strokes,
                   {.line_class = false});
}

}  // namespace
}  // namespace croquis::lines
