// Backgrounds: images tiled pixel by pixel from the upper left corner, and the asked background before a technique's.
#include <fmt/format.h>

#include "components/cross.h"
#include "image/image.h"
#include "support/studio.h"

namespace croquis::components {
namespace {

using namespace test_support;

class BackgroundTest : public StudioTest {
protected:
    static image::Image shipped_image(const std::string& name) {
        return image::read(studio().resources().folders().find("textures", name, ".png"));
    }
    static void expect_tiled(const image::Image& picture, const image::Image& tile, int scale) {
        expect_pixels(picture, [&](int x, int y) -> std::optional<glm::vec4> {
            const glm::vec4 color(tile.at(x / scale % tile.width(), y / scale % tile.height()));
            return glm::vec4(glm::vec3(color) / 255.0f, 1.0f);
        });
    }
};

TEST_F(BackgroundTest, TilesAnImagePixelByPixelFromTheUpperLeft) {
    for (const auto& [directory, name] : {std::pair("images", "uv_grid"), {"paper", "lined"}}) {
        const image::Image tile = shipped_image(fmt::format("{}/{}", directory, name));
        Stage stage(studio(), {.width = tile.width() + 37, .height = tile.height() + 23});
        for (const char* filter : {":0", ""}) {
            const std::string texture = fmt::format("{}:{}{}", directory, name, filter);
            expect_tiled(stage.picture(fmt::format("pass background b {{ texture \"{}\" ; }} ;", texture)), tile, 1);
        }
    }
}

TEST_F(BackgroundTest, ScalesAnImageAsWidePixels) {
    const image::Image tile = shipped_image("images/uv_grid");
    Stage stage(studio(), {.width = 100, .height = 60});
    expect_tiled(stage.picture("pass background b { texture \"images:uv_grid:0\" ; scale 2 ; } ;"), tile, 2);
}

TEST_F(BackgroundTest, OversamplingEnlargesTheTiles) {
    Stage stage(studio(), {.width = 50, .height = 30, .pixel_scale = 3});
    expect_tiled(stage.picture("pass background b { texture \"images:uv_grid:0\" ; } ;"),
                 shipped_image("images/uv_grid"), 3);
}

TEST_F(BackgroundTest, FillsWithAColour) {
    Stage stage(studio(), {});
    EXPECT_EQ(stage.picture("pass background b { color 0.2 0.4 0.6 ; } ;"), image::Image(64, 48, {51, 102, 153, 255}));
}

TEST_F(BackgroundTest, TheAskedOneTakesThePlaceOfTheTechniques) {
    Stage stage(studio(),
                {.background = framework::Background{.color = {1, 0, 0, 1}, .image = nullptr, .tiled = nullptr}});
    for (const char* text :
         {"pass background b { color 0.2 0.4 0.6 ; } ;", "pass background b { texture \"images:uv_grid\" ; } ;",
          "pass render_phong p {} ;", "pass wireframe w {} ;"}) {
        EXPECT_EQ(stage.picture(text).at(0, 0), glm::u8vec4(255, 0, 0, 255)) << text;
    }
}

TEST_F(BackgroundTest, DoesNotReachGeneratedTextures) {
    Stage stage(studio(),
                {.background = framework::Background{.color = {1, 0, 0, 1}, .image = nullptr, .tiled = nullptr}});
    const auto technique = studio().open("pass render_base r { render_target \"t\" ; clear_color 0 1 0 ; } ;");
    stage.draw(*technique);
    EXPECT_EQ(read_colors(studio(), *technique, "t_color").at(0, 0), glm::u8vec4(0, 255, 0, 255));
}

}  // namespace
}  // namespace croquis::components
