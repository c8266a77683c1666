// Passes over whole pictures: ping_pong, generate_texture, copy_to_texture, process_texture's blends (row F8).
#include <fmt/format.h>

#include "components/cross.h"
#include "support/ray_cast.h"
#include "support/studio.h"

namespace croquis::components {
namespace {

using namespace test_support;

class ImagePasses : public StudioTest {
protected:
    static image::Image random_colors(int width, int height, int lowest, int highest) {
        const Random random(11, "colors");
        image::Image image(width, height);
        std::uint64_t next = 0;
        for (glm::u8vec4& pixel : image.pixels()) {
            for (int c = 0; c < 3; ++c) pixel[c] = std::uint8_t(random.between(lowest, highest, next++));
            pixel.w = 255;
        }
        return image;
    }
};

TEST_F(ImagePasses, PingPongRunsNTimes) {
    Stage stage(studio(), {.width = 20, .height = 10});
    const image::Image start = random_colors(20, 10, 0, 200);
    studio().sources()["start"] = start;
    const auto technique = studio().open(
        "pass test_source s { texture \"start\" ; } ; pass ping_pong p { texture \"<generated>:start\" ; result "
        "\"end\" ; "
        "fragment_program \"test_image:one_more\" ; } ; pass process_texture show { texture \"<generated>:end\" ; "
        "fragment_program \"image:copy\" ; } ;");
    for (const int runs : {1, 0, 2, 3, 10, 50}) {
        technique->set("p", "iterations", runs);
        const image::Image end = stage.picture(*technique);
        expect_pixels(end, [&](int x, int y) -> std::optional<glm::vec4> {
            return (glm::vec4(start.at(x, y)) + glm::vec4(runs, runs, runs, 0)) / 255.0f;
        });
    }
}

TEST_F(ImagePasses, GenerateTextureMakesOnceAndAgainOnChange) {
    Stage stage(studio(), {.width = 16, .height = 12});
    const auto technique = studio().open(
        "pass generate_texture g { texture \"made\" ; width 16 ; height 12 ; fragment_program "
        "\"test_image:place_as_color\" ; } ;"
        "pass process_texture show { texture \"<generated>:made\" ; fragment_program \"image:copy\" ; } ;");
    const auto draws = [&] {
        const std::int64_t before = studio().counters().draws;
        stage.draw(*technique);
        return studio().counters().draws - before;
    };
    EXPECT_EQ(draws(), 2);
    EXPECT_EQ(stage.picture().at(3, 0), glm::u8vec4(3, 11, 0, 255));
    EXPECT_EQ(draws(), 1) << "nothing changed";
    technique->set("g", "width", 20);
    EXPECT_EQ(draws(), 2) << "a variable changed";
    EXPECT_EQ(read_colors(studio(), *technique, "made").width(), 20);
    EXPECT_EQ(draws(), 1);
    stage.set_seed(5);
    EXPECT_EQ(draws(), 2) << "another seed";
    EXPECT_EQ(draws(), 1);
}

TEST_F(ImagePasses, CopyToTextureCopiesColour) {
    Stage stage(studio(), {.width = 20, .height = 10});
    const image::Image start = random_colors(20, 10, 0, 255);
    studio().sources()["start"] = start;
    const auto technique = studio().open(
        "pass test_source s { texture \"start\" ; } ; pass process_texture show { texture \"<generated>:start\" ; "
        "fragment_program \"image:copy\" ; } ; pass copy_to_texture c { texture \"kept\" ; } ; pass background b {} ;");
    EXPECT_EQ(stage.picture(*technique), image::Image(20, 10, white));
    EXPECT_EQ(read_colors(studio(), *technique, "kept"), start);
    stage.resize(31, 7);
    stage.draw(*technique);
    EXPECT_EQ(read_colors(studio(), *technique, "kept").width(), 31);
}

TEST_F(ImagePasses, CopyToTextureCopiesDepth) {
    Stage stage(studio(), {.model = icosphere(2)});
    const auto technique =
        studio().open("pass render_base r {} ; pass copy_to_texture c { texture \"kept\" ; depth true ; } ;");
    stage.draw(*technique);
    const image::Raster<double> kept = read_depths(studio(), *technique, "kept");
    const RayCaster rays(stage.model(), stage.camera(), stage.width(), stage.height());
    const double n = stage.camera().near_plane, f = stage.camera().far_plane;
    int seen = 0;
    for (int y = 0; y < stage.height(); ++y) {
        for (int x = 0; x < stage.width(); ++x) {
            if (!rays.is_certain(x, y)) continue;
            const auto hit = rays.pixel(x, y);
            const double depth = kept.at(x, y);
            const double distance = 2.0 * n * f / ((f + n) - (2.0 * depth - 1.0) * (f - n));  // equation 3.11
            ASSERT_NEAR(distance, hit ? hit->eye_distance : f, 1e-4);
            seen += hit.has_value();
        }
    }
    EXPECT_GT(seen, 500);
}

TEST_F(ImagePasses, BlendsJoinAsTheyAreNamed) {
    Stage stage(studio(), {.width = 8, .height = 8});
    for (const auto& [mode, level] :
         {std::pair("over", 0.6), {"none", 0.6}, {"multiply", 0.24}, {"screen", 0.76}, {"add", 1.0}}) {
        const image::Image picture =
            stage.picture(fmt::format("pass test_image below {{ fragment_program \"test_image:grey\" ; amount 0.4 ; }} "
                                      "; pass test_image above {{ "
                                      "fragment_program \"test_image:grey\" ; amount 0.6 ; blend \"{}\" ; }} ;",
                                      mode));
        EXPECT_NEAR(picture.at(3, 3).x, 255 * level, 0.7) << mode;
        EXPECT_EQ(picture.at(3, 3).w, 255) << mode;
    }
}

TEST_F(ImagePasses, OverlayBlendsWithItsOpacity) {
    Stage stage(studio(), {.width = 8, .height = 8});
    for (const auto& [mode, level] : {std::pair("over", 0.5), {"multiply", 0.32}, {"screen", 0.58}, {"add", 0.7}}) {
        const image::Image picture = stage.picture(
            fmt::format("pass test_image above {{ fragment_program \"test_image:grey\" ; amount 0.6 ; render_target "
                        "\"above\" ; }} ;"
                        "pass test_image below {{ fragment_program \"test_image:grey\" ; amount 0.4 ; }} ;"
                        "pass overlay o {{ texture \"<generated>:above_color\" ; opacity 0.5 ; mode \"{}\" ; }} ;",
                        mode));
        EXPECT_NEAR(picture.at(3, 3).x, 255 * level, 1.1) << mode;
    }
}

TEST_F(ImagePasses, TargetsHaveTheSizeAsked) {
    Stage stage(studio(), {.width = 21, .height = 10});
    for (const auto& [words, width, height] : {std::tuple("", 21, 10),
                                               {"render_target_width 5 ; render_target_height 7 ;", 5, 7},
                                               {"render_target_width -2 ; render_target_height -3 ;", 11, 4}}) {
        const auto technique = studio().open(fmt::format("pass render_base r {{ render_target \"t\" ; {} }} ;", words));
        stage.draw(*technique);
        EXPECT_EQ(read_colors(studio(), *technique, "t_color").width(), width);
        EXPECT_EQ(read_colors(studio(), *technique, "t_color").height(), height);
    }
}

}  // namespace
}  // namespace croquis::components
