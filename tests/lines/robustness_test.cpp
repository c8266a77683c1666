// Damaged models, views of nothing, and everything that must not matter: units, place, rotation, the order of faces,
// the number of threads.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <ctime>
#include <glm/geometric.hpp>
#include <limits>
#include <string>
#include <vector>

#include "base/random.h"
#include "lines/drafter.h"
#include "lines/silhouette_finder.h"
#include "support/errors.h"
#include "support/temporary_folder.h"
#include "truth/agreement.h"
#include "truth/ink.h"
#include "truth/threads.h"
#include "truth/view_truth.h"
#include "truth/views.h"

namespace croquis::lines {
namespace {

using namespace truth;
using test_support::box_corners;
using test_support::quad_corners;

constexpr double pi = 3.14159265358979323846;
constexpr std::array ways{Visibility::quantitative, Visibility::ray_cast};

Options visible_only(Visibility visibility = Visibility::automatic) {
    Options options;
    options.clean = false;
    options.visibility = visibility;
    return options;
}

std::vector<Corners> some_scene() {
    return {bumpy_sphere(3, 0.15, 0, 4), moved(torus(1.4, 0.15, 48, 10), {0.1, 0, 0}),
            moved(box_corners({-0.3f, -0.4f, -0.2f}, {0.3f, 0.4f, 0.2f}), {0.4, 1.1, 0.5}),
            moved(wavy_sheet(12, 0.2, 1), {0, 0, -1.2})};
}

/// Views to look at: one where code runs slowly.
std::uint64_t few(int count) { return static_cast<std::uint64_t>(fewer_if_slow(count)); }

/// CPU time of all threads, in seconds: what the neighbours on the machine take does not count.
double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// Damaged models.

TEST(Robustness, FacesOfNoAreaAndPointsThatAreNoneChangeNothing) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
    const Corners good = bumpy_sphere(3, 0.2, 0, 1);
    Corners bad = good;
    const auto add = [&](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
        bad.insert(bad.end(), {a, b, c});
    };
    for (std::size_t i = 0; i + 2 < good.size(); i += 30) {
        add(good[i], good[i], good[i + 1]);                            // a needle
        add(good[i], good[i], good[i]);                                // a point
        add({0.25f, 0.5f, 0}, {0.25f, 0.5f, 1}, {0.25f, 0.5f, 0.5f});  // a line
        add(good[i], glm::vec3(nan, 0, 0), good[i + 1]);
        add(good[i], good[i + 2], glm::vec3(0, infinite, 0));
        add(glm::vec3(nan), glm::vec3(nan), glm::vec3(nan));
    }
    const SurfacePointer well = surface_of({good}), damaged = surface_of({bad});
    for (const Visibility way : ways) {
        for (std::uint64_t v = 0; v < few(6); ++v) {
            const Viewpoint view = random_view(*well, 21, v);
            std::string text;
            const Drawing truth = draw(well, view, visible_only(way));
            EXPECT_EQ(difference(view, draw(damaged, view, visible_only(way)), truth, text), 0.0)
                << "view " << v << "\n"
                << text;
        }
    }
}

TEST(Robustness, NothingToDrawIsOneClearError) {
    const Corners line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    EXPECT_NE(test_support::error_of([&] { (void)surface_of({line}); }), "no error");
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_NE(test_support::error_of([&] { (void)surface_of({{{nan, 0, 0}, {1, 0, 0}, {0, 1, 0}}}); }), "no error");
}

// Walls that meet in one edge, as pages of a book: every page shows, and the spine once.
TEST(Robustness, ManyFacesOnAnEdge) {
    for (const int pages : {3, 4, 5, 8}) {
        Corners corners;
        std::vector<glm::dvec3> ends;
        for (int i = 0; i < pages; ++i) {
            const double angle = 0.3 + 1.5 * i / pages;  // all turned the same way for an eye in front
            ends.push_back(glm::dvec3(std::cos(angle), 0, std::sin(angle)));
            const glm::vec3 up(0, 1, 0), end(ends.back());
            const Corners page = quad_corners(-up, end - up, end + up, up);
            corners.insert(corners.end(), page.begin(), page.end());
        }
        const SurfacePointer surface = surface_of({corners});
        const SurfaceTruth surface_truth(surface, Options{}.crease_angle);
        for (const Visibility way : ways) {
            for (std::uint64_t v = 0; v < few(10); ++v) {
                const Viewpoint view = random_view(*surface, 22, v);
                const Drawing drawing = draw(surface, view, exact_options(way));
                const Agreement found = compare(ViewTruth(surface_truth, view), drawing, true, {2, v});
                EXPECT_EQ(found.missing + found.doubled + found.stray + found.falsely_visible + found.wrong_layers, 0.0)
                    << pages << " pages, view " << v << ": " << found.summary();
            }
        }
    }
}

TEST(Robustness, InconsistentWindingShowsTheSameOutline) {
    const Random random(5, "winding");
    for (const Corners& good : {sphere_corners(3), torus(1, 0.4, 32, 16), bumpy_sphere(3, 0.25, 0, 1)}) {
        Corners mixed = good;
        for (std::size_t t = 0; t + 2 < mixed.size(); t += 3) {
            if (random.unit(t) < 0.3) std::swap(mixed[t], mixed[t + 1]);
        }
        const SurfacePointer well = surface_of({good}), badly = surface_of({mixed});
        for (const Visibility way : ways) {
            for (std::uint64_t v = 0; v < few(5); ++v) {
                const Viewpoint view = random_view(*well, 23, v);
                std::string text;
                const Drawing truth = draw(well, view, visible_only(way));
                EXPECT_LE(difference(view, draw(badly, view, visible_only(way)), truth, text, {.line_class = false}),
                          2e-3 * length_of(truth))
                    << "view " << v << "\n"
                    << text;
            }
        }
    }
}

TEST(Robustness, TriangleSoup) {
    const SurfacePointer surface = surface_of({soup(1500, 0.08, 1)});
    const SurfaceTruth surface_truth(surface, Options{}.crease_angle);
    for (const Visibility way : ways) {
        const Viewpoint view = random_view(*surface, 24, 1);
        const double start = cpu_seconds();
        const Drawing drawing = draw(surface, view, exact_options(way));
        EXPECT_LT(cpu_seconds() - start, 20.0);
        const Agreement found = compare(ViewTruth(surface_truth, view), drawing, true, {20, 1});
        EXPECT_GT(found.share(), 0.998) << found.summary();
    }
}

TEST(Robustness, DenseSoupEndsInTime) {
    const SurfacePointer surface = surface_of({soup(static_cast<std::size_t>(fewer_if_slow(1500)), 0.5, 2)});
    for (const bool clean : {false, true}) {
        Options options = visible_only();
        options.clean = clean;
        const double start = cpu_seconds();
        const Drawing drawing = draw(surface, random_view(*surface, 25, 0), options);
        EXPECT_LT(cpu_seconds() - start, 20.0);
        EXPECT_FALSE(drawing.lines.empty());
    }
}

// A disc cut like a cake: every face touches every other at the middle.
TEST(Robustness, AFanOfManyFacesEndsInTime) {
    const int sides = 400 + fewer_if_slow(3600);
    const auto rim = [&](int i) {
        const double angle = 2 * pi * (i % sides) / sides;
        return glm::vec3(glm::dvec3(std::cos(angle), std::sin(angle), 0.0));
    };
    Corners corners;
    for (int i = 0; i < sides; ++i) corners.insert(corners.end(), {glm::vec3(0), rim(i), rim(i + 1)});
    const SurfacePointer surface = surface_of({corners});
    const double start = cpu_seconds();
    const Drawing drawing = draw(surface, view_from(*surface, {0.2, 0.3, 1}), visible_only());
    EXPECT_LT(cpu_seconds() - start, 2.0);
    EXPECT_EQ(drawing.lines.size(), 1u);
}

// Views.

TEST(Robustness, ViewsOfNothingAreEmpty) {
    const SurfacePointer surface = surface_of(some_scene());
    for (const bool clean : {false, true}) {
        for (const Visibility way :
             {Visibility::quantitative, Visibility::ray_cast, Visibility::walking, Visibility::none}) {
            Options options = exact_options(way);
            options.clean = clean;
            Drafter drafter(surface, options);
            const Viewpoint behind = view_at({0, 0, 3}, {0, 0, 1});
            EXPECT_TRUE(drafter.draw(behind).lines.empty());
            const Viewpoint aside = view_at({0, 0, 4}, {1, 0, 0.05});
            EXPECT_TRUE(drafter.draw(aside).lines.empty());
            Viewpoint beside = view_from(*surface, {1, 1, 1}, {model::Projection::parallel});
            beside.eye += 7.0 * beside.right;
            const Drawing drawing = drafter.draw(beside);
            EXPECT_TRUE(drawing.lines.empty());
            EXPECT_TRUE(drawing.points.empty());
            EXPECT_EQ(drawing.width, beside.width);
        }
    }
}

TEST(Robustness, ViewpointsThatAreNoneAreRefused) {
    const SurfacePointer surface = surface_of(test_support::cube());
    const Viewpoint good = view_from(*surface, {1, 2, 3});
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Drafter drafter(surface, Options{});
    const auto refused = [&](auto change) {
        Viewpoint view = good;
        change(view);
        return test_support::error_of([&] { (void)drafter.draw(view); }) != "no error";
    };
    EXPECT_TRUE(refused([](Viewpoint& view) { view.width = 0; }));
    EXPECT_TRUE(refused([](Viewpoint& view) { view.height = -3; }));
    EXPECT_TRUE(refused([](Viewpoint& view) { view.scale = 0; }));
    EXPECT_TRUE(refused([](Viewpoint& view) { view.back = glm::dvec3(0.0); }));
    EXPECT_TRUE(refused([&](Viewpoint& view) { view.width = nan; }));
    EXPECT_TRUE(refused([&](Viewpoint& view) { view.scale = nan; }));
    EXPECT_TRUE(refused([&](Viewpoint& view) { view.back.y = nan; }));
    EXPECT_TRUE(refused([&](Viewpoint& view) { view.eye.x = nan; }));
    EXPECT_TRUE(refused([&](Viewpoint& view) { view.eye.x = std::numeric_limits<double>::infinity(); }));
    EXPECT_FALSE(refused([](Viewpoint&) {}));
}

TEST(Robustness, TheCameraInsideTheModel) {
    struct Inside {
        const char* name;
        std::vector<Corners> meshes;
    };
    const std::vector<Inside> cases{
        {"box", {box_corners({-1, -0.7f, -1.2f}, {1, 0.7f, 1.2f})}},
        {"ball in a sphere", {sphere_corners(3), moved(sphere_corners(2), {0.3, 0.1, -0.5}, 0.2)}},
        {"waves", {bumpy_sphere(3, 0.3, 0, 2)}},
        {"gear", {gear(9, 1.5)}},
        {"scene", some_scene()}};
    for (const Inside& inside : cases) {
        const SurfacePointer surface = surface_of(inside.meshes);
        const SurfaceTruth surface_truth(surface, Options{}.crease_angle);
        const Random random(6, inside.name);
        for (const Visibility way : ways) {
            Drafter drafter(surface, exact_options(way));
            Agreement sum;
            for (std::uint64_t v = 0; v < few(12); ++v) {
                const auto vector = [&](std::uint64_t k) {
                    return glm::dvec3(random.between(-1, 1, 8 * v + k), random.between(-1, 1, 8 * v + k + 1),
                                      random.between(-1, 1, 8 * v + k + 2));
                };
                const Viewpoint view = view_at(0.25 * vector(0), vector(3));
                sum += compare(ViewTruth(surface_truth, view), drafter.draw(view), true, {6, v});
            }
            EXPECT_GE(sum.share(), 0.999) << inside.name << ": " << sum.summary();
        }
    }
}

// What must not matter.

double length_apart(const Viewpoint& view, const Drawing& one, const Drawing& other, std::string& text, double reach) {
    return difference(view, one, other, text, {.mesh = true}, reach) / std::max(length_of(one), 1.0);
}

// Powers of two change no digit of any coordinate, and so nothing at all.
TEST(Robustness, UnitsChangeNothing) {
    const std::vector<Corners> scene = some_scene();
    const SurfacePointer surface = surface_of(scene);
    for (const double unit : {std::ldexp(1.0, 20), std::ldexp(1.0, -20), 1e6, 1e-6, 25.4}) {
        std::vector<Corners> scaled;
        for (const Corners& mesh : scene) scaled.push_back(moved(mesh, glm::dvec3(0.0), unit));
        const SurfacePointer other = surface_of(scaled);
        for (std::uint64_t v = 0; v < few(4); ++v) {
            const Viewpoint view = random_view(*surface, 26, v);
            for (const Visibility way : ways) {
                std::string text;
                EXPECT_LT(length_apart(view, draw(surface, view, exact_options(way)),
                                       draw(other, view, exact_options(way)), text, 2e-3),
                          3e-3)
                    << "unit " << unit << ", view " << v << "\n"
                    << text;
            }
        }
    }
}

// A file may hold a model a million units from its origin, in more digits than single precision has.
TEST(Robustness, ThePlaceChangesNothing) {
    const Corners corners = bumpy_sphere(3, 0.25, 0, 3);
    const auto file_at = [&](const glm::dvec3& place) {
        std::string text;
        for (const glm::vec3& corner : corners) {
            const glm::dvec3 p = glm::dvec3(corner) + place;
            text += fmt::format("v {:.17g} {:.17g} {:.17g}\n", p.x, p.y, p.z);
        }
        for (std::size_t i = 1; i <= corners.size(); i += 3) text += fmt::format("f {} {} {}\n", i, i + 1, i + 2);
        return text;
    };
    const test_support::TemporaryFolder folder;
    const SurfacePointer here = surface_of(model::load(folder.write("here.obj", file_at({0, 0, 0}))));
    const SurfacePointer there = surface_of(model::load(folder.write("there.obj", file_at({1e6, -2e6, 5e5}))));
    for (std::uint64_t v = 0; v < few(4); ++v) {
        const Viewpoint view = random_view(*here, 27, v);
        std::string text;
        EXPECT_LT(length_apart(view, draw(here, view, exact_options()), draw(there, view, exact_options()), text, 2e-3),
                  3e-3)
            << "view " << v << "\n"
            << text;
    }
}

TEST(Robustness, TurningModelAndCameraTogetherChangesNothing) {
    const std::vector<Corners> scene = some_scene();
    const SurfacePointer surface = surface_of(scene);
    const glm::dvec3 axis(1, 2, -0.7);
    constexpr double angle = 1.1;
    const glm::dmat3 turn = rotation(axis, angle);
    std::vector<Corners> turned_scene;
    for (const Corners& mesh : scene) turned_scene.push_back(turned(mesh, axis, angle));
    const SurfacePointer turned_surface = surface_of(turned_scene);
    const model::SceneSpace from = model::SceneSpace::of(surface->model());
    const model::SceneSpace to = model::SceneSpace::of(turned_surface->model());
    const double ratio = from.radius / to.radius;  // the boxes differ, and with them the scene's unit
    for (std::uint64_t v = 0; v < few(4); ++v) {
        const Viewpoint view = random_view(*surface, 28, v);
        Viewpoint turned_view = view;
        turned_view.eye = to.from_file(turn * (view.eye * from.radius + from.centre));
        turned_view.right = turn * view.right;
        turned_view.up = turn * view.up;
        turned_view.back = turn * view.back;
        turned_view.near_distance *= ratio;
        if (view.projection == model::Projection::parallel) turned_view.scale /= ratio;
        for (const Visibility way : ways) {
            Drawing there = draw(turned_surface, turned_view, exact_options(way));
            for (LinePoint& point : there.points) point.depth /= ratio;
            std::string text;
            EXPECT_LT(length_apart(view, draw(surface, view, exact_options(way)), there, text, 2e-3), 3e-3)
                << "view " << v << "\n"
                << text;
        }
    }
}

TEST(Robustness, TheOrderOfFacesChangesNothing) {
    const std::vector<Corners> scene = some_scene();
    std::vector<Corners> shuffled = scene;
    const Random random(7, "shuffle");
    for (Corners& mesh : shuffled) {
        for (std::size_t t = mesh.size() / 3; t-- > 1;) {
            const std::size_t other = random.bits(t) % (t + 1);
            for (std::size_t k = 0; k < 3; ++k) std::swap(mesh[3 * t + k], mesh[3 * other + k]);
            // Which corner comes first is of no meaning either.
            std::rotate(mesh.begin() + static_cast<std::ptrdiff_t>(3 * t),
                        mesh.begin() + static_cast<std::ptrdiff_t>(3 * t + t % 3),
                        mesh.begin() + static_cast<std::ptrdiff_t>(3 * t + 3));
        }
    }
    const SurfacePointer surface = surface_of(scene), other = surface_of(shuffled);
    for (std::uint64_t v = 0; v < few(6); ++v) {
        const Viewpoint view = random_view(*surface, 29, v);
        for (const Visibility way : ways) {
            const Drawing one = draw(surface, view, exact_options(way)), two = draw(other, view, exact_options(way));
            std::string text;
            EXPECT_LT(length_apart(view, one, two, text, 1e-4), 2e-4) << "view " << v << "\n" << text;
            EXPECT_NEAR(static_cast<double>(one.lines.size()), static_cast<double>(two.lines.size()),
                        0.05 * static_cast<double>(one.lines.size()) + 2);
        }
    }
}

bool are_same(const Drawing& one, const Drawing& other) {
    if (one.lines.size() != other.lines.size() || one.points.size() != other.points.size()) return false;
    const auto same_point = [](const LinePoint& a, const LinePoint& b) {
        return a.position == b.position && a.depth == b.depth && a.normal == b.normal;
    };
    const auto same_line = [](const Line& a, const Line& b) {
        return a.line_class == b.line_class && a.mesh == b.mesh && a.layers == b.layers && a.closed == b.closed &&
               a.first_point == b.first_point && a.point_count == b.point_count;
    };
    return std::equal(one.points.begin(), one.points.end(), other.points.begin(), same_point) &&
           std::equal(one.lines.begin(), one.lines.end(), other.lines.begin(), same_line);
}

TEST(Robustness, TheNumberOfThreadsChangesNoBit) {
    const SurfacePointer scene = surface_of(some_scene());
    const SurfacePointer rough = surface_of({bumpy_sphere(fewer_if_slow(25) < 25 ? 3 : 5, 0.1, 0.01, 2)});
    for (const SurfacePointer& surface : {scene, rough}) {
        for (const Visibility way : {Visibility::quantitative, Visibility::ray_cast, Visibility::walking}) {
            for (const bool clean : {false, true}) {
                Options options = exact_options(way);
                options.clean = clean;
                options.hidden = !clean;
                const auto drawings = [&](int threads) {
                    return on_threads(threads, [&] {
                        Drafter drafter(surface, options);
                        std::vector<Drawing> found;
                        for (std::uint64_t v = 0; v < 2; ++v) {
                            found.push_back(drafter.draw(random_view(*surface, 30, v)));
                        }
                        return found;
                    });
                };
                const std::vector<Drawing> alone = drawings(1);
                for (const int threads : {2, 7}) {
                    const std::vector<Drawing> together = drawings(threads);
                    for (std::size_t v = 0; v < alone.size(); ++v) {
                        EXPECT_FALSE(alone[v].lines.empty());
                        EXPECT_TRUE(are_same(alone[v], together[v]))
                            << "visibility " << static_cast<int>(way) << ", " << threads << " threads, view " << v
                            << (clean ? ", clean" : "");
                    }
                }
            }
        }
    }
}

TEST(Robustness, FindersMakeTheSameDrawingWithAnyNumberOfThreads) {
    const SurfacePointer surface = surface_of({bumpy_sphere(4, 0.1, 0.01, 2)});
    for (const FinderInfo& info : finder_infos()) {
        Options options = visible_only();
        options.finder = std::string(info.name);
        ViewOptions view_options;
        view_options.projection = model::Projection::parallel;  // every finder knows it
        const Viewpoint view = view_from(*surface, {1, 2, 3}, view_options);
        const auto drawing = [&](int threads) {
            return on_threads(threads, [&] { return draw(surface, view, options); });
        };
        EXPECT_TRUE(are_same(drawing(1), drawing(2))) << info.name;
    }
}

// What a drafter drew before leaves no trace in what it draws next.
TEST(Robustness, EarlierViewsChangeNothing) {
    const SurfacePointer surface = surface_of(some_scene());
    for (const Visibility way : {Visibility::quantitative, Visibility::ray_cast, Visibility::walking}) {
        Drafter drafter(surface, exact_options(way));
        for (std::uint64_t v = 0; v < few(4); ++v) {
            const Viewpoint view = random_view(*surface, 31, v);
            EXPECT_TRUE(are_same(drafter.draw(view), draw(surface, view, exact_options(way)))) << "view " << v;
        }
    }
}

}  // namespace
}  // namespace croquis::lines
