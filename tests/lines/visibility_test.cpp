// Which parts of lines are seen: every drawn point and every point that must be drawn against a count of the layers in
// front of it, face by face, over many views of many kinds of models.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "lines/drafter.h"
#include "truth/agreement.h"
#include "truth/solids.h"
#include "truth/view_truth.h"
#include "truth/views.h"

namespace croquis::lines {
namespace {

using namespace truth;

struct Family {
    const char* name;
    int views;
    std::vector<Corners> (*meshes)();
    bool meets_itself = false;  ///< sheets pass through each other, which walks take not to be
};

std::string name_of(const ::testing::TestParamInfo<Family>& info) { return info.param.name; }

struct Way {
    const char* name;
    Visibility visibility;
    bool hidden;
};

constexpr Way ways[] = {
    {"quantitative, hidden lines too", Visibility::quantitative, true},
    {"quantitative", Visibility::quantitative, false},
    {"walking, hidden lines too", Visibility::walking, true},
    {"walking", Visibility::walking, false},
    {"ray casts, hidden lines too", Visibility::ray_cast, true},
    {"ray casts", Visibility::ray_cast, false},
    {"automatic, hidden lines too", Visibility::automatic, true},
    {"automatic", Visibility::automatic, false},
};

Options exact(const Way& way) {
    Options options;
    options.clean = false;
    options.visibility = way.visibility;
    options.hidden = way.hidden;
    return options;
}

class VisibilityOf : public ::testing::TestWithParam<Family> {};

TEST_P(VisibilityOf, AgreesWithBruteForce) {
    const Family& family = GetParam();
    const SurfacePointer surface = surface_of(family.meshes());
    const SurfaceTruth surface_truth(surface, Options{}.crease_angle);
    std::vector<Way> asked(std::begin(ways), std::end(ways));
    if (family.meets_itself) std::erase_if(asked, [](const Way& w) { return w.visibility == Visibility::walking; });
    std::vector<Drafter> drafters;
    for (const Way& way : asked) drafters.emplace_back(surface, exact(way));
    std::vector<Agreement> sums(drafters.size());
    const int views = fewer_if_slow(family.views);
    for (int v = 0; v < views; ++v) {
        const Viewpoint view = random_view(*surface, 7, static_cast<std::uint64_t>(v));
        const ViewTruth truth(surface_truth, view);
        for (std::size_t w = 0; w < drafters.size(); ++w) {
            const Drawing drawing = drafters[w].draw(view);
            Agreement agreement = compare(truth, drawing, asked[w].hidden, {6, static_cast<std::uint64_t>(v)});
            for (std::string& example : agreement.examples) example = fmt::format("view {}: {}", v, example);
            sums[w] += agreement;
        }
    }
    for (std::size_t w = 0; w < drafters.size(); ++w) {
        const Agreement& sum = sums[w];
        EXPECT_GT(sum.expected, 0.0);
        // Two samples may go astray however few views there are.
        EXPECT_LT(sum.skipped, 2e-3 * (sum.expected + sum.drawn) + 12.0) << asked[w].name;
        EXPECT_GE(sum.share() + 12.0 / sum.expected, 0.999)
            << family.name << ", " << asked[w].name << ": " << sum.summary();
        EXPECT_LT(sum.farthest, 1e-6) << asked[w].name;
    }
}

Corners cut_sphere() {
    return cut(sphere_corners(4), [](const glm::dvec3& p) { return p.y < 0.35 + 0.1 * p.x; });
}

Corners box(const glm::dvec3& middle, const glm::dvec3& half, const glm::dvec3& axis, double angle) {
    const Corners corners = test_support::box_corners(glm::vec3(-half), glm::vec3(half));
    return moved(turned(corners, axis, angle), middle);
}

// A head with holes, and the eyes in them.
std::vector<Corners> mask() {
    const Corners skull = cut(bumpy_sphere(4, 0.06, 0, 3), [](const glm::dvec3& p) {
        const bool in_eye = p.z > 0 && glm::length(glm::dvec2(std::abs(p.x) - 0.4, p.y - 0.2)) < 0.25;
        return !in_eye && p.y > -0.8;
    });
    const Corners eye = sphere_corners(3);
    return {skull, moved(eye, {-0.4, 0.2, 0.7}, 0.22), moved(eye, {0.4, 0.2, 0.7}, 0.22)};
}

std::vector<Corners> chain() {
    std::vector<Corners> rings;
    for (int i = 0; i < 4; ++i) {
        const Corners ring = torus(0.5, 0.12, 40, 18);
        rings.push_back(moved(turned(turned(ring, {1, 0, 0}, i * 1.3), {0, 0, 1}, 0.1 * i), {0.7 * i, 0.02 * i, 0}));
    }
    return rings;
}

std::vector<Corners> shell_with_ball() {
    return {cut(sphere_corners(4), [](const glm::dvec3& p) { return p.z < 0.5; }),
            moved(sphere_corners(3), {0.1, -0.05, 0.1}, 0.5), moved(sphere_corners(2), {0, 0.1, 1.2}, 0.2)};
}

std::vector<Corners> three_bodies() {
    return {joined({moved(gear(7, 0.5), {0, 0, 0.1}), moved(turned(gear(5, 0.3), {1, 2, 3}, 1), {0.3, 0.2, 1.5}),
                    moved(sphere_corners(3), {-0.5, 1.2, 0.4}, 0.6)})};
}

std::vector<Corners> two_spheres(int subdivisions) {
    const Corners sphere = sphere_corners(subdivisions);
    return {sphere, moved(turned(sphere, {1, 2, 3}, 1), {0.9, 0.3, 0.2}, 0.8)};
}

std::vector<Corners> three_boxes() {
    return {box({0, 0, 0}, {1, 0.6, 0.5}, {1, 2, 3}, 0.4), box({0.3, 0.2, 0.1}, {0.4, 1.2, 0.3}, {3, 1, 1}, 1.1),
            box({-0.2, 0.1, 0.3}, {0.3, 0.2, 1.4}, {0, 1, 1}, 0.3)};
}

std::vector<Corners> boards() {
    const auto board = [](float z) {
        return test_support::quad_corners({-1, -0.7f, z}, {1, -0.7f, -z}, {1, 0.7f, -z}, {-1, 0.7f, z});
    };
    return {turned(board(0.6f), {1, 1, 1}, 0.2), board(-0.5f)};
}

std::vector<Corners> two_tori() {
    const Corners one = torus(1, 0.3, 40, 16);
    return {one, moved(turned(one, {1, 0.3, 0.1}, 1.2), {0.2, 0.1, 0})};
}

Corners rough_sheet() {
    return shaped(wavy_sheet(30, 0.2, 2),
                  [](const glm::dvec3& p) { return p + glm::dvec3(0, 0, 0.05 * std::sin(91 * p.x + 57 * p.y)); });
}

Corners half_torus() {
    return cut(torus(1, 0.4, 48, 24), [](const glm::dvec3& p) { return p.x < 0.1; });
}

Corners lace() {
    return cut(sphere_corners(4),
               [](const glm::dvec3& p) { return std::sin(9 * p.x) * std::sin(9 * p.y) * std::sin(9 * p.z) > -0.2; });
}

using Meshes = std::vector<Corners>;

INSTANTIATE_TEST_SUITE_P(Closed, VisibilityOf,
                         ::testing::Values(Family{"sphere", 30, [] { return Meshes{sphere_corners(4)}; }},
                                           Family{"waves", 30, [] { return Meshes{bumpy_sphere(4, 0.25, 0, 1)}; }},
                                           Family{"noise", 12, [] { return Meshes{bumpy_sphere(4, 0.1, 0.02, 2)}; }},
                                           Family{"torus", 40, [] { return Meshes{torus(1, 0.4, 48, 24)}; }},
                                           Family{"knot", 30, [] { return Meshes{torus_knot(2, 3, 0.45, 160, 16)}; }},
                                           Family{"tight_knot", 20,
                                                  [] { return Meshes{torus_knot(3, 5, 0.25, 260, 12)}; }},
                                           Family{"gear", 40, [] { return Meshes{gear(9, 0.4)}; }}),
                         name_of);

INSTANTIATE_TEST_SUITE_P(Open, VisibilityOf,
                         ::testing::Values(Family{"cut_sphere", 40, [] { return Meshes{cut_sphere()}; }},
                                           Family{"sheet", 40, [] { return Meshes{wavy_sheet(40, 0.25, 1)}; }},
                                           Family{"rough_sheet", 20, [] { return Meshes{rough_sheet()}; }},
                                           Family{"mask", 30, mask},
                                           Family{"half_torus", 40, [] { return Meshes{half_torus()}; }},
                                           Family{"lace", 20, [] { return Meshes{lace()}; }}),
                         name_of);

INSTANTIATE_TEST_SUITE_P(Several, VisibilityOf,
                         ::testing::Values(Family{"shell_with_ball", 30, shell_with_ball}, Family{"chain", 30, chain},
                                           Family{"bodies_in_one_mesh", 30, three_bodies, true}),
                         name_of);

INSTANTIATE_TEST_SUITE_P(Intersecting, VisibilityOf,
                         ::testing::Values(Family{"spheres", 20, [] { return two_spheres(4); }, true},
                                           Family{"spheres_in_one_mesh", 20,
                                                  [] { return Meshes{joined(two_spheres(3))}; }, true},
                                           Family{"boxes", 60, three_boxes, true}, Family{"boards", 60, boards, true},
                                           Family{"tori", 20, two_tori, true}),
                         name_of);

}  // namespace
}  // namespace croquis::lines
