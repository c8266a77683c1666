// Curves in which faces pass through each other, against closed forms and against every pair of faces in long double.
#include "lines/cut_curves.h"

#include <gtest/gtest.h>

#include <tbb/global_control.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "truth/solids.h"
#include "truth/views.h"

namespace croquis::lines {
namespace {

using namespace truth;

using FaceNumbers = std::array<std::uint32_t, 2>;

constexpr double rounding = 1e-6;  // of single precision coordinates, in scene units

double length_of(const CutCurves& curves) {
    double sum = 0;
    for (const CutSegment& segment : curves.segments) {
        sum += glm::distance(curves.nodes[segment.nodes[0]].point, curves.nodes[segment.nodes[1]].point);
    }
    return sum;
}

std::vector<std::size_t> segments_at_nodes(const CutCurves& curves) {
    std::vector<std::size_t> counts(curves.nodes.size(), 0);
    for (const CutSegment& segment : curves.segments) {
        for (const std::uint32_t node : segment.nodes) ++counts[node];
    }
    return counts;
}

bool is_closed(const CutCurves& curves) {
    const std::vector<std::size_t> counts = segments_at_nodes(curves);
    return !counts.empty() && std::all_of(counts.begin(), counts.end(), [](std::size_t count) { return count == 2; });
}

std::size_t loose_ends(const CutCurves& curves) {
    const std::vector<std::size_t> counts = segments_at_nodes(curves);
    return std::size_t(std::count(counts.begin(), counts.end(), std::size_t{1}));
}

// Pieces that no node connects.
std::size_t component_count(const CutCurves& curves) {
    std::vector<std::uint32_t> parents(curves.nodes.size());
    for (std::uint32_t n = 0; n < parents.size(); ++n) parents[n] = n;
    const auto root = [&](std::uint32_t n) {
        while (parents[n] != n) n = parents[n];
        return n;
    };
    for (const CutSegment& segment : curves.segments) parents[root(segment.nodes[0])] = root(segment.nodes[1]);
    std::size_t count = 0;
    for (std::uint32_t n = 0; n < parents.size(); ++n) count += parents[n] == n;
    return count;
}

double distance_to_plane(const Surface& surface, std::uint32_t face, const glm::dvec3& point) {
    const auto& [a, b, c] = surface.topology().faces[face].vertices;
    const glm::dvec3 corner = surface.point(a);
    const glm::dvec3 normal = glm::normalize(glm::cross(surface.point(b) - corner, surface.point(c) - corner));
    return std::abs(glm::dot(normal, point - corner));
}

void expect_nodes_on_edges_and_faces(const Surface& surface, const CutCurves& curves) {
    for (const CutNode& node : curves.nodes) {
        const auto& [a, b] = surface.topology().edges[node.edge].vertices;
        const glm::dvec3 from = surface.point(a), along = surface.point(b) - from;
        EXPECT_LT(glm::length(glm::cross(node.point - from, along)) / glm::length(along), rounding);
        if (node.face == model::no_face) continue;
        EXPECT_LT(distance_to_plane(surface, node.face, node.point), rounding);
    }
    for (const CutSegment& segment : curves.segments) {
        EXPECT_LT(segment.faces[0], segment.faces[1]);
        for (const std::uint32_t face : segment.faces) {
            for (const std::uint32_t node : segment.nodes) {
                EXPECT_LT(distance_to_plane(surface, face, curves.nodes[node].point), rounding);
            }
        }
    }
}

CutCurves curves_of(const std::vector<Corners>& meshes) {
    const SurfacePointer surface = surface_of(meshes);
    CutCurves curves = find_cut_curves(*surface);
    expect_nodes_on_edges_and_faces(*surface, curves);
    return curves;
}

double per_unit(const std::vector<Corners>& meshes) {
    glm::vec3 low(1e30f), high(-1e30f);
    for (const glm::vec3& corner : joined(meshes)) low = glm::min(low, corner), high = glm::max(high, corner);
    return 2.0 / glm::length(high - low);
}

Corners box(const glm::vec3& low, const glm::vec3& high) { return test_support::box_corners(low, high); }

Corners board(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d) {
    return test_support::quad_corners(a, b, c, d);
}

// Both turned the same odd way, so that no coordinate is exact.
std::vector<Corners> at_odd_angles(std::vector<Corners> meshes) {
    for (Corners& mesh : meshes) mesh = turned(mesh, {0.3, 1.0, -0.6}, 0.77);
    return meshes;
}

std::vector<Corners> as_they_are(std::vector<Corners> meshes) { return meshes; }

TEST(CutCurves, TwoSpheresMeetInACircle) {
    const std::vector<Corners> meshes =
        at_odd_angles({sphere_corners(5), moved(turned(sphere_corners(5), {1, 2, 3}, 0.4), {1.2, 0, 0})});
    const CutCurves curves = curves_of(meshes);
    EXPECT_TRUE(is_closed(curves));
    EXPECT_EQ(component_count(curves), 1u);
    const double radius = 0.8 * per_unit(meshes);  // 0.6 from both centres
    for (const CutNode& node : curves.nodes) EXPECT_NEAR(glm::length(node.point), radius, 2e-3 * radius);
    EXPECT_NEAR(length_of(curves), 2 * std::numbers::pi * radius, 1e-2 * radius);
}

TEST(CutCurves, BoxThroughBoxGivesTwoRectangles) {
    for (const auto& place : {as_they_are, at_odd_angles}) {
        const std::vector<Corners> meshes = place({box({-1, -1, -1}, {1, 1, 1}), box({-2, -0.5, -0.3}, {2, 0.4, 0.6})});
        const CutCurves curves = curves_of(meshes);
        EXPECT_TRUE(is_closed(curves));
        EXPECT_EQ(component_count(curves), 2u);
        EXPECT_NEAR(length_of(curves), 2 * 2 * (0.9 + 0.9) * per_unit(meshes), 1e-5);
    }
}

TEST(CutCurves, CylinderThroughAPlate) {
    const int sides = 24;
    const auto cylinder = [&](int rings) {
        return grid_of({.u_cells = sides, .v_cells = rings, .u_closed = true}, [](double u, double v) {
            const double angle = 2 * std::numbers::pi * u;
            return glm::dvec3(0.5 * std::cos(angle), 2 * v - 1, 0.5 * std::sin(angle));
        });
    };
    const Corners plate = board({-1, 0, -1}, {-1, 0, 1}, {1, 0, 1}, {1, 0, -1});
    for (const auto& place : {as_they_are, at_odd_angles}) {
        for (const int rings : {1, 2, 7}) {  // with two, vertices and edges of the cylinder lie in the plate
            const std::vector<Corners> meshes = place({cylinder(rings), plate});
            const CutCurves curves = curves_of(meshes);
            EXPECT_TRUE(is_closed(curves)) << rings;
            EXPECT_EQ(component_count(curves), 1u) << rings;
            const double polygon = 2 * sides * 0.5 * std::sin(std::numbers::pi / sides);
            EXPECT_NEAR(length_of(curves), polygon * per_unit(meshes), 1e-5) << rings;
        }
    }
}

TEST(CutCurves, ThreeBoardsCrossInPairs) {
    const std::vector<Corners> meshes = at_odd_angles({board({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}),
                                                       board({-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}),
                                                       board({0, -1, -1}, {0, 1, -1}, {0, 1, 1}, {0, -1, 1})});
    const CutCurves curves = curves_of(meshes);
    EXPECT_EQ(component_count(curves), 3u);
    EXPECT_EQ(loose_ends(curves), 6u);
    EXPECT_NEAR(length_of(curves), 3 * 2 * per_unit(meshes), 1e-5);
}

TEST(CutCurves, FacesThatShareACornerMayCut) {
    const std::vector<Corners> meshes = {{{0, 0, 0}, {2, -1, 0}, {2, 1, 0}}, {{0, 0, 0}, {1, 0, -1}, {1, 0, 1}}};
    const CutCurves curves = curves_of(meshes);
    ASSERT_EQ(curves.segments.size(), 1u);
    EXPECT_NEAR(length_of(curves), 1 * per_unit(meshes), 1e-6);
    EXPECT_EQ(std::count_if(curves.nodes.begin(), curves.nodes.end(),
                            [](const CutNode& node) { return node.face == model::no_face; }),
              1);
}

TEST(CutCurves, WhatDoesNotPassThroughGivesNothing) {
    EXPECT_TRUE(curves_of({torus_knot(2, 3, 0.15, 160, 12)}).segments.empty());
    EXPECT_TRUE(curves_of({gear(12, 0.4)}).segments.empty());
    EXPECT_TRUE(curves_of({bumpy_sphere(4, 0.2, 0.01, 3)}).segments.empty());
}

TEST(CutCurves, WhatTouchesGivesNothing) {
    const Corners cube = box({-0.5f, 0, -0.5f}, {0.5f, 1, 0.5f});
    const Corners table =
        grid_of({.u_cells = 30, .v_cells = 30}, [](double u, double v) { return glm::dvec3(4 * v - 2, 0, 4 * u - 2); });
    const Corners tip = {{0, 0, 0}, {1, 1, 0},   {0, 1, 1}, {0, 0, 0}, {0, 1, 1},   {-1, 1, -1},
                         {0, 0, 0}, {-1, 1, -1}, {1, 1, 0}, {1, 1, 0}, {-1, 1, -1}, {0, 1, 1}};
    const std::vector<std::pair<const char*, std::vector<Corners>>> cases = {
        {"a box on a table", {cube, table}},
        {"a box under a table", {moved(cube, {0, -1, 0}), table}},
        {"a box on a box", {cube, box({-0.3f, 1, -0.2f}, {0.9f, 2, 0.4f})}},
        {"boxes with walls on one edge", {cube, box({0.5f, 0.2f, 0.5f}, {1, 2, 1})}},
        {"a tip on a table", {tip, table}},
        {"a model twice", {sphere_corners(3), sphere_corners(3)}},
        {"a wall twice, cut differently",
         {board({-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}),
          board({-0.7f, 0, -1}, {1, 0, 0}, {0, 0, 1}, {-1, 0, 0})}},
        {"a board that ends on a board", {board({0, 0, -0.5f}, {0, 0, 0.5f}, {0, 1, 0.5f}, {0, 1, -0.5f}), table}},
    };
    for (const auto& [name, meshes] : cases) {
        EXPECT_TRUE(curves_of(meshes).segments.empty()) << name;
        EXPECT_TRUE(curves_of(at_odd_angles(meshes)).segments.empty()) << name << ", at odd angles";
    }
}

// The tops are flush, so two of the four walls' lines end there.
TEST(CutCurves, FlushTopsGiveNoLine) {
    for (const auto& place : {as_they_are, at_odd_angles}) {
        const std::vector<Corners> meshes = place({box({-1, -1, -1}, {1, 1, 1}), box({-2, 0, -0.3f}, {2, 1, 0.6f})});
        const CutCurves curves = curves_of(meshes);
        EXPECT_NEAR(length_of(curves), 2 * (0.9 + 1 + 1) * per_unit(meshes), 1e-5);
        EXPECT_EQ(component_count(curves), 2u);
        EXPECT_EQ(loose_ends(curves), 4u);
    }
}

// Segment through triangle by Cramer's rule, in long double; nothing of the code under test. Certain crossings stay
// clear of every limit.
struct Answer {
    bool is_crossing = false;
    bool is_certain = true;
};

using Wide = glm::tvec3<long double>;

Answer segment_through(const Wide& from, const Wide& to, const std::array<Wide, 3>& face) {
    const Wide u = face[1] - face[0], v = face[2] - face[0], ray = from - to, offset = from - face[0];
    const long double det = glm::dot(ray, glm::cross(u, v));
    if (det == 0) return {false, false};
    const long double share = glm::dot(offset, glm::cross(u, v)) / det;
    const long double x = glm::dot(ray, glm::cross(offset, v)) / det, y = glm::dot(ray, glm::cross(u, offset)) / det;
    long double least = 1;
    for (const long double limit : {share, 1 - share, x, y, 1 - x - y}) least = std::min(least, limit);
    return {least > 0, std::abs(least) > 1e-4L};
}

Answer faces_cross(const std::array<Wide, 3>& f, const std::array<Wide, 3>& g) {
    Answer answer;
    for (std::size_t i = 0; i < 3; ++i) {
        for (const auto& [edges, face] : {std::pair(&f, &g), std::pair(&g, &f)}) {
            const Answer one = segment_through((*edges)[i], (*edges)[(i + 1) % 3], *face);
            answer.is_crossing = answer.is_crossing || one.is_crossing;
            answer.is_certain = answer.is_certain && one.is_certain;
        }
    }
    return answer;
}

TEST(CutCurves, AgreeWithEveryPairOfFaces) {
    std::size_t crossings = 0, uncertain = 0, pairs = 0;
    for (std::uint64_t seed = 0; seed < std::uint64_t(fewer_if_slow(12)); ++seed) {
        const SurfacePointer surface = surface_of({soup(300, 0.3 + 0.1 * double(seed % 4), seed)});
        const CutCurves curves = find_cut_curves(*surface);
        std::set<FaceNumbers> found;
        for (const CutSegment& segment : curves.segments) found.insert(segment.faces);
        EXPECT_EQ(found.size(), curves.segments.size());
        std::vector<std::array<Wide, 3>> faces;
        for (const model::Face& face : surface->topology().faces) {
            auto& corners = faces.emplace_back();
            for (std::size_t i = 0; i < 3; ++i) corners[i] = Wide(surface->point(face.vertices[i]));
        }
        for (std::uint32_t f = 0; f < faces.size(); ++f) {
            for (std::uint32_t g = f + 1; g < faces.size(); ++g) {
                const Answer answer = faces_cross(faces[f], faces[g]);
                ++pairs;
                if (!answer.is_certain) ++uncertain;
                if (!answer.is_certain) continue;
                crossings += answer.is_crossing;
                ASSERT_EQ(found.count({f, g}), answer.is_crossing) << seed << ": faces " << f << " and " << g;
            }
        }
    }
    EXPECT_GT(crossings, 100u);
    EXPECT_LT(double(uncertain), 0.02 * double(pairs));
}

TEST(CutCurves, DoNotDependOnThreads) {
    const SurfacePointer surface = surface_of({soup(2000, 0.3, 5), sphere_corners(4)});
    const CutCurves many = find_cut_curves(*surface);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const CutCurves few = find_cut_curves(*surface);
    ASSERT_EQ(many.nodes.size(), few.nodes.size());
    ASSERT_EQ(many.segments.size(), few.segments.size());
    for (std::size_t i = 0; i < many.nodes.size(); ++i) EXPECT_EQ(many.nodes[i].point, few.nodes[i].point);
    for (std::size_t i = 0; i < many.segments.size(); ++i) {
        EXPECT_EQ(many.segments[i].faces, few.segments[i].faces);
        EXPECT_EQ(many.segments[i].nodes, few.segments[i].nodes);
    }
}

}  // namespace
}  // namespace croquis::lines
