// Mistakes in technique files that only opening can find: each stands at its pass.
#include <gtest/gtest.h>

#include "support/errors.h"
#include "support/studio.h"

namespace croquis::framework {
namespace {

using test_support::error_of;
using test_support::without;

class TechniqueErrorTest : public test_support::StudioTest {};

struct Mistake {
    const char* text;
    const char* message;
};

TEST_F(TechniqueErrorTest, StandsAtItsPass) {
    for (
        const Mistake& mistake : {
            Mistake{
                "\n  pass test_image p { fragment_program \"test_image:gray\" ; } ;",
                "test.technique:2:3: pass \"p\": test_image.glsl: no shader function \"gray\"; did you mean \"grey\"?"},
            Mistake{"pass test_image p { fragment_program \"imag:grey\" ; } ;",
                    "test.technique:1:1: pass \"p\": no shader file \"imag\"; did you mean \"image\"?"},
            Mistake{"pass test_image p { fragment_program \"image:copy\" ; texture \"toon:two_tune\" ; } ;",
                    "test.technique:1:1: pass \"p\", variable \"texture\": no image \"two_tune\" in texture directory "
                    "\"toon\"; did you mean \"two_tone\"?"},
            Mistake{
                "pass render_normals n { render_target \"scene\" ; } ;\n"
                "pass edge_detect_normals e { texture \"<generated>:scene_colour\" ; } ;",
                "test.technique:2:1: pass \"e\", variable \"texture\": no pass generates the texture \"scene_colour\"; "
                "did you mean \"scene_color\"?"},
            Mistake{
                "pass edge_detect_normals e { texture \"<generated>:scene_color\" ; } ;",
                "test.technique:1:1: pass \"e\", variable \"texture\": no pass generates the texture \"scene_color\""},
            Mistake{"pass render_attributes a { render_target \"\" ; } ;",
                    "test.technique:1:1: pass \"a\": component render_attributes needs a name in render_target"},
            Mistake{"pass render_attributes a { render_target \"x\" ; } ; pass copy_to_texture b { texture \"x_depth\" "
                    "; } ;",
                    "test.technique:1:52: pass \"b\": <generated>:x_depth is made by two passes in two formats"},
            Mistake{"pass edge_detector e { texture \"toon:flat\" ; } ;",
                    "test.technique:1:1: pass \"e\" must set \"fragment_program\": component edge_detector gives it no "
                    "default"},
        }) {
        EXPECT_EQ(without(error_of([&] { (void)studio().open(mistake.text); }), CROQUIS_TEST_DATA "/shaders/"),
                  mistake.message);
    }
}

TEST_F(TechniqueErrorTest, LeavesNothingAlive) {
    const int before = studio().counters().live_objects();
    (void)error_of([&] {
        (void)studio().open(
            "pass render_normals n { render_target \"scene\" ; } ; pass test_image p { fragment_program \"x:y\" ; } ;");
    });
    EXPECT_EQ(studio().counters().live_objects(), before);
}

// A texture is needed here, and none is named: an error at the pass, not a crash in a frame.
void draw_without_texture() {
    test_support::Studio studio;
    const std::string message = error_of([&] {
        const auto technique =
            studio.open("pass ping_pong p { texture \"\" ; result \"r\" ; fragment_program \"image:copy\" ; } ;");
        test_support::Stage stage(studio, {});
        stage.draw(*technique);
    });
    std::_Exit(message.rfind("test.technique:1:1: pass \"p\"", 0) == 0 ? 0 : 3);
}

TEST(TechniqueErrors, PingPongWithoutATextureIsToldAtItsPass) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(draw_without_texture(), ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace croquis::framework
