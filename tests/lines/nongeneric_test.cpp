// Views in which edges, faces and bodies line up exactly, and models whose faces coincide: what must be seen there is
// told by closed forms.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "lines/drafter.h"
#include "truth/ink.h"
#include "truth/solids.h"
#include "truth/views.h"

namespace croquis::lines {
namespace {

using namespace truth;
using model::Projection;
using test_support::box_corners;
using test_support::quad_corners;

constexpr double pi = 3.14159265358979323846;

struct Way {
    const char* name;
    Visibility visibility;
};
constexpr std::array ways{Way{"quantitative", Visibility::quantitative}, Way{"ray casts", Visibility::ray_cast},
                          Way{"automatic", Visibility::automatic}};

Options visible_only(Visibility visibility) {
    Options options;
    options.clean = false;
    options.visibility = visibility;
    return options;
}

/// The whole of a model along an axis or from a corner, exactly: no rounding turns the view away.
Viewpoint exact_view(const glm::ivec3& direction, Projection projection) {
    const glm::dvec3 back = glm::normalize(glm::dvec3(direction));
    Viewpoint view = view_at(3.0 * back, -back, 0.9);
    if (projection == Projection::parallel) {
        view.projection = projection;
        view.scale = 220;
    }
    return view;
}

enum class Doubles : std::uint8_t { forbidden, allowed };

/// What a view must show, no more and no less.
struct Expected {
    std::vector<Stroke3> strokes;
    Alike alike{};
    Doubles doubles = Doubles::forbidden;
};

void expect_drawn(const SurfacePointer& surface, const Viewpoint& view, const Expected& expected,
                  const std::string& name) {
    const Drawing truth = drawing_of(view, expected.strokes);
    for (const Way& way : ways) {
        const Drawing drawing = draw(surface, view, visible_only(way.visibility));
        std::string text;
        const double apart = difference(view, drawing, truth, text, expected.alike);
        EXPECT_LT(apart, 1e-3 * length_of(truth)) << name << ", " << way.name << "; first: drawn, second: expected\n"
                                                  << text << text_of(drawing);
        if (expected.doubles == Doubles::forbidden) {
            std::string twice;
            EXPECT_EQ(doubled_ink(view, drawing, twice), 0.0) << name << ", " << way.name << "\n" << twice;
        }
        for (const Line& line : drawing.lines) {
            EXPECT_TRUE(line.visible());
            EXPECT_GT(lines::length_of(drawing, line), 1e-3) << name << ", " << way.name << ": an edge seen end-on";
        }
    }
}

/// An upright box by its corners.
struct Box3 {
    glm::dvec3 low{-1.0}, high{1.0};

