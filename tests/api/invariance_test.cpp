// The same model larger, smaller, far from its origin or wound the other way gives the same picture.
#include <gtest/gtest.h>

#include "api/shapes.h"

namespace croquis {
namespace {

using test_support::cube_file;
using test_support::Placement;
using test_support::small;
using test_support::torus_file;

class Invariance : public ::testing::Test {
protected:
    static void SetUpTestSuite() { renderer_ = std::make_unique<Renderer>(Renderer::headless()); }
    static void TearDownTestSuite() { renderer_.reset(); }

    static Picture draw(const Model& model, const std::string& technique, const DrawOptions& options = small()) {
        Technique opened = renderer_->open_technique(technique);
        return renderer_->draw(model, opened, options);
    }
    static inline std::unique_ptr<Renderer> renderer_;
};

constexpr const char* techniques[] = {"phong", "edges", "edges_depth", "wireframe", "normals", "cartoon_per_vertex"};

TEST_F(Invariance, OfScaleAndPlace) {
    for (const char* technique : techniques) {
        const Picture right = draw(torus_file(), technique);
        for (const Placement& placement :
             {Placement{.scale = 1e6}, Placement{.scale = 1e-6}, Placement{.offset = 1e6},
              Placement{.scale = 1e6, .offset = -3e11}, Placement{.scale = 1e-6, .offset = 0.7}}) {
            EXPECT_LT(draw(torus_file(placement), technique).difference_from(right).mean, 0.25)
                << technique << ", scale " << placement.scale << ", offset " << placement.offset;
        }
    }
}

TEST_F(Invariance, OfWinding) {
    for (const char* technique : techniques) {
        const Picture cube = draw(cube_file(), technique), torus = draw(torus_file(), technique);
        EXPECT_LT(draw(cube_file({.winding = Placement::Winding::inside_out}), technique).difference_from(cube).mean,
                  0.05)
            << technique;
        EXPECT_LT(
            draw(cube_file({.winding = Placement::Winding::every_third_flipped}), technique).difference_from(cube).mean,
            0.05)
            << technique;
        EXPECT_LT(draw(torus_file({.winding = Placement::Winding::inside_out}), technique).difference_from(torus).mean,
                  0.05)
            << technique;
    }
}

TEST_F(Invariance, OfWindingSeenFromInside) {
    DrawOptions options = small();
    options.view.eye = {0.5, 0.5, 0.5};
    options.view.target = {1, 0.6, 0.4};
    options.view.field_of_view = 90;
    const Picture cube = draw(cube_file(), "phong", options);
    EXPECT_LT(draw(cube_file({.winding = Placement::Winding::inside_out}), "phong", options).difference_from(cube).mean,
              0.05);
    const std::vector<std::uint8_t>& pixels = cube.pixels();
    EXPECT_NE(std::vector<std::uint8_t>(pixels.begin(), pixels.begin() + 3), (std::vector<std::uint8_t>{128, 128, 128}))
        << "walls on all sides";
}

TEST_F(Invariance, OfRepetition) {
    for (const char* technique : techniques) {
        EXPECT_EQ(draw(torus_file(), technique).pixels(), draw(torus_file(), technique).pixels()) << technique;
    }
}

}  // namespace
}  // namespace croquis
