// The area of a model, and which mesh is seen, against a ray caster.
#include "output/vector_fill.h"

#include <gtest/gtest.h>

#include "base/random.h"
#include "output/vector_regions.h"
#include "output/winding.h"
#include "support/models.h"
#include "support/ray_cast.h"

namespace croquis::output {
namespace {

using test_support::distance_to;
using test_support::winding_number;

constexpr int width = 160, height = 120;

struct Shot {
    const char* name;
    test_support::ModelPointer model;
    model::ViewRequest request;
};

// A box without two of its triangles: its inner side is seen behind its outer one.
test_support::ModelPointer open_box() {
    std::vector<glm::vec3> corners = test_support::box_corners(glm::vec3(-1.0f), glm::vec3(1.0f));
    corners.resize(corners.size() - 6);
    return test_support::model_of({{"box", corners}});
}

std::vector<Shot> shots() {
    model::ViewRequest slanted;
    model::ViewRequest parallel;
    parallel.projection = model::Projection::parallel;
    parallel.direction = {0.3, 0.2, 1};
    model::ViewRequest seen_end_on;
    seen_end_on.direction = {0, 0, 1};
    model::ViewRequest from_behind;
    from_behind.direction = {0.4, -0.3, -1};
    model::ViewRequest within;
    within.eye = glm::dvec3(0.2, 0.1, 0.3);
    within.target = glm::dvec3(1, 0.4, 0);
    return {{"sphere", test_support::icosphere(2), slanted},
            {"sphere, parallel", test_support::icosphere(2), parallel},
            {"cube end on", test_support::cube(), seen_end_on},
            {"within a cube", test_support::cube(), within},
            {"boards through each other", test_support::crossing_boards(), slanted},
            {"boards from behind", test_support::crossing_boards(), from_behind},
            {"open box", open_box(), slanted},
            {"open box from behind", open_box(), from_behind},
            {"squares", test_support::parallel_squares(), parallel}};
}

TEST(Fill, CoversWhatRaysHit) {
    for (const Shot& shot : shots()) {
        const model::Camera camera = model::place_camera(*shot.model, nullptr, shot.request, double(width) / height);
        const lines::Viewpoint view = lines::Viewpoint::of(camera, width, height);
        const lines::Surface surface(shot.model);
        const std::vector<Ring> area = covered_area(surface, view);
        const MeshPicker picker(surface, view);
        const test_support::RayCaster rays(*shot.model, camera, width, height);
        const Random random(1, shot.name);
        std::size_t wrong = 0, wrong_mesh = 0, hits = 0;
        for (std::uint64_t i = 0; i < 1500; ++i) {
            const glm::dvec2 point(random.between(0.1, width - 0.1, 2 * i),
                                   random.between(0.1, height - 0.1, 2 * i + 1));
            if (distance_to(area, point) < 0.05) continue;
            const auto hit = rays.at(point.x, point.y);
            if (hit) ++hits;
            if (hit.has_value() != (winding_number(area, point) != 0)) ++wrong;
            if (picker.mesh_at(point) != (hit ? hit->mesh : no_region)) ++wrong_mesh;
        }
        EXPECT_EQ(wrong, 0u) << shot.name;
        EXPECT_LE(wrong_mesh, 2u) << shot.name;  // where two meshes meet at the point
        EXPECT_GT(hits, 300u) << shot.name;
    }
}

TEST(Fill, RingsAreCutToTheFrame) {
    const Ring around{{{-10, -10}, {20, -10}, {20, 20}, {-10, 20}}, true};
    const Ring cut = cut_to_frame(around, 8, 5);
    for (const glm::dvec2& point : cut.points) {
        EXPECT_TRUE(point.x >= 0 && point.x <= 8 && point.y >= 0 && point.y <= 5);
    }
    EXPECT_EQ(winding_number(std::span(&cut, 1), {4, 2}), 1);
    const Ring beside{{{-10, 0}, {-5, 0}, {-5, 5}}, true};
    EXPECT_TRUE(cut_to_frame(beside, 8, 5).points.empty());
}

}  // namespace
}  // namespace croquis::output
