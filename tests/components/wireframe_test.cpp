// Wireframe: lines as wide as asked, hidden ones left out, the background kept (seed A, 2.3.2).
#include <fmt/format.h>

#include <glm/vec2.hpp>

#include "components/cross.h"
#include "support/studio.h"

namespace croquis::components {
namespace {

using namespace test_support;

class WireframeTest : public StudioTest {};

// How many pixels of black ink there are along a row's left quarter.
double ink(const image::Image& picture, int y) {
    double sum = 0;
    for (int x = 0; x < picture.width() / 4; ++x) sum += 1.0 - picture.at(x, y).x / 255.0;
    return sum;
}

TEST_F(WireframeTest, LinesAreAsWideAsAsked) {
    const ModelPointer board = model_of({{"board", quad_corners({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0})}});
    for (const char* hide : {"true", "false"}) {
        for (const int scale : {1, 2}) {
            Stage stage(
                studio(),
                {.model = board, .view = seen_from({0, 0, 1}), .width = 81, .height = 81, .pixel_scale = scale});
            for (const double width : {1.0, 2.0, 5.0}) {
                const image::Image picture = stage.picture(
                    fmt::format("pass wireframe w {{ width {} ; color 0 0 0 ; hide {} ; }} ;", width, hide));
                // A quarter down from the top the diagonal is far to the right.
                EXPECT_NEAR(ink(picture, 20 * scale), width * scale, 0.05 * width + 0.02)
                    << "width " << width << ", scale " << scale << ", hide " << hide;
            }
        }
    }
}

// Where a point of the cube stands in the picture.
glm::ivec2 pixel_of(const Stage& stage, const glm::dvec3& point) {
    const model::Camera& camera = stage.camera();
    const glm::dvec3 from_eye = model::SceneSpace::of(stage.model()).from_file(point) - camera.eye;
    const double distance = -glm::dot(from_eye, camera.back), aspect = double(stage.width()) / stage.height();
    const double x = glm::dot(from_eye, camera.right) / (distance * camera.tangent * aspect);
    const double y = glm::dot(from_eye, camera.up) / (distance * camera.tangent);
    return {int((x + 1) * 0.5 * stage.width()), int((1 - y) * 0.5 * stage.height())};
}

bool is_inked(const image::Image& picture, const glm::ivec2& at) {
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            if (picture.at(at.x + dx, at.y + dy).x < 128) return true;
        }
    }
    return false;
}

// How much of an edge of the cube is inked: the one along an axis at (a, b) on the other two.
double inked_share(const Stage& stage, const image::Image& picture, int axis, double a, double b) {
    int inked = 0;
    constexpr int samples = 20;
    for (int i = 0; i < samples; ++i) {
        glm::dvec3 point;
        point[axis] = -0.95 + 0.1 * i;
        point[(axis + 1) % 3] = a;
        point[(axis + 2) % 3] = b;
        inked += is_inked(picture, pixel_of(stage, point));
    }
    return double(inked) / samples;
}

TEST_F(WireframeTest, HiddenLinesAreLeftOutWhenAsked) {
    Stage stage(studio(), {.view = seen_from({1, 0.7, 1.5}), .width = 160, .height = 120});
    const image::Image hidden = stage.picture("pass wireframe w { color 0 0 0 ; } ;");
    const image::Image all = stage.picture("pass wireframe w { color 0 0 0 ; hide false ; } ;");
    for (const double a : {-1.0, 1.0}) {
        for (const double b : {-1.0, 1.0}) {
            // An edge along an axis is hidden when both its faces turn away: those towards -1 on the other two axes.
            const bool is_hidden = a < 0 && b < 0;
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_EQ(inked_share(stage, all, axis, a, b), 1.0);
                const double share = inked_share(stage, hidden, axis, a, b);
                // Lines before a hidden one cross it here and there.
                EXPECT_TRUE(is_hidden ? share < 0.6 : share == 1.0)
                    << "axis " << axis << " at " << a << ", " << b << ": " << share;
            }
        }
    }
}

TEST_F(WireframeTest, KeepsWhatTheFrameHolds) {
    Stage stage(studio(), {});
    const image::Image paper = stage.picture("pass background b { color 0.2 0.4 0.6 ; } ;");
    const image::Image lines = stage.picture(
        "pass background b { color 0.2 0.4 0.6 ; } ; pass wireframe w { color 0 0 0 ; keep_color true ; } ;");
    int kept = 0, inked = 0;
    for (std::size_t i = 0; i < lines.pixels().size(); ++i) {
        kept += lines.pixels()[i] == paper.pixels()[i];
        inked += lines.pixels()[i].x < 20;
    }
    EXPECT_GT(kept, 64 * 48 / 2) << "surfaces fill the depth alone";
    EXPECT_GT(inked, 50);
}

TEST_F(WireframeTest, DrawsEachEdgeOnceForTheWholeModel) {
    Stage stage(studio(), {});
    const auto technique = studio().open("pass wireframe w {} ;");
    stage.draw(*technique);
    const std::int64_t uploads = studio().counters().geometry_uploads, draws = studio().counters().draws;
    stage.draw(*technique);
    EXPECT_EQ(studio().counters().geometry_uploads, uploads) << "no upload in a frame";
    EXPECT_EQ(studio().counters().draws, draws + 2) << "depth and lines";
}

}  // namespace
}  // namespace croquis::components
