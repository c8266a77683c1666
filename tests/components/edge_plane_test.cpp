// Edges by tangent planes: the same from near and far, lines as wide as asked (row E7).
#include <fmt/format.h>

#include "components/cross.h"
#include "lines/viewpoint.h"
#include "support/studio.h"

namespace croquis::components {
namespace {

using namespace test_support;

class EdgePlanes : public StudioTest {
protected:
    static std::string lines(const std::string& settings) {
        return fmt::format("include \"edges_plane\" ; modify lines {{ {} }} ;", settings);
    }
};

// The model as it is, or so many times as far away.
model::ViewRequest seen_from_afar(const ModelPointer& model, const glm::dvec3& direction, double times) {
    model::ViewRequest view = seen_from(direction);
    const model::Camera near_by = model::place_camera(*model, nullptr, view, 1);
    const model::SceneSpace space = model::SceneSpace::of(*model);
    view.eye = space.centre + near_by.eye * times * space.radius;
    view.target = space.centre;
    return view;
}

double ink_at(const image::Image& picture, const glm::dvec2& at) {
    double darkest = 1;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            const int x = int(at.x) + dx, y = int(at.y) + dy;
            if (x < 0 || y < 0 || x >= picture.width() || y >= picture.height()) continue;
            darkest = std::min(darkest, picture.at(x, y).x / 255.0);
        }
    }
    return 1 - darkest;
}

// Of a cube's twelve edges nine are seen from a corner; those and no others are drawn, from near and from far.
TEST_F(EdgePlanes, ACubeHasTheSameLinesAtOneAndFourTimesTheDistance) {
    const ModelPointer model = cube();
    for (const double times : {1.0, 4.0}) {
        Stage stage(studio(),
                    {.model = model, .view = seen_from_afar(model, {1, 0.7, 1.4}, times), .width = 240, .height = 240});
        const image::Image picture = stage.picture(lines("width 2 ;"));
        const auto view = lines::Viewpoint::of(stage.camera(), stage.width(), stage.height());
        const auto space = model::SceneSpace::of(*model);
        const auto at = [&](const glm::dvec3& point) { return view.project(space.from_file(point)).position; };
        for (int axis = 0; axis < 3; ++axis) {
            for (const double a : {-1.0, 1.0}) {
                for (const double b : {-1.0, 1.0}) {
                    for (const double along : {-0.6, -0.2, 0.2, 0.6}) {
                        glm::dvec3 point;
                        point[axis] = along;
                        point[(axis + 1) % 3] = a;
                        point[(axis + 2) % 3] = b;
                        const bool is_hidden = a < 0 && b < 0;
                        EXPECT_TRUE(is_hidden || ink_at(picture, at(point)) > 0.6) << times << ", axis " << axis;
                    }
                }
            }
        }
        for (const glm::dvec3& inside : {glm::dvec3(1, 0.3, 0.2), glm::dvec3(0.3, 1, -0.2), glm::dvec3(0.3, 0.2, 1)}) {
            EXPECT_LT(ink_at(picture, at(inside)), 0.05) << times;
        }
    }
}

// However few pixels it covers, a sphere has no line but its outline; nor has a plane seen along it.
TEST_F(EdgePlanes, RoundAndSteepSurfacesAreNoEdge) {
    const ModelPointer sphere = icosphere(5);
    for (const double times : {1.0, 4.0, 8.0}) {
        Stage stage(
            studio(),
            {.model = sphere, .view = seen_from_afar(sphere, {0.2, 0.3, 1}, times), .width = 160, .height = 160});
        const image::Image picture = stage.picture(lines("width 1 ;"));
        const auto view = lines::Viewpoint::of(stage.camera(), stage.width(), stage.height());
        const double radius = 1 / (std::sqrt(3.0) * view.units_a_pixel(view.project(glm::dvec3(0)).nearness));
        int inside = 0;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                const double from_middle = std::hypot(x + 0.5 - 80, y + 0.5 - 80);
                if (from_middle < radius - 2.5) inside += picture.at(x, y).x < 250;
            }
        }
        EXPECT_EQ(inside, 0) << times << " times as far";
    }
    const ModelPointer floor = model_of({{"floor", quad_corners({-1, 0, 1}, {1, 0, 1}, {1, 0, -9}, {-1, 0, -9})}});
    Stage steep(studio(), {.model = floor, .view = seen_from({0, 0.12, 1}), .width = 160, .height = 120});
    const image::Image picture = steep.picture(lines("width 1 ;"));
    const image::Image filled = steep.picture("pass render_base s { clear_color 1 1 1 ; } ;");
    int covered = 0, inked = 0;
    for (int y = 3; y < picture.height() - 3; ++y) {
        for (int x = 3; x < picture.width() - 3; ++x) {
            bool all = true;
            for (int d = -3; d <= 3; ++d) all = all && filled.at(x + d, y) != white && filled.at(x, y + d) != white;
            covered += all;
            inked += all && picture.at(x, y).x < 250;
        }
    }
    EXPECT_GT(covered, 500);
    EXPECT_EQ(inked, 0);
}

// Across a straight edge of the outline a line holds as much ink as it is wide.
TEST_F(EdgePlanes, LinesAreAsWideAsAsked) {
    const ModelPointer board = model_of({{"board", quad_corners({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0})}});
    for (const int scale : {1, 2}) {
        Stage stage(studio(),
                    {.model = board, .view = seen_from({0, 0, 1}), .width = 80, .height = 80, .pixel_scale = scale});
        for (const double width : {1.0, 2.0, 3.0, 8.0}) {
            const image::Image picture =
                stage.picture(lines(fmt::format("width {} ; }} ; modify rows {{ width 8 ;", width)));
            double ink = 0;
            for (int x = 0; x < picture.width() / 2; ++x) ink += 1 - picture.at(x, picture.height() / 2).x / 255.0;
            EXPECT_NEAR(ink, width * scale, 0.02 * width + 0.02) << "width " << width << ", scale " << scale;
        }
    }
}

}  // namespace
}  // namespace croquis::components
