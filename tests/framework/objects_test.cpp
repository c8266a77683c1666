// One scene, many styles (row F12): passes choose their objects and hide each other's rightly.
#include <gtest/gtest.h>

#include "support/ray_cast.h"
#include "support/studio.h"

namespace croquis::framework {
namespace {

using test_support::crossing_boards;
using test_support::RayCaster;
using test_support::seen_from;
using test_support::Stage;

constexpr glm::u8vec4 white{255, 255, 255, 255}, red{255, 0, 0, 255}, blue{0, 0, 255, 255};

class ObjectsTest : public test_support::StudioTest {
protected:
    // Compares a picture of the boards with what a ray through each pixel meets first. `shown` are the meshes in it.
    static void expect_boards(Stage& stage, const image::Image& picture, std::vector<bool> shown) {
        const RayCaster rays(stage.model(), stage.camera(), stage.width(), stage.height());
        int seen[3] = {};
        for (int y = 0; y < stage.height(); ++y) {
            for (int x = 0; x < stage.width(); ++x) {
                if (!rays.is_certain(x, y) || is_crossing(rays, x, y)) continue;
                const auto hit = rays.pixel(x, y);
                if (hit && !shown[hit->mesh]) continue;
                const glm::u8vec4 expected = !hit ? white : hit->mesh == 0 ? red : blue;
                ASSERT_EQ(picture.at(x, y), expected) << x << ", " << y;
                ++seen[!hit ? 2 : int(hit->mesh)];
            }
        }
        for (std::size_t mesh = 0; mesh < 2; ++mesh) EXPECT_EQ(seen[mesh] > 200, bool(shown[mesh])) << mesh;
        EXPECT_GT(seen[2], 100);
    }

    // Where the boards go through each other, the depth buffer's rounding decides.
    static bool is_crossing(const RayCaster& rays, int x, int y) {
        const auto left = rays.at(x - 0.5, y + 0.5), right = rays.at(x + 1.5, y + 0.5);
        return left && right && left->mesh != right->mesh;
    }

    static Stage boards() {
        return Stage(studio(),
                     {.model = crossing_boards(), .view = seen_from({0.1, 0.2, 1}), .width = 96, .height = 72});
    }
};

constexpr const char* red_pass = "pass render_base reds { objects \"red\" ; clear_color 1 1 1 ; } ;";
constexpr const char* blue_over =
    "pass render_base blues { objects \"right_board\" ; keep_color true ; keep_depth true ; } ;";
constexpr const char* blue_pass = "pass render_base blues { objects \"blue\" ; clear_color 1 1 1 ; } ;";
constexpr const char* red_over = "pass render_base reds { objects \"left*\" ; keep_color true ; keep_depth true ; } ;";

TEST_F(ObjectsTest, TwoStylesHideEachOtherInEitherOrder) {
    Stage stage = boards();
    expect_boards(stage, stage.picture(std::string(red_pass) + blue_over), {true, true});
    expect_boards(stage, stage.picture(std::string(blue_pass) + red_over), {true, true});
}

TEST_F(ObjectsTest, TwoStylesHideEachOtherInAGeneratedTexture) {
    Stage stage = boards();
    const auto technique = studio().open(
        "pass render_base reds { objects \"red\" ; clear_color 1 1 1 ; render_target \"scene\" ; } ;"
        "pass render_base blues { objects \"blue\" ; keep_color true ; keep_depth true ; render_target \"scene\" ; } ;"
        "pass process_texture copy { texture \"<generated>:scene_color\" ; fragment_program \"image:copy\" ; } ;");
    expect_boards(stage, stage.picture(*technique), {true, true});
}

TEST_F(ObjectsTest, WithoutKeepingDepthTheLastPassLiesOnTop) {
    Stage stage = boards();
    const image::Image picture =
        stage.picture(std::string(red_pass) + "pass render_base blues { objects \"blue\" ; keep_color true ; } ;");
    const image::Image alone = stage.picture(blue_pass);
    for (int y = 0; y < stage.height(); ++y) {
        for (int x = 0; x < stage.width(); ++x) {
            if (alone.at(x, y) == blue) {
                ASSERT_EQ(picture.at(x, y), blue);
            }
        }
    }
}

TEST_F(ObjectsTest, WithoutKeepingColourTheLastPassIsAlone) {
    Stage stage = boards();
    const image::Image picture =
        stage.picture(std::string(red_pass) + "pass render_base blues { objects \"blue\" ; clear_color 1 1 1 ; } ;");
    EXPECT_EQ(picture, stage.picture(blue_pass));
}

struct Selection {
    const char* words;
    bool left, right;
};

TEST_F(ObjectsTest, WordsSelectByMeshMaterialOrRegion) {
    const auto model = crossing_boards();
    for (const Selection& c :
         {Selection{"", true, true}, Selection{"left_board", true, false}, Selection{"blue", false, true},
          Selection{"*_board", true, true}, Selection{"-red", false, true}, Selection{"-blue", true, false},
          Selection{"#1", true, false}, Selection{"#2", false, true}, Selection{"-#2", true, false},
          Selection{"red,blue", true, true}, Selection{"red blue", true, true}, Selection{"* -left_board", false, true},
          Selection{"nothing", false, false}, Selection{"????_board", true, false}, Selection{"Red", false, false}}) {
        const ObjectSelection selection(c.words);
        EXPECT_EQ(selection.includes(*model, model->meshes[0]), c.left) << c.words;
        EXPECT_EQ(selection.includes(*model, model->meshes[1]), c.right) << c.words;
    }
}

TEST_F(ObjectsTest, AnOverlayWithDepthIsHiddenByWhatIsNearer) {
    // The red board alone in a texture, laid over a frame with the blue one: only where red is nearer does it show.
    Stage stage = boards();
    const auto technique = studio().open(
        "pass render_base reds { objects \"red\" ; render_target \"red\" ; clear_color 1 1 1 ; } ;"
        "pass render_base blues { objects \"blue\" ; clear_color 1 1 1 ; } ;"
        "pass overlay over { texture \"<generated>:red_color\" ; depth \"<generated>:red_depth\" ; } ;");
    const image::Image picture = stage.picture(*technique);
    const RayCaster rays(stage.model(), stage.camera(), stage.width(), stage.height());
    int seen[2] = {};
    for (int y = 2; y < stage.height() - 2; ++y) {
        for (int x = 2; x < stage.width() - 2; ++x) {
            bool is_inside = true;  // the overlay takes the nearest depth around a pixel
            const auto hit = rays.pixel(x, y);
            for (int dx = -3; dx <= 3; ++dx) {
                for (int dy = -3; dy <= 3; ++dy) {
                    const auto beside = rays.at(x + 0.5 + dx, y + 0.5 + dy);
                    is_inside = is_inside && beside && hit && beside->mesh == hit->mesh;
                }
            }
            if (!is_inside) continue;
            ASSERT_EQ(picture.at(x, y), hit->mesh == 0 ? red : blue) << x << ", " << y;
            ++seen[hit->mesh];
        }
    }
    EXPECT_GT(seen[0], 100);
    EXPECT_GT(seen[1], 100);
}

}  // namespace
}  // namespace croquis::framework
