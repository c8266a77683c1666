// Layers by walking against layers by brute force, at points of every edge of many models, from many sides.
#include "lines/walk_probe.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/random.h"
#include "lines/silhouette_finder.h"
#include "truth/solids.h"
#include "truth/view_truth.h"
#include "truth/views.h"

namespace croquis::lines {
namespace {

using namespace truth;
using Meshes = std::vector<Corners>;

/// A view and its edges; those that bend by more than an angle are lines.
struct Scene {
    Scene(const Surface& of, const Viewpoint& seen_from, double least_bend)
        : surface(of), view(seen_from), edges(of), silhouettes(make_finder("exhaustive", of)->find(view)) {
        LineClasses classes = Options{}.classes;
        classes.remove(LineClass::intersection);  // lies on no edge to walk from
        edges.gather(view, Features(of, classes, least_bend), silhouettes, classes);
        walker.emplace(of, view, edges, silhouettes);
    }

    const Surface& surface;
    Viewpoint view;
    ImageEdges edges;
    std::vector<std::uint32_t> silhouettes;
    std::optional<Walker> walker;
};

/// Makes a line of each edge that bends at all, so that there are points everywhere on the surface.
constexpr double any_bend = 1e-9;
constexpr double no_bend = 3;

struct Comparison {
    std::size_t points = 0, hidden = 0, deep = 0, skipped = 0, wrong = 0;
    std::string example;
};

/// Asks at points of edges chosen at random.
Comparison compare(const Scene& scene, const SurfaceTruth& surface_truth, int points, std::uint64_t seed) {
    const ViewTruth truth(surface_truth, scene.view);
    std::vector<const SeenEdge*> seen_of(surface_truth.edges().size(), nullptr);
    for (const SeenEdge& seen : truth.edges()) seen_of[seen.known] = &seen;
    const WalkProbe probe(*scene.walker, scene.surface, scene.edges, scene.view, 0.0);
    const Random random(seed, "points");
    Comparison found;
    const std::size_t count = scene.edges.edges().size();
    for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(points) && count > 0; ++i) {
        const auto which = static_cast<std::size_t>(random.unit(2 * i) * static_cast<double>(count));
        const ImageEdge& edge = scene.edges.edges()[which];
        const double share = random.between(0.05, 0.95, 2 * i + 1);
        const SeenEdge* seen = seen_of[edge.edge];
        if (seen == nullptr) continue;
        const Sight sight = truth.sight(*seen, scene.edges.point_at(edge, share));
        ++found.points;
        if (!sight.certain) {
            ++found.skipped;
            continue;
        }
        found.hidden += sight.layers > 0 ? 1 : 0;
        found.deep += sight.layers > 2 ? 1 : 0;
        const std::uint32_t layers = probe.layers(edge, share, 0xffffffffu);
        const std::uint32_t any = probe.layers(edge, share, 1);
        if (layers == sight.layers && any == std::min(layers, 1u)) continue;
        ++found.wrong;
        found.example =
            fmt::format("edge {} at {}: {} layers, found {} and {}", edge.edge, share, sight.layers, layers, any);
    }
    return found;
}

struct Family {
    const char* name;
    int views;
    Meshes (*meshes)();
};

std::string name_of(const ::testing::TestParamInfo<Family>& info) { return info.param.name; }

class WalkProbeOf : public ::testing::TestWithParam<Family> {};

TEST_P(WalkProbeOf, CountsAsBruteForceDoes) {
    const Family& family = GetParam();
    const SurfacePointer surface = surface_of(family.meshes());
    const SurfaceTruth surface_truth(surface, any_bend);
    Comparison sum;
    const int views = fewer_if_slow(family.views);
    for (int v = 0; v < views; ++v) {
        const Scene scene(*surface, random_view(*surface, 11, static_cast<std::uint64_t>(v)), any_bend);
        ASSERT_TRUE(Walker::serves(*surface, scene.view));
        const Comparison found = compare(scene, surface_truth, 250, static_cast<std::uint64_t>(v));
        EXPECT_EQ(found.wrong, 0u) << "view " << v << ": " << found.example;
        sum.points += found.points;
        sum.hidden += found.hidden;
        sum.deep += found.deep;
        sum.skipped += found.skipped;
    }
    EXPECT_GT(sum.points, 100u * static_cast<std::size_t>(views));
    EXPECT_LT(sum.skipped, sum.points / 50);
    EXPECT_GT(sum.hidden, sum.points / 20);
    RecordProperty("points", static_cast<int>(sum.points));
    RecordProperty("deep", static_cast<int>(sum.deep));
}

Meshes nested_spheres() {
    const Corners sphere = sphere_corners(3);
    return {sphere, moved(turned(sphere, {1, 2, 3}, 1), {0.1, 0, 0}, 0.7), inside_out(moved(sphere, {0, 0, 0.1}, 0.4)),
            moved(sphere_corners(2), {2, 0.3, 0.1}, 0.5)};
}

Meshes cut_spheres() {
    const auto keep = [](const glm::dvec3& p) { return p.y < 0.35 + 0.1 * p.x; };
    const Corners shell = cut(sphere_corners(4), keep);
    return {shell, turned(moved(shell, {0, 0, 0}, 0.6), {1, 0.2, 0.1}, 2)};
}

Corners lace() {
    return cut(sphere_corners(4),
               [](const glm::dvec3& p) { return std::sin(9 * p.x) * std::sin(9 * p.y) * std::sin(9 * p.z) > -0.2; });
}

/// Pages on one back: an edge of many faces; one page is wound the other way.
Corners book() {
    Corners all;
    for (int page = 0; page < 5; ++page) {
        const auto at = [&](double u, double v) {
            const double turn = 0.4 * page + 0.5 * u * u;
            return glm::dvec3(u * std::cos(turn), u * std::sin(turn), 1.5 * (v - 0.5));
        };
        Corners leaf = grid_of({8, 6}, at);
        if (page == 2) leaf = inside_out(leaf);
        all.insert(all.end(), leaf.begin(), leaf.end());
    }
    return all;
}

/// Two sheets through each other along a row of edges of four faces each.
Corners crossed_sheets() {
    const auto at = [](double u, double v) {
        const double x = 2 * u - 1;
        return glm::dvec3(x, 0.5 * (x - x * x * x), 2 * v - 1);
    };
    const Corners sheet = grid_of({16, 8}, at);
    return joined({sheet, shaped(sheet, [](const glm::dvec3& p) { return glm::dvec3(-p.y, p.x, p.z); })});
}

INSTANTIATE_TEST_SUITE_P(
    Closed, WalkProbeOf,
    ::testing::Values(Family{"sphere", 12, [] { return Meshes{sphere_corners(4)}; }},
                      Family{"waves", 12, [] { return Meshes{bumpy_sphere(4, 0.25, 0, 1)}; }},
                      Family{"noise", 12, [] { return Meshes{bumpy_sphere(4, 0.1, 0.03, 2)}; }},
                      Family{"torus", 16, [] { return Meshes{torus(1, 0.4, 48, 24)}; }},
                      Family{"knot", 16, [] { return Meshes{torus_knot(2, 3, 0.45, 160, 16)}; }},
                      Family{"tight_knot", 12, [] { return Meshes{torus_knot(3, 5, 0.25, 260, 12)}; }},
                      Family{"gear", 16, [] { return Meshes{gear(9, 0.4)}; }}, Family{"nested", 16, nested_spheres}),
    name_of);

INSTANTIATE_TEST_SUITE_P(Open, WalkProbeOf,
                         ::testing::Values(Family{"cut_spheres", 16, cut_spheres},
                                           Family{"sheet", 16, [] { return Meshes{wavy_sheet(40, 0.25, 1)}; }},
                                           Family{"lace", 12, [] { return Meshes{lace()}; }},
                                           Family{"soup", 12, [] { return Meshes{soup(600, 0.3, 5)}; }}),
                         name_of);

INSTANTIATE_TEST_SUITE_P(CrowdedEdges, WalkProbeOf,
                         ::testing::Values(Family{"book", 24, [] { return Meshes{book()}; }},
                                           Family{"crossed_sheets", 24, [] { return Meshes{crossed_sheets()}; }}),
                         name_of);

// D: a walk passes as many faces as a line over the surface, so some square root of their number. All three spheres are
// asked at the same points of the picture.
TEST(Walker, PassesFacesLikeALineDoes) {
    const int largest = fewer_if_slow(25) > 1 ? 7 : 6;
    std::vector<double> faces_walked;
    for (int subdivisions = largest - 2; subdivisions <= largest; ++subdivisions) {
        const SurfacePointer surface = surface_of({sphere_corners(subdivisions)});
        const Viewpoint view = view_from(*surface, {0.3, 0.5, 1});
        const Scene scene(*surface, view, no_bend);
        const Random random(3, "points");
        const double radius = 0.4 * std::min(view.width, view.height);
        std::uint64_t faces = 0;
        for (std::uint64_t i = 0; i < 200; ++i) {
            const double turn = 6.283185307179586 * random.unit(2 * i),
                         away = radius * std::sqrt(random.unit(2 * i + 1));
            Walker::Aim aim;
            aim.position =
                glm::dvec2(view.width, view.height) / 2.0 + away * glm::dvec2(std::cos(turn), std::sin(turn));
            const Walker::Walk walk = scene.walker->walk(aim);
            EXPECT_EQ(walk.layers, 2u);
            faces += walk.faces;
        }
        faces_walked.push_back(static_cast<double>(faces));
    }
    const double growth = std::log(faces_walked.back() / faces_walked.front()) / std::log(16.0);
    EXPECT_LT(growth, 0.6);
    EXPECT_LT(faces_walked.back() / 200, 2.5 * std::sqrt(20.0 * std::pow(4.0, largest)));
}

TEST(Walker, LeavesViewsFromAmongTheSurfaceToOthers) {
    const SurfacePointer surface = surface_of({sphere_corners(3)});
    EXPECT_TRUE(Walker::serves(*surface, view_at({0, 0, 3}, {0, 0, -1})));
    EXPECT_FALSE(Walker::serves(*surface, view_at({0, 0, 0}, {0, 0, -1})));
    EXPECT_FALSE(Walker::serves(*surface, view_at({0, 0, 3}, {0, 0, 1})));
    ViewOptions options;
    options.projection = model::Projection::parallel;
    EXPECT_TRUE(Walker::serves(*surface, view_from(*surface, {1, 2, 3}, options)));
}

// Edges that line up in the picture, from the front and along the axes; what lies outside of the frame counts too.
TEST(Walker, CountsBoxesSeenEndOn) {
    const Corners box = test_support::box_corners({-1, -1, -1}, {1, 1, 1});
    const SurfacePointer surface = surface_of({box, moved(box, {0, 0, 4}), moved(box, {0, 0, 8}, 0.5)});
    for (const auto projection : {model::Projection::perspective, model::Projection::parallel}) {
        for (const double zoom : {1.0, 30.0}) {
            ViewOptions options;
            options.projection = projection;
            options.zoom = zoom;
            const Viewpoint view = view_from(*surface, {0, 0, 1}, options);
            const Scene scene(*surface, view, no_bend);
            Walker::Aim aim;
            aim.position = glm::dvec2(view.width, view.height) / 2.0 + glm::dvec2(0.25, 0.125);
            EXPECT_EQ(scene.walker->walk(aim).layers, 6u);
            aim.eye_distance = view.eye_distance(glm::dvec3(0.0));
            EXPECT_EQ(scene.walker->walk(aim).layers, 3u);
            aim.at_most = 2;
            EXPECT_EQ(scene.walker->walk(aim).layers, 2u);
        }
    }
}

}  // namespace
}  // namespace croquis::lines