    [[nodiscard]] Corners corners() const { return box_corners(glm::vec3(low), glm::vec3(high)); }
};

int sign_of(double value) { return value > 1e-9 ? 1 : value < -1e-9 ? -1 : 0; }

// A box's edges that are seen: those of the faces truly turned to the eye. A face seen edge-on shows nothing.
std::vector<Stroke3> seen_edges(const Box3& box, const Surface& surface, const Viewpoint& view, LineClass outline) {
    const auto faces_eye = [&](int axis, int end) {
        glm::dvec3 normal(0.0);
        normal[axis] = end == 1 ? 1 : -1;
        const glm::dvec3 corner = in_scene(surface, end == 1 ? box.high : box.low);
        return sign_of(glm::dot(normal, view.towards_eye(corner))) > 0;
    };
    std::vector<Stroke3> strokes;
    for (int axis = 0; axis < 3; ++axis) {
        const int other = (axis + 1) % 3, third = (axis + 2) % 3;
        for (const int i : {0, 1}) {
            for (const int k : {0, 1}) {
                const int seen = (faces_eye(other, i) ? 1 : 0) + (faces_eye(third, k) ? 1 : 0);
                if (seen == 0) continue;
                glm::dvec3 from = box.low;
                from[other] = i == 1 ? box.high[other] : box.low[other];
                from[third] = k == 1 ? box.high[third] : box.low[third];
                glm::dvec3 to = from;
                to[axis] = box.high[axis];
                strokes.push_back(
                    {in_scene(surface, from), in_scene(surface, to), seen == 2 ? LineClass::crease : outline});
            }
        }
    }
    return strokes;
}

std::vector<Stroke3> operator+(std::vector<Stroke3> one, const std::vector<Stroke3>& other) {
    one.insert(one.end(), other.begin(), other.end());
    return one;
}

TEST(NonGeneric, ABoxFromAllExactDirections) {
    const Box3 cube, beam{{-1, -0.5, -0.25}, {1, 0.5, 0.25}};
    for (const Box3& box : {cube, beam}) {
        const SurfacePointer surface = surface_of({box.corners()});
        for (const Projection projection : {Projection::parallel, Projection::perspective}) {
            for (int i = 0; i < 27; ++i) {
                if (i == 13) continue;
                const glm::ivec3 direction(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
                const Viewpoint view = exact_view(direction, projection);
                expect_drawn(surface, view, {seen_edges(box, *surface, view, LineClass::contour)},
                             fmt::format("from {} {} {}{}", direction.x, direction.y, direction.z,
                                         projection == Projection::parallel ? ", parallel" : ""));
            }
        }
    }
}

// The eye in the plane of one face, and on the line of an edge.
TEST(NonGeneric, ABoxFromWithinThePlanesOfItsFaces) {
    const Box3 box;
    const SurfacePointer surface = surface_of({box.corners()});
    for (const glm::dvec3& eye : {glm::dvec3(1, 0, 5), glm::dvec3(1, 1, 5), glm::dvec3(1, 3, 4), glm::dvec3(-4, -1, 1),
                                  glm::dvec3(1, -1, -6)}) {
        const glm::dvec3 from = in_scene(*surface, eye);
        const Viewpoint view = view_at(from, -from, 0.9);
        expect_drawn(surface, view, {seen_edges(box, *surface, view, LineClass::contour)},
                     fmt::format("from ({}, {}, {})", eye.x, eye.y, eye.z));
    }
}

std::vector<Box3> grid_of_cubes(int count) {
    std::vector<Box3> boxes;
    for (int i = 0; i < count * count * count; ++i) {
        const glm::dvec3 low = 2.0 * glm::dvec3(i % count, i / count % count, i / (count * count));
        boxes.push_back({low, low + 1.0});
    }
    return boxes;
}

SurfacePointer surface_of_boxes(const std::vector<Box3>& boxes, bool one_mesh) {
    std::vector<Corners> meshes;
    for (const Box3& box : boxes) meshes.push_back(box.corners());
    return one_mesh ? surface_of({joined(meshes)}) : surface_of(meshes);
}

// Each cube has others exactly behind it. Whether their rims show beside those in front is within rounding: they may be
// drawn on the same places, and nowhere else.
TEST(NonGeneric, AGridOfCubesEndOn) {
    const std::vector<Box3> boxes = grid_of_cubes(3);
    for (const bool one_mesh : {false, true}) {
        const SurfacePointer surface = surface_of_boxes(boxes, one_mesh);
        for (const glm::ivec3& direction : {glm::ivec3(0, 0, 1), glm::ivec3(-1, 0, 0), glm::ivec3(0, 1, 0)}) {
            const Viewpoint view = exact_view(direction, Projection::parallel);
            std::vector<Stroke3> strokes;
            for (const Box3& box : boxes) {
                const double place = glm::dot(glm::dvec3(direction), box.low);
                if (place == (direction.x + direction.y + direction.z > 0 ? 4.0 : 0.0)) {
                    strokes = strokes + seen_edges(box, *surface, view, LineClass::contour);
                }
            }
            expect_drawn(surface, view, {strokes, {.depth = false}, Doubles::allowed},
                         fmt::format("along {} {} {}", direction.x, direction.y, direction.z));
        }
    }
}

// Along the diagonal the cubes' hexagons tile with gaps, meet at corners, and cover others exactly.
TEST(NonGeneric, AGridOfCubesAlongItsDiagonal) {
    const std::vector<Box3> boxes = grid_of_cubes(3);
    const SurfacePointer surface = surface_of_boxes(boxes, false);
    const Viewpoint view = exact_view({1, 1, 1}, Projection::parallel);
    std::vector<Stroke3> strokes;
    for (const Box3& box : boxes) {
        if (std::max({box.low.x, box.low.y, box.low.z}) == 4.0) {
            strokes = strokes + seen_edges(box, *surface, view, LineClass::contour);
        }
    }
    expect_drawn(surface, view, {strokes}, "diagonal");
}

// From above at 45 degrees: nothing is half hidden, the sides of both boxes are seen edge-on.
TEST(NonGeneric, ABoxOnATable) {
    const Box3 table{{-2, -0.25, -2}, {2, 0, 2}}, box{{-0.5, 0, -0.5}, {0.5, 1, 0.5}};
    for (const bool one_mesh : {false, true}) {
        const SurfacePointer surface = surface_of_boxes({table, box}, one_mesh);
        for (const glm::ivec3& direction : {glm::ivec3(0, 1, 1), glm::ivec3(-1, 1, 0), glm::ivec3(0, 1, 0)}) {
            const Viewpoint view = exact_view(direction, Projection::parallel);
            expect_drawn(surface, view,
                         {seen_edges(table, *surface, view, LineClass::contour) +
                          seen_edges(box, *surface, view, LineClass::silhouette)},
                         fmt::format("from {} {} {}", direction.x, direction.y, direction.z));
        }
    }
}

// A thin plate glued onto a block hides none of the block's edges from these directions.
TEST(NonGeneric, APlateFlushOnABlock) {
    const Box3 block{{-1, -1, -1}, {0, 1, 1}}, plate{{0, -0.5, -0.5}, {0.125, 0.5, 0.5}};
    for (const bool one_mesh : {false, true}) {
        const SurfacePointer surface = surface_of_boxes({block, plate}, one_mesh);
        for (const glm::ivec3& direction : {glm::ivec3(1, 0, 0), glm::ivec3(1, 1, 1), glm::ivec3(1, 1, 0),
                                            glm::ivec3(7, 4, 5), glm::ivec3(7, -4, 5)}) {
            for (const Projection projection : {Projection::parallel, Projection::perspective}) {
                const Viewpoint view = exact_view(direction, projection);
                expect_drawn(surface, view,
                             {seen_edges(block, *surface, view, LineClass::contour) +
                                  seen_edges(plate, *surface, view, LineClass::silhouette),
                              {.line_class = false}},
                             fmt::format("from {} {} {}", direction.x, direction.y, direction.z));
            }
        }
    }
}

// Two blocks that share a wall: outline and creases of the two together, and the seam once.
TEST(NonGeneric, TwoBlocksSideBySide) {
    const Box3 left{{-2, -1, -1}, {0, 1, 1}}, right{{0, -1, -1}, {2, 1, 1}}, both{{-2, -1, -1}, {2, 1, 1}};
    for (const bool one_mesh : {false, true}) {
        const SurfacePointer surface = surface_of_boxes({left, right}, one_mesh);
        for (const glm::ivec3& direction : {glm::ivec3(0, 0, 1), glm::ivec3(1, 1, 1), glm::ivec3(0, 1, 1),
                                            glm::ivec3(3, 4, 7), glm::ivec3(-3, 5, 6)}) {
            for (const Projection projection : {Projection::parallel, Projection::perspective}) {
                const Viewpoint view = exact_view(direction, projection);
                std::vector<Stroke3> strokes = seen_edges(both, *surface, view, LineClass::contour);
                const auto seam = [&](const glm::dvec3& a, const glm::dvec3& b) {
                    strokes.push_back({in_scene(*surface, a), in_scene(*surface, b)});
                };
                seam({0, -1, 1}, {0, 1, 1});
                if (direction.y > 0) seam({0, 1, -1}, {0, 1, 1});
                expect_drawn(
                    surface, view, {strokes, {.line_class = false}},
                    fmt::format("from {} {} {}{}{}", direction.x, direction.y, direction.z,
                                one_mesh ? ", one mesh" : "", projection == Projection::parallel ? ", parallel" : ""));
            }
        }
    }
}

// Treads are seen edge-on from the front: each step is one line, though two edges lie on it.
TEST(NonGeneric, AStairFromTheFront) {
    constexpr int steps = 4;
    std::vector<glm::dvec2> profile;  // z and y, the outline of the stair from the side
    for (int i = 0; i < steps; ++i) {
        profile.emplace_back(steps - i, i);
        profile.emplace_back(steps - i, i + 1);
    }
    // Back wall and floor are cut where the ends of the steps are, so that edges meet edges.
    for (int i = steps; i >= 0; --i) profile.emplace_back(0, i);
    for (int i = 1; i < steps; ++i) profile.emplace_back(i, 0);
    const auto at = [&](std::size_t i, double x) {
        const glm::dvec2& p = profile[i % profile.size()];
        return glm::vec3(static_cast<float>(x), static_cast<float>(p.y), static_cast<float>(p.x));
    };
    Corners corners;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const Corners side = quad_corners(at(i, -3), at(i + 1, -3), at(i + 1, 3), at(i, 3));
        corners.insert(corners.end(), side.begin(), side.end());
    }
    for (int i = 0; i < steps; ++i) {  // both ends of each step, from the back wall to its riser
        const float y = static_cast<float>(i), z = static_cast<float>(steps - i);
        for (const float x : {-3.0f, 3.0f}) {
            Corners end;
            for (int k = 0; k < steps - i; ++k) {
                const float near = z - static_cast<float>(k), far = near - 1;
                const Corners cell = quad_corners({x, y, far}, {x, y, near}, {x, y + 1, near}, {x, y + 1, far});
                end.insert(end.end(), cell.begin(), cell.end());
            }
            if (x < 0) end = inside_out(end);
            corners.insert(corners.end(), end.begin(), end.end());
        }
    }
    const SurfacePointer surface = surface_of({inside_out(corners)});
    ASSERT_TRUE(surface->topology().mesh_is_solid[0] && !surface->topology().mesh_is_inverted[0]);
    const Viewpoint view = exact_view({0, 0, 1}, Projection::parallel);
    std::vector<Stroke3> strokes;
    const auto add = [&](const glm::dvec3& a, const glm::dvec3& b, LineClass line_class) {
        strokes.push_back({in_scene(*surface, a), in_scene(*surface, b), line_class});
    };
    add({-3, 0, steps}, {3, 0, steps}, LineClass::contour);
    for (int i = 0; i < steps; ++i) {
        const double z = steps - i;
        for (const double x : {-3.0, 3.0}) add({x, i, z}, {x, i + 1, z}, LineClass::contour);
        add({-3, i + 1, z}, {3, i + 1, z}, i + 1 == steps ? LineClass::contour : LineClass::silhouette);
    }
    expect_drawn(surface, view, {strokes}, "stair");
}

// A prism along its axis, its sides edge-on: the polygon, once.
TEST(NonGeneric, PrismsAlongTheirAxis) {
    for (const int sides : {3, 6, 24}) {
        const auto rim = [&](int i, double z) {
            const double angle = 2 * pi * (i % sides) / sides;
            return glm::dvec3(glm::vec3(glm::dvec3(std::cos(angle), std::sin(angle), z)));
        };
        Corners corners;
        for (int i = 0; i < sides; ++i) {
            const glm::vec3 a(rim(i, -1)), b(rim(i + 1, -1)), c(rim(i + 1, 1)), d(rim(i, 1));
            const Corners side = quad_corners(a, b, c, d);
            corners.insert(corners.end(), side.begin(), side.end());
            for (const glm::vec3& corner : {glm::vec3(0, 0, 1), d, c, glm::vec3(0, 0, -1), b, a}) {
                corners.push_back(corner);
            }
        }
        const SurfacePointer surface = surface_of({corners});
        for (const Projection projection : {Projection::parallel, Projection::perspective}) {
            const Viewpoint view = exact_view({0, 0, 1}, projection);
            std::vector<Stroke3> strokes;
            for (int i = 0; i < sides; ++i) {
                strokes.push_back(
                    {in_scene(*surface, rim(i, 1)), in_scene(*surface, rim(i + 1, 1)), LineClass::contour});
            }
            expect_drawn(surface, view, {strokes}, fmt::format("{} sides", sides));
        }
    }
}

// All of a flat plate lies on one line of the picture.
TEST(NonGeneric, APlateEdgeOn) {
    const SurfacePointer surface =
        surface_of({quad_corners({-1, 0, 0.5f}, {1, 0, 0.5f}, {1, 0, -0.5f}, {-1, 0, -0.5f})});
    for (const Projection projection : {Projection::parallel, Projection::perspective}) {
        const Viewpoint view = exact_view({0, 0, 1}, projection);
        const std::vector<Stroke3> strokes{{in_scene(*surface, {-1, 0, 0.5}), in_scene(*surface, {1, 0, 0.5})}};
        // That the farther rim lies behind the nearer one is within rounding: it may be seen too.
        expect_drawn(surface, view, {strokes, {.depth = false, .line_class = false}, Doubles::allowed}, "plate");
    }
}

// A body that stands in the file twice or three times looks as if it stood there once.
TEST(NonGeneric, DuplicatedBodies) {
    struct Body {
        const char* name;
        Corners corners;
    };
    const std::vector<Body> bodies{{"cube", Box3{}.corners()},
                                   {"sphere", sphere_corners(3)},
                                   {"torus", torus(1, 0.4, 32, 16)},
                                   {"gear", gear(7, 0.4)},
                                   {"open sheet", wavy_sheet(12, 0.25, 1)}};
    for (const Body& body : bodies) {
        const Corners& one = body.corners;
        const SurfacePointer single = surface_of({one});
        for (const std::vector<Corners>& meshes :
             {std::vector<Corners>{one, one}, std::vector<Corners>{joined({one, one})},
              std::vector<Corners>{one, one, one}, std::vector<Corners>{one, inside_out(one)}}) {
            const SurfacePointer many = surface_of(meshes);
            for (const Way& way : ways) {
                for (std::uint64_t v = 0; v < static_cast<std::uint64_t>(fewer_if_slow(4)); ++v) {
                    const Viewpoint view = random_view(*single, 9, v);
                    const Drawing once = draw(single, view, visible_only(way.visibility));
                    const Drawing drawing = draw(many, view, visible_only(way.visibility));
                    std::string text;
                    EXPECT_LE(difference(view, drawing, once, text, {.line_class = false}), 1e-3 * length_of(once))
                        << body.name << ", " << way.name << ", view " << v << ", " << meshes.size()
                        << " meshes; first: of the many, second: of the one\n"
                        << text;
                    std::string twice;
                    EXPECT_LE(doubled_ink(view, drawing, twice), doubled_ink(view, once, twice))
                        << body.name << ", " << way.name << ", view " << v << "\n"
                        << twice;
                }
            }
        }
    }
}

// Plates that are cut differently on both sides of a seam: edges of one side meet the middle of the other's.
TEST(NonGeneric, AMeshWithTJunctions) {
    const Corners halves = joined({quad_corners({-1, -1, 0}, {0, -1, 0}, {0, 1, 0}, {-1, 1, 0}),
                                   quad_corners({0, -1, 0}, {1, -1, 0}, {1, 0, 0}, {0, 0, 0}),
                                   quad_corners({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0})});
    const SurfacePointer surface = surface_of({halves});
    for (const glm::ivec3& direction : {glm::ivec3(0, 0, 1), glm::ivec3(2, 3, 5), glm::ivec3(-1, 0, 1)}) {
        const Viewpoint view = exact_view(direction, Projection::parallel);
        std::vector<Stroke3> strokes;
        const auto add = [&](const glm::dvec2& a, const glm::dvec2& b) {
            strokes.push_back({in_scene(*surface, {a, 0}), in_scene(*surface, {b, 0})});
        };
        add({-1, -1}, {1, -1});
        add({1, -1}, {1, 1});
        add({1, 1}, {-1, 1});
        add({-1, 1}, {-1, -1});
        add({0, -1}, {0, 1});  // the seam is a border on both sides
        expect_drawn(surface, view, {strokes, {.line_class = false}, Doubles::allowed},
                     fmt::format("from {} {} {}", direction.x, direction.y, direction.z));
    }
}

}  // namespace
}  // namespace croquis::lines
