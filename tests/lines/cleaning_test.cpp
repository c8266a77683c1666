// What cleaning may do and what not: it moves no line, loses nothing long and no real step in depth, keeps corners, and
// takes away the crumbs of a rough surface.
#include "lines/cleaning.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "lines/drafter.h"
#include "truth/ink.h"
#include "truth/solids.h"
#include "truth/threads.h"
#include "truth/views.h"

namespace croquis::lines {
namespace {

using namespace truth;
using test_support::box_corners;

constexpr double pi = 3.14159265358979323846;

struct Subject {
    const char* name;
    std::vector<Corners> meshes;
};

/// Views to look at: one where code runs slowly.
std::uint64_t few(int count) { return static_cast<std::uint64_t>(fewer_if_slow(count)); }
/// Spheres there have a quarter of the faces.
int fine(int subdivisions) { return few(25) < 25 ? subdivisions - 1 : subdivisions; }

std::vector<Subject> subjects() {
    return {{"noisy sphere", {bumpy_sphere(fine(5), 0.05, 0.006, 1)}},
            {"noisy lump", {bumpy_sphere(fine(5), 0.25, 0.004, 2)}},
            {"torus", {torus(1, 0.4, 64, 32)}},
            {"knot", {torus_knot(2, 3, 0.45, 200, 20)}},
            {"gear", {gear(9, 0.4)}},
            {"boxes", {box_corners({-1, -1, -1}, {0, 1, 1}), box_corners({0.3f, -0.7f, -0.2f}, {0.8f, 0.4f, 0.6f})}}};
}

struct Pair {
    Drawing exact, clean;
};

Pair draw_both(const SurfacePointer& surface, const Viewpoint& view) {
    Options options;
    options.clean = false;
    Pair pair;
    pair.exact = draw(surface, view, options);
    options.clean = true;
    pair.clean = draw(surface, view, options);
    return pair;
}

double distance_to(const glm::dvec2& point, const glm::dvec2& a, const glm::dvec2& b) {
    const glm::dvec2 along = b - a;
    const double squared = glm::dot(along, along);
    const double share = squared > 0 ? std::clamp(glm::dot(point - a, along) / squared, 0.0, 1.0) : 0.0;
    return glm::distance(point, a + share * along);
}

template <typename Use>
void for_each_segment(const Drawing& drawing, const Line& line, const Use& use) {
    const auto points = drawing.points_of(line);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) use(points[i].position, points[i + 1].position);
    if (line.closed && points.size() > 1) use(points.back().position, points.front().position);
}

/// Distances from points along a line, a pixel apart, to the nearest piece of other lines.
template <typename Wanted>
std::vector<double> distances(const Drawing& from, const Line& line, const Drawing& to, const Wanted& wanted) {
    std::vector<double> found;
    for_each_segment(from, line, [&](const glm::dvec2& a, const glm::dvec2& b) {
        const int count = 1 + static_cast<int>(glm::distance(a, b));
        for (int i = 0; i < count; ++i) {
            const glm::dvec2 point = a + (b - a) * ((i + 0.5) / count);
            double nearest = 1e300;
            for (const Line& other : to.lines) {
                if (!wanted(other)) continue;
                for_each_segment(to, other, [&](const glm::dvec2& c, const glm::dvec2& d) {
                    nearest = std::min(nearest, distance_to(point, c, d));
                });
            }
            found.push_back(nearest);
        }
    });
    return found;
}

constexpr auto any_line = [](const Line&) { return true; };

// Smoothing alone, line by line: half a pixel for the zigzags, and the detail of the points left out.
TEST(Cleaning, SmoothingMovesNothingFar) {
    for (const Subject& subject : subjects()) {
        const SurfacePointer surface = surface_of(subject.meshes);
        for (std::uint64_t v = 0; v < few(3); ++v) {
            Options options;
            options.clean = false;
            const Drawing exact = draw(surface, random_view(*surface, 41, v), options);
            const CleaningLimits limits(std::min(exact.width, exact.height));
            const Drawing smooth = smoothed(exact, limits);
            ASSERT_EQ(smooth.lines.size(), exact.lines.size());
            double farthest = 0;
            for (std::size_t l = 0; l < exact.lines.size(); ++l) {
                const auto same = [&](const Drawing& drawing) {
                    return [&drawing, l](const Line& line) { return &line == &drawing.lines[l]; };
                };
                for (const double d : distances(smooth, smooth.lines[l], exact, same(exact))) {
                    farthest = std::max(farthest, d);
                }
                for (const double d : distances(exact, exact.lines[l], smooth, same(smooth))) {
                    farthest = std::max(farthest, d);
                }
                EXPECT_EQ(smooth.lines[l].closed, exact.lines[l].closed);
                if (exact.lines[l].closed) continue;
                EXPECT_EQ(smooth.points_of(smooth.lines[l]).front().position,
                          exact.points_of(exact.lines[l]).front().position);
                EXPECT_EQ(smooth.points_of(smooth.lines[l]).back().position,
                          exact.points_of(exact.lines[l]).back().position);
            }
            EXPECT_LE(farthest, 0.5 + 0.12 + 1e-9) << subject.name << ", view " << v;
            EXPECT_LE(smooth.points.size(), exact.points.size());
        }
    }
}

// The whole of it: where lines are joined they may cross a gap of three pixels, nowhere else do they leave an edge.
TEST(Cleaning, DrawsOnlyWhereEdgesAre) {
    for (const Subject& subject : subjects()) {
        const SurfacePointer surface = surface_of(subject.meshes);
        for (std::uint64_t v = 0; v < few(3); ++v) {
            const Viewpoint view = random_view(*surface, 42, v);
            const Drawing clean = draw(surface, view, Options{});
            const Drawing all = draw(surface, view, exact_options());
            std::size_t samples = 0, apart = 0;
            double farthest = 0;
            for (const Line& line : clean.lines) {
                for (const double d : distances(clean, line, all, any_line)) {
                    farthest = std::max(farthest, d);
                    ++samples;
                    apart += d > 0.5 + 0.12 + 1e-9 ? 1 : 0;
                }
            }
            EXPECT_LE(farthest, 0.5 * 3 + 0.5 + 0.12) << subject.name << ", view " << v;
            EXPECT_LE(static_cast<double>(apart), 0.01 * static_cast<double>(samples))
                << subject.name << ", view " << v;
        }
    }
}

TEST(Cleaning, KeepsLongLines) {
    for (const Subject& subject : subjects()) {
        const SurfacePointer surface = surface_of(subject.meshes);
        std::size_t samples = 0, lost = 0;
        for (std::uint64_t v = 0; v < few(4); ++v) {
            const Pair pair = draw_both(surface, random_view(*surface, 43, v));
            for (const Line& line : pair.exact.lines) {
                if (lines::length_of(pair.exact, line) < 48) continue;
                const auto same_class = [&](const Line& other) { return other.line_class == line.line_class; };
                for (const double d : distances(pair.exact, line, pair.clean, same_class)) {
                    ++samples;
                    lost += d > 1.2 ? 1 : 0;
                }
            }
        }
        EXPECT_GT(samples, 0u) << subject.name;
        EXPECT_LE(static_cast<double>(lost), 0.03 * static_cast<double>(samples)) << subject.name;
    }
}

TEST(Cleaning, TakesTheCrumbsOfANoisySphere) {
    const SurfacePointer surface = surface_of({bumpy_sphere(fine(6), 0, 0.003, 1)});
    for (const glm::dvec3& direction : {glm::dvec3(1, 0.7, 1), glm::dvec3(-0.3, 0.2, -1)}) {
        const Viewpoint view = view_from(*surface, direction);
        const Pair pair = draw_both(surface, view);
        EXPECT_GE(pair.exact.lines.size(), 3 * pair.clean.lines.size()) << pair.exact.lines.size();
        const auto crumbs_of = [](const Drawing& drawing) {
            return std::count_if(drawing.lines.begin(), drawing.lines.end(),
                                 [&](const Line& line) { return lines::length_of(drawing, line) < 12; });
        };
        EXPECT_GE(crumbs_of(pair.exact), 20 * crumbs_of(pair.clean)) << crumbs_of(pair.exact);
        // What is left is the sphere's outline all around.
        const glm::dvec2 middle(0.5 * view.width, 0.5 * view.height);
        std::vector<bool> seen(120, false);
        for (const Line& line : pair.clean.lines) {
            for_each_segment(pair.clean, line, [&](const glm::dvec2& a, const glm::dvec2& b) {
                for (double t = 0; t <= 1; t += 0.1) {
                    const glm::dvec2 offset = a + (b - a) * t - middle;
                    if (glm::length(offset) < 0.43 * view.height) continue;
                    const double turn = (std::atan2(offset.y, offset.x) + pi) / (2 * pi);
                    seen[std::min<std::size_t>(119, static_cast<std::size_t>(120 * turn))] = true;
                }
            });
        }
        EXPECT_GE(std::count(seen.begin(), seen.end(), true), 118);
    }
}

/// A prism over a regular polygon, and its corners.
struct Prism {
    int sides;

