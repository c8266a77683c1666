// Edge detectors on rendered scenes whose edges are known: a cube (row E1), seed C's figures 3.9 and 3.11 (rows E2,
// E3), coplanar materials (row E4), oversampling.
#include <fmt/format.h>

#include "components/cross.h"
#include "support/ray_cast.h"
#include "support/studio.h"

namespace croquis::components {
namespace {

using namespace test_support;

class EdgeScenes : public StudioTest {
protected:
    static int count_black(const image::Image& picture) {
        return int(std::count(picture.pixels().begin(), picture.pixels().end(), black));
    }
};

// The face seen at a pixel: its normal, or the background's.
std::optional<glm::dvec3> normal_at(const RayCaster& rays, const model::Camera& camera, int x, int y) {
    if (!rays.is_certain(x, y)) return std::nullopt;
    const auto hit = rays.pixel(x, y);
    return hit ? hit->normal : -camera.back;
}

// Equation 3.7 on normals that rays find. Where a neighbour's is uncertain, so is the pixel.
std::optional<bool> is_edge(const RayCaster& rays, const Stage& stage, int x, int y, double threshold) {
    const auto centre = normal_at(rays, stage.camera(), x, y);
    if (!centre) return std::nullopt;
    bool edge = false;
    for (const auto& [dx, dy] : {std::pair(-1, 0), {1, 0}, {0, -1}, {0, 1}}) {
        const auto normal = normal_at(rays, stage.camera(), std::clamp(x + dx, 0, stage.width() - 1),
                                      std::clamp(y + dy, 0, stage.height() - 1));
        if (!normal) return std::nullopt;
        edge = edge || glm::dot(*centre, *normal) < threshold;
    }
    return edge;
}

TEST_F(EdgeScenes, ACubeGivesExactlyItsVisibleCreasesAndContour) {
    for (const auto projection : {model::Projection::perspective, model::Projection::parallel}) {
        Stage stage(studio(), {.view = seen_from({1, 0.7, 1.4}, projection), .width = 96, .height = 72});
        const image::Image edges = stage.picture(*studio().open_named("edges_normals"));
        const RayCaster rays(stage.model(), stage.camera(), stage.width(), stage.height());
        int edge_pixels = 0;
        expect_pixels(
            edges,
            [&](int x, int y) -> std::optional<glm::vec4> {
                const auto edge = is_edge(rays, stage, x, y, 0.7);
                if (!edge) return std::nullopt;
                edge_pixels += *edge;
                return *edge ? glm::vec4(0, 0, 0, 1) : glm::vec4(1);
            },
            0.51, 0.03);
        EXPECT_GT(edge_pixels, 300);
    }
}

TEST_F(EdgeScenes, LinesOfACubeSeenFromTheFrontAreTwoPixelsWide) {
    Stage stage(studio(), {.view = seen_from({0, 0, 1}), .width = 90, .height = 72});
    const image::Image edges = stage.picture(*studio().open_named("edges_normals"));
    // Along the middle row: two pixels at the left border of the square and two at its right.
    std::vector<int> dark;
    for (int x = 0; x < edges.width(); ++x) {
        if (edges.at(x, 35) == black) dark.push_back(x);
    }
    ASSERT_EQ(dark.size(), 4u);
    EXPECT_EQ(dark[1], dark[0] + 1);
    EXPECT_EQ(dark[3], dark[2] + 1);
    EXPECT_EQ(dark[0] + dark[3], edges.width() - 1) << "as far from the left as from the right";
}

TEST_F(EdgeScenes, OversampledLinesKeepTheirWidthInThePicture) {
    for (const int scale : {2, 3, 4}) {
        Stage stage(studio(), {.view = seen_from({0, 0, 1}), .width = 90, .height = 70, .pixel_scale = scale});
        for (const char* name : {"edges_normals", "edges", "edges_depth", "edges_ids"}) {
            const image::Image edges = stage.picture(*studio().open_named(name));
            int dark = 0;
            for (int x = 0; x < edges.width() / 2; ++x) dark += edges.at(x, 35 * scale) != white;
            EXPECT_EQ(dark, 2 * scale) << name << " at scale " << scale;
        }
    }
}

TEST_F(EdgeScenes, TheFramesBorderIsNoEdge) {
    model::ViewRequest close = seen_from({0, 0, 1});
    close.eye = glm::dvec3(0, 0, 1.5);
    Stage stage(studio(), {.view = close});
    for (const char* name : {"edges_normals", "edges", "edges_depth", "edges_depth_2nd", "edges_ids"}) {
        const image::Image edges = stage.picture(*studio().open_named(name));
        EXPECT_EQ(std::count(edges.pixels().begin(), edges.pixels().end(), white), edges.width() * edges.height())
            << name;
    }
}

// True where the outline of the nearer square passes, for seed C's figure 3.9.
bool is_outline_of_near(const RayCaster& rays, int x, int y) {
    const auto centre = rays.pixel(x, y);
    for (const auto& [dx, dy] : {std::pair(-1, 0), {1, 0}, {0, -1}, {0, 1}}) {
        const auto beside = rays.at(x + 0.5 + dx, y + 0.5 + dy);
        if (centre && beside && centre->mesh != beside->mesh) return true;
    }
    return false;
}

TEST_F(EdgeScenes, ASilhouetteBeforeAParallelSurfaceIsFoundByDepthNotByNormals) {
    Stage stage(studio(), {.model = parallel_squares(), .view = seen_from({0.1, 0.1, 1}), .width = 80, .height = 60});
    const RayCaster rays(stage.model(), stage.camera(), stage.width(), stage.height());
    const image::Image by_normals = stage.picture(*studio().open_named("edges_normals"));
    const image::Image by_deltas = stage.picture(*studio().open_named("edges_depth"));
    const image::Image by_2nd = stage.picture(*studio().open_named("edges_depth_2nd"));
    const image::Image combined = stage.picture("include \"edges\" ; modify edges { detect_ids false ; } ;");
    int outline = 0;
    for (int y = 0; y < stage.height(); ++y) {
        for (int x = 0; x < stage.width(); ++x) {
            if (!rays.is_certain(x, y) || !is_outline_of_near(rays, x, y)) continue;
            ++outline;
            ASSERT_EQ(by_normals.at(x, y), white);
            ASSERT_EQ(by_deltas.at(x, y), black) << x << ", " << y;
            ASSERT_EQ(by_2nd.at(x, y), black) << x << ", " << y;
            ASSERT_EQ(combined.at(x, y), glm::u8vec4(255, 0, 0, 255)) << "by depth alone";
        }
    }
    EXPECT_GT(outline, 100);
}

// Seed C, figure 3.11: a polygon seen at a grazing angle.
TEST_F(EdgeScenes, ASteepPolygonFailsByDeltasButNotByTheSecondDerivative) {
    const ModelPointer floor = model_of({{"floor", quad_corners({-1, 0, 8}, {1, 0, 8}, {1, 0, -8}, {-1, 0, -8})}});
    Stage stage(
        studio(),
        {.model = floor, .view = seen_from({0, 0.08, 1}, model::Projection::parallel), .width = 80, .height = 60});
    const RayCaster rays(stage.model(), stage.camera(), stage.width(), stage.height());
    const auto inner_edges = [&](const char* component, double threshold) {
        const image::Image edges =
            stage.picture(fmt::format("pass render_normals s {{ render_target \"scene\" ; }} ; pass {} e {{ texture "
                                      "\"<generated>:scene_depth\" ; "
                                      "threshold {} ; }} ;",
                                      component, threshold));
        int inner = 0, pixels = 0;
        for (int y = 1; y < stage.height() - 1; ++y) {
            for (int x = 1; x < stage.width() - 1; ++x) {
                bool is_inside = true;
                for (const auto& [dx, dy] : {std::pair(0, 0), {-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
                    is_inside = is_inside && rays.is_certain(x + dx, y + dy) && rays.pixel(x + dx, y + dy);
                }
                pixels += is_inside;
                inner += is_inside && edges.at(x, y) == black;
            }
        }
        EXPECT_GT(pixels, 30);
        return inner;
    };
    EXPECT_GT(inner_edges("edge_detect_depth_deltas", 0.02), 30) << "falsely reported, as the figure shows";
    EXPECT_EQ(inner_edges("edge_detect_depth_deltas", 0.5), 0);
    EXPECT_EQ(inner_edges("edge_detect_depth_2nd_derivative", 0.05), 0);
    EXPECT_EQ(inner_edges("edge_detect_depth_2nd_derivative", 0.005), 0);
}

TEST_F(EdgeScenes, TwoCoplanarMaterialsGiveExactlyOneLine) {
    Stage stage(studio(), {.model = two_material_board(), .view = seen_from({0, 0, 1}), .width = 90, .height = 70});
    const image::Image by_ids = stage.picture(*studio().open_named("edges_ids"));
    const image::Image by_normals = stage.picture(*studio().open_named("edges_normals"));
    const image::Image combined = stage.picture(*studio().open_named("edges"));
    std::vector<int> inner;
    for (int x = 15; x < 75; ++x) {
        if (by_ids.at(x, 35) == black) inner.push_back(x);
        EXPECT_EQ(by_normals.at(x, 35), white);
        EXPECT_EQ(combined.at(x, 35), by_ids.at(x, 35) == black ? glm::u8vec4(153, 230, 153, 255) : white) << x;
    }
    EXPECT_EQ(inner, (std::vector<int>{44, 45})) << "one line of two pixels, in the middle";
    const image::Image off = stage.picture("include \"edges\" ; modify edges { detect_ids false ; } ;");
    EXPECT_EQ(off.at(44, 35), white);
}

}  // namespace
}  // namespace croquis::components
