// Strokes that lie on the surface: their size in the picture, near and far, and their direction (row H3).
#include <fmt/format.h>

#include <cmath>
#include <glm/trigonometric.hpp>

#include "support/studio.h"

namespace croquis::components {
namespace {

using namespace test_support;
using framework::Light;

constexpr int side = 256;

// A board whose texture coordinates repeat the image `images` times along each side; none: without coordinates.
ModelPointer board(float half_height, float images) {
    model::RawModel raw;
    model::Mesh& mesh = raw.meshes.emplace_back().mesh;
    mesh.positions = {{-1, -half_height, 0}, {1, -half_height, 0}, {1, half_height, 0}, {-1, half_height, 0}};
    const float upper = images * half_height;
    if (images > 0) mesh.texcoords = {{0, 0}, {images, 0}, {images, upper}, {0, upper}};
    mesh.triangles = {0, 1, 2, 0, 2, 3};
    raw.materials.push_back(plain("white", {1, 1, 1}));
    return model::finish(std::move(raw), "board");
}

Shot from_the_front(const ModelPointer& model) {
    return {.model = model,
            .view = seen_from({0, 0, 1}, model::Projection::parallel),
            .light = {Light::Bound::world, Light::Kind::direction, {0, std::sqrt(1 - 0.49), 0.7}},
            .width = side,
            .height = side};
}

std::string strokes(double angle) {
    return fmt::format(
        "pass hatch_surface s {{ strokes \"hatching:ink\" ; ink_color 0 0 0 ; ambient 0 ; material_share 0 ; "
        "tone_range 0 1 ; highlight 0 ; angle {} ; }} ;",
        angle);
}

// How much a part of the picture changes from pixel to pixel, along both axes: one over the size of strokes.
glm::dvec2 changes(const image::Image& picture, int from_y, int to_y) {
    glm::dvec2 sum(0);
    const int margin = side / 4;
    for (int y = from_y; y < to_y; ++y) {
        for (int x = margin; x < side - margin; ++x) {
            sum.x += std::abs(picture.at(x + 1, y).x - picture.at(x, y).x);
            sum.y += std::abs(picture.at(x, y + 1).x - picture.at(x, y).x);
        }
    }
    return sum / (255.0 * (side - 2 * margin) * (to_y - from_y));
}

glm::dvec2 changes(const image::Image& picture) { return changes(picture, side / 4, 3 * side / 4); }

class HatchingOnSurfaces : public StudioTest {
protected:
    [[nodiscard]] static image::Image picture(const Shot& shot, double angle = 0) {
        return Stage(studio(), shot).picture(strokes(angle));
    }
};

TEST_F(HatchingOnSurfaces, RepeatedTexturesDoNotMakeStrokesSmaller) {
    const double without = changes(picture(from_the_front(board(1, 0)))).y;
    for (const float images : {1.0f, 2.0f, 3.0f, 16.0f, 100.0f}) {
        const double with = changes(picture(from_the_front(board(1, images)))).y;
        EXPECT_LT(with, 1.7 * without) << images;
        EXPECT_GT(with, without / 1.7) << images;
    }
}

TEST_F(HatchingOnSurfaces, TheirDirectionIsTheAngle) {
    for (const float images : {0.0f, 1.0f, 16.0f}) {
        const glm::dvec2 flat = changes(picture(from_the_front(board(1, images)), 0));
        const glm::dvec2 upright = changes(picture(from_the_front(board(1, images)), 90));
        EXPECT_GT(flat.y, 1.5 * flat.x) << images;
        EXPECT_GT(upright.x, 1.5 * upright.y) << images;
    }
}

TEST_F(HatchingOnSurfaces, StrokesAlongATextureFitTogetherWhereItStartsAgain) {
    // Moved by a whole image: the strokes are the same, whatever their angle.
    const auto moved_by = [](float offset) {
        model::RawModel raw;
        model::Mesh& mesh = raw.meshes.emplace_back().mesh;
        mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
        mesh.texcoords = {{0, offset}, {1, offset}, {1, offset + 1}, {0, offset + 1}};
        mesh.triangles = {0, 1, 2, 0, 2, 3};
        raw.materials.push_back(plain("white", {1, 1, 1}));
        return model::finish(std::move(raw), "board");
    };
    for (const double angle : {0.0, 17.0, 40.0, -100.0}) {
        const image::Image once = picture(from_the_front(moved_by(0)), angle);
        const image::Image again = picture(from_the_front(moved_by(1)), angle);
        EXPECT_LE(image::compare(once, again).mean, 0.1) << angle;
        EXPECT_GE(image::compare(once, picture(from_the_front(moved_by(0.37f)), angle)).mean, 5) << angle;
    }
}

TEST_F(HatchingOnSurfaces, StrokesNearTheEyeAreAsLargeAsFarOnes) {
    // Along a road that begins at the eye's feet: what lies near the picture's lower border is some ten times nearer
    // than what lies at its upper one. Across the road strokes are not foreshortened.
    for (const float images : {0.0f, 2.0f, 64.0f}) {
        Shot shot = from_the_front(board(20, images));
        shot.view.projection = model::Projection::perspective;
        shot.view.up = {0, 0, 1};
        shot.view.eye = glm::dvec3(0, -20, 0.3);
        shot.view.target = glm::dvec3(0, -18.5, 0);
        const image::Image road = picture(shot, 90);
        std::vector<double> sizes;
        for (const int from_y : {110, 140, 170, 200, 230}) sizes.push_back(changes(road, from_y, from_y + 20).x);
        const auto [least, most] = std::minmax_element(sizes.begin(), sizes.end());
        EXPECT_GT(*least, 0.02) << images;
        EXPECT_LT(*most, 3 * *least) << images;
    }
}

}  // namespace
}  // namespace croquis::components
