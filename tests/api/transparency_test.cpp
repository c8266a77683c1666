// Transparent backgrounds, and alpha that is not multiplied into the colours.
#include <gtest/gtest.h>

#include <cmath>

#include "api/shapes.h"

namespace croquis {
namespace {

using test_support::cube_file;
using test_support::small;
using test_support::torus_file;

class Transparency : public ::testing::Test {
protected:
    static void SetUpTestSuite() { renderer_ = std::make_unique<Renderer>(Renderer::headless()); }
    static void TearDownTestSuite() { renderer_.reset(); }
    static inline std::unique_ptr<Renderer> renderer_;
};

// A picture laid over white.
Picture over_white(const Picture& picture) {
    std::vector<std::uint8_t> pixels = picture.pixels();
    for (std::size_t i = 0; i < pixels.size(); i += 4) {
        const double alpha = pixels[i + 3] / 255.0;
        for (std::size_t c = i; c < i + 3; ++c)
            pixels[c] = std::uint8_t(std::lround(pixels[c] * alpha + 255 * (1 - alpha)));
        pixels[i + 3] = 255;
    }
    return Picture(picture.width(), picture.height(), std::move(pixels));
}

TEST_F(Transparency, LaidOverWhiteIsThePictureOnWhite) {
    const Model model = torus_file();
    for (const char* name : {"phong", "cartoon_per_vertex", "wireframe"}) {
        Technique technique = renderer_->open_technique(name);
        for (const int samples : {1, 4, 9}) {
            DrawOptions options = small();
            options.samples = samples;
            options.background = Background{.color = {1, 1, 1}, .transparent = false, .texture = {}};
            const Picture on_white = renderer_->draw(model, technique, options);
            options.background->transparent = true;
            const Picture transparent = renderer_->draw(model, technique, options);
            EXPECT_EQ(transparent.pixels()[3], 0) << name;
            EXPECT_LE(over_white(transparent).difference_from(on_white).maximum, 3) << name << ", samples " << samples;
        }
    }
}

TEST_F(Transparency, ABackgroundsColourAndImageShow) {
    Technique technique = renderer_->open_technique("phong");
    DrawOptions options = small();
    options.background = Background{.color = {0.2, 0.4, 0.6}, .transparent = false, .texture = {}};
    const std::vector<std::uint8_t> plain = renderer_->draw(cube_file(), technique, options).pixels();
    EXPECT_EQ(std::vector<std::uint8_t>(plain.begin(), plain.begin() + 4),
              (std::vector<std::uint8_t>{51, 102, 153, 255}));
    options.background->texture = "images:uv_grid";
    const std::vector<std::uint8_t> tiled = renderer_->draw(cube_file(), technique, options).pixels();
    EXPECT_NE(std::vector<std::uint8_t>(tiled.begin(), tiled.begin() + 4),
              (std::vector<std::uint8_t>{51, 102, 153, 255}));
    EXPECT_EQ(tiled[3], 255);
}

// A detector's colours are written as they are: their alpha must not brighten them when the picture is read.
TEST_F(Transparency, HalfTransparentColoursKeepTheirValues) {
    Technique technique = renderer_->open_technique("edges", {"edges.non_edge_color=0.4 0.2 0.6 0.5"});
    const std::vector<std::uint8_t> pixels = renderer_->draw(cube_file(), technique, small()).pixels();
    const int expected[] = {102, 51, 153, 128};
    for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(pixels[c], expected[c], 2) << "channel " << c;
}

}  // namespace
}  // namespace croquis