    [[nodiscard]] glm::dvec3 corner(int i, double y) const {
        const double angle = 2 * pi * (i % sides) / sides + 0.2;
        return glm::dvec3(glm::vec3(glm::dvec3(std::cos(angle), y, std::sin(angle))));
    }
    [[nodiscard]] Corners corners() const {
        Corners corners;
        for (int i = 0; i < sides; ++i) {
            const glm::dvec3 a = corner(i, -1), b = corner(i + 1, -1), c = corner(i + 1, 1), d = corner(i, 1);
            for (const glm::dvec3& p : {b, a, d, b, d, c, glm::dvec3(0, 1, 0), c, d, glm::dvec3(0, -1, 0), a, b}) {
                corners.emplace_back(p);
            }
        }
        return corners;
    }
};

// Also with the obtuse angles of a cube seen from a corner, and the shallow ones of a prism with many sides.
TEST(Cleaning, CornersStayWhereTheyAre) {
    for (const int sides : {4, 6, 12}) {
        const Prism prism{sides};
        const SurfacePointer surface = surface_of({prism.corners()});
        for (int v = 0; v < 24; ++v) {
            const glm::dvec3 direction(std::cos(2.4 * v), 0.13 * (v - 11.5), std::sin(2.4 * v));
            const Viewpoint view = view_from(*surface, direction);
            const Pair pair = draw_both(surface, view);
            SCOPED_TRACE(fmt::format("{} sides, view {}", sides, v));
            double farthest = 0;
            for (const LinePoint& corner : pair.exact.points) {
                double nearest = 1e300;
                for (const LinePoint& point : pair.clean.points) {
                    nearest = std::min(nearest, glm::distance(corner.position, point.position));
                }
                farthest = std::max(farthest, nearest);
            }
            // A corner that tells less than the detail may be left out.
            EXPECT_LT(farthest, sides == 12 ? 12.0 : 1e-9) << text_of(pair.clean);
            // And those points are the prism's corners.
            for (const LinePoint& point : pair.clean.points) {
                double nearest = 1e300;
                for (int i = 0; i < sides; ++i) {
                    for (const double y : {-1.0, 1.0}) {
                        const glm::dvec2 place = view.project(in_scene(*surface, prism.corner(i, y))).position;
                        nearest = std::min(nearest, glm::distance(place, point.position));
                    }
                }
                EXPECT_LT(nearest, 1e-5) << fmt::format("({:.3f}, {:.3f})", point.position.x, point.position.y);
            }
        }
    }
}

// A small plate far in front of a wall, or beside nothing: each of its edges is a real step in depth.
TEST(Cleaning, DropsNoRealStepInDepth) {
    const Corners wall = box_corners({-2, -1.5f, -1}, {2, 1.5f, -0.9f});
    const Corners frame = box_corners({-2, -1.5f, 1}, {-1.9f, -1.4f, 1.1f});  // keeps the scene's depth the same
    for (const double pixels : {14.0, 20.0, 32.0, 60.0}) {
        for (const double shape : {1.0, 0.3}) {
            // Scene units are fixed by the wall and the frame; the plate floats half a unit before the wall.
            const SurfacePointer empty = surface_of({wall, frame});
            const Viewpoint view = view_from(*empty, {0, 0, 1}, {model::Projection::parallel});
            const double unit = model::SceneSpace::of(empty->model()).radius / view.scale;  // of the file, a pixel
            const float half = static_cast<float>(0.5 * pixels * unit), low = static_cast<float>(shape) * half;
            const Corners plate = turned(box_corners({-half, -low, 0}, {half, low, 0.01f}), {0, 0, 1}, 0.3);
            const SurfacePointer surface = surface_of({wall, frame, plate});
            const Drawing drawing = draw(surface, view, Options{});
            double length = 0;
            for (const Line& line : drawing.lines) {
                if (line.mesh == 2 && line.line_class == LineClass::silhouette) {
                    length += lines::length_of(drawing, line);
                }
            }
            const double outline = 2 * pixels * (1 + shape);
            EXPECT_GT(length, outline - 4) << pixels << " px long, " << shape << "\n" << text_of(drawing);
            EXPECT_LT(length, outline + 1) << pixels << " px long, " << shape << "\n" << text_of(drawing);
        }
    }
}

// A ball before a wall is one closed curve of a real step, however small.
TEST(Cleaning, KeepsSmallBallsBeforeAWall) {
    std::vector<Corners> meshes{box_corners({-2, -1.5f, -1}, {2, 1.5f, -0.9f})};
    constexpr int balls = 6;
    for (int i = 0; i < balls; ++i)
        meshes.push_back(moved(sphere_corners(3), {0.6 * i - 1.5, 0.1 * i, 0}, 0.02 + 0.015 * i));
    const SurfacePointer surface = surface_of(meshes);
    const Viewpoint view = view_from(*surface, {0.1, 0.2, 1});
    const Drawing drawing = draw(surface, view, Options{});
    for (std::uint32_t i = 1; i <= balls; ++i) {
        const auto found = std::count_if(drawing.lines.begin(), drawing.lines.end(), [&](const Line& line) {
            return line.mesh == i && line.closed && line.line_class == LineClass::silhouette;
        });
        EXPECT_EQ(found, 1) << "ball " << i;
    }
}

TEST(Cleaning, DoesNotDependOnTheNumberOfThreads) {
    for (const Subject& subject : subjects()) {
        const SurfacePointer surface = surface_of(subject.meshes);
        const Viewpoint view = random_view(*surface, 44, 0);
        const auto drawing = [&](int threads) {
            return on_threads(threads, [&] { return draw(surface, view, Options{}); });
        };
        const Drawing alone = drawing(1), together = drawing(6);
        ASSERT_EQ(alone.lines.size(), together.lines.size()) << subject.name;
        ASSERT_EQ(alone.points.size(), together.points.size()) << subject.name;
        for (std::size_t i = 0; i < alone.points.size(); ++i) {
            ASSERT_EQ(alone.points[i].position, together.points[i].position) << subject.name << ", point " << i;
            ASSERT_EQ(alone.points[i].depth, together.points[i].depth) << subject.name << ", point " << i;
        }
    }
}

// A drawing that is clean stays as it is, but for points that tell next to nothing: boxes and gears have neither crumbs
// nor zigzags.
TEST(Cleaning, LeavesPlainDrawingsAlone) {
    for (const Subject& subject : subjects()) {
        if (std::string(subject.name) != "gear" && std::string(subject.name) != "boxes") continue;
        const SurfacePointer surface = surface_of(subject.meshes);
        for (std::uint64_t v = 0; v < few(6); ++v) {
            const Pair pair = draw_both(surface, random_view(*surface, 45, v));
            double moved_most = 0, lost = 0;
            for (const Line& line : pair.clean.lines) {
                for (const double d : distances(pair.clean, line, pair.exact, any_line)) {
                    moved_most = std::max(moved_most, d);
                }
            }
            for (const Line& line : pair.exact.lines) {
                for (const double d : distances(pair.exact, line, pair.clean, any_line)) lost += d > 0.13 ? 1 : 0;
            }
            EXPECT_LE(moved_most, 0.13) << subject.name << ", view " << v;
            EXPECT_LE(lost, 0.005 * length_of(pair.exact)) << subject.name << ", view " << v;
        }
    }
}

}  // namespace
}  // namespace croquis::lines
