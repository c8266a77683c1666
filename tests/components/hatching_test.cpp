// Hatching: the tone that is asked for is the tone that is drawn, on any paper, at any size (rows H3, H4).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "components/cross.h"
#include "framework/sliced_image.h"
#include "support/errors.h"
#include "support/studio.h"

namespace croquis::components {
namespace {

using namespace test_support;
using framework::Light;

const char* const plain_tone = "ink_color 0 0 0 ; ambient 0 ; material_share 0 ; tone_range 0 1 ; angle 0 ;";

// A board from the front, and a light whose direction makes its cosine.
ModelPointer board() { return model_of({{"board", quad_corners({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0})}}); }

Shot board_in_light(double cosine, int side, int pixel_scale = 1) {
    return {.model = board(),
            .view = seen_from({0, 0, 1}, model::Projection::parallel),
            .light = {Light::Bound::world, Light::Kind::direction, {std::sqrt(1 - cosine * cosine), 0, cosine}},
            .width = side,
            .height = side,
            .pixel_scale = pixel_scale};
}

// The mean of the middle of the picture, 0 to 1.
double mean_tone(const image::Image& picture, int side) {
    const int from_x = (picture.width() - side) / 2, from_y = (picture.height() - side) / 2;
    double sum = 0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) sum += picture.at(from_x + x, from_y + y).x;
    }
    return sum / (255.0 * side * side);
}

struct Style {
    const char* component;
    const char* strokes;
};

const std::vector<Style> toned_styles{{"hatch_screen", "pencil"},        {"hatch_screen", "ink"},
                                      {"hatch_screen", "brush"},         {"hatch_surface", "ink"},
                                      {"hatch_volume", "pencil_volume"}, {"hatch_volume", "ink_volume"}};

std::string toned(const Style& style, const std::string& more = {}) {
    return fmt::format("pass {} s {{ {} highlight 0 ; strokes \"hatching:{}\" ; }} ; modify s {{ {} }} ;",
                       style.component, plain_tone, style.strokes, more);
}

class HatchingTest : public StudioTest {};

TEST_F(HatchingTest, TheMeanToneIsTheCosine) {
    for (const Style& style : toned_styles) {
        const auto technique = studio().open(toned(style));
        // In the picture's plane, what is measured is whole images of strokes.
        const double exactness = std::string(style.component) == "hatch_surface" ? 0.02 : 0.006;
        double last = -1;
        for (int i = 0; i <= 16; ++i) {
            const double cosine = i / 16.0;
            Stage stage(studio(), board_in_light(cosine, 300));
            const double mean = mean_tone(stage.picture(*technique), 256);
            EXPECT_NEAR(mean, cosine, exactness) << style.component << " with " << style.strokes;
            EXPECT_GT(mean, last);
            last = mean;
        }
    }
}

TEST_F(HatchingTest, NoPixelGrowsDarkerWithMoreLight) {
    for (const Style& style : toned_styles) {
        const auto technique = studio().open(toned(style));
        image::Image last;
        for (int i = 0; i <= 20; ++i) {
            Stage stage(studio(), board_in_light(i / 20.0, 120));
            const image::Image picture = stage.picture(*technique);
            int darker = 0;
            for (std::size_t p = 0; p < last.pixels().size(); ++p) {
                darker += picture.pixels()[p].x + 1 < last.pixels()[p].x;
            }
            EXPECT_EQ(darker, 0) << style.strokes << " from " << (i - 1) / 20.0 << " to " << i / 20.0;
            last = picture;
        }
    }
}

TEST_F(HatchingTest, ChalkDrawsTheLight) {
    Stage stage(studio(), board_in_light(0.75, 300));
    const std::string chalk = toned(toned_styles[0], "draw_light true ; ink_color 1 1 1 ; clear_color 0 0 0 ;");
    EXPECT_NEAR(mean_tone(stage.picture(chalk), 256), 0.75, 0.02);
}

TEST_F(HatchingTest, TheHighlightIsTheMaterials) {
    // Seen along the normal in light along it, the specular factor is 1; the intensity is seed C's equation 4.5.
    for (const glm::vec3& specular : {glm::vec3(0), glm::vec3(0.5f), glm::vec3(1, 0.5, 0)}) {
        Shot shot = board_in_light(1, 300);
        model::Material material = plain("glossy", {0, 0, 0});
        material.specular = specular;
        shot.model = model_of({{"board", quad_corners({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0})}}, {material});
        const image::Image picture =
            Stage(studio(), shot).picture(toned(toned_styles[0], "highlight 0.8 ; material_share 1 ;"));
        const double intensity = 0.3 * specular.x + 0.6 * specular.y + 0.1 * specular.z;
        EXPECT_NEAR(mean_tone(picture, 256), 0.8 * intensity, 0.01);
    }
}

TEST_F(HatchingTest, PencilsOfLightColoursAreSeenOnPaper) {
    // In the dark all is ink: on white paper half of the colour's white is left, in chalk all of it.
    Shot shot = board_in_light(0, 40);
    for (const glm::vec3& color : {glm::vec3(1), glm::vec3(0.8f), glm::vec3(0.8, 0.6, 0.2), glm::vec3(0.6, 0, 0.4)}) {
        shot.model = model_of({{"board", quad_corners({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0})}},
                              {plain("colour", color)});
        const auto middle = [&](const std::string& more) {
            return Stage(studio(), shot).picture(toned(toned_styles[0], "material_ink 1 ; " + more)).at(20, 20);
        };
        const glm::u8vec4 pencil = middle(""), chalk = middle("draw_light true ; ambient 1 ;");
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(pencil[c], 255 * (color[c] - 0.5 * std::min({color.x, color.y, color.z})), 1);
            EXPECT_NEAR(chalk[c], 255 * color[c], 1);
        }
    }
}

// Four samples lie a quarter of a pixel from the pixel's centre. So their mean has three quarters of the texel there
// and an eighth of each one beside it, along both axes.
double mean_of_filtered_samples(const image::Image& picture, int x, int y) {
    constexpr double share[] = {0.125, 0.75, 0.125};
    double sum = 0;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) sum += share[dx + 1] * share[dy + 1] * picture.at(x + dx, y + dy).x;
    }
    return sum;
}

TEST_F(HatchingTest, SeveralSamplesShowTheSameStrokes) {
    for (const Style& style : {toned_styles[1], toned_styles[4]}) {
        Stage one(studio(), board_in_light(0.6, 128)), four(studio(), board_in_light(0.6, 128, 2));
        const image::Image small = one.picture(toned(style)), large = four.picture(toned(style));
        double furthest = 0;
        for (int y = 10; y < 118; ++y) {
            for (int x = 10; x < 118; ++x) {
                int sum = 0;
                for (int i = 0; i < 4; ++i) sum += large.at(2 * x + i % 2, 2 * y + i / 2).x;
                furthest = std::max(furthest, std::abs(sum / 4.0 - mean_of_filtered_samples(small, x, y)));
            }
        }
        EXPECT_LT(furthest, 4) << style.strokes;
    }
}

TEST_F(HatchingTest, PaperShowsBetweenStrokesAndHiddenSurfacesDoNot) {
    const std::string paper = "pass background p { color 0.8 0.6 0.4 ; } ;";
    const std::vector<glm::vec3> near = quad_corners({-1, -1, 0.5}, {1, -1, 0.5}, {1, 1, 0.5}, {-1, 1, 0.5});
    const std::vector<glm::vec3> far = quad_corners({-1, -1, -0.5}, {1, -1, -0.5}, {1, 1, -0.5}, {-1, 1, -0.5});
    for (const Style& style : toned_styles) {
        Shot shot = board_in_light(0.5, 100);
        const auto picture_of = [&](const std::vector<Piece>& pieces, const std::string& more) {
            shot.model = model_of(pieces);
            return Stage(studio(), shot).picture(paper + toned(style, "keep_color true ;" + more));
        };
        const image::Image both = picture_of({{"far", far}, {"near", near}}, {});
        EXPECT_EQ(both, picture_of({{"far", far}, {"near", near}}, "objects \"near\" ;")) << style.component;
        const image::Image light = picture_of({{"near", near}}, "tone_range -1 0.1 ;");
        EXPECT_EQ(light.at(50, 50), glm::u8vec4(204, 153, 102, 255)) << "full light draws nothing";
    }
}

TEST_F(HatchingTest, AStencilOutlineStaysOutside) {
    const std::string paper = "pass background p { color 1 1 1 ; } ; ";
    const std::string outline = " pass outline o { method \"stencil\" ; width 4 ; color 1 0 0 ; } ;";
    for (const char* const component :
         {"hatch_simple", "hatch_fine", "hatch_projective", "hatch_volume", "hatch_screen", "hatch_surface"}) {
        for (const std::string& under : {std::string(), paper}) {
            Stage stage(studio(), {.model = icosphere(2), .view = seen_from({1, 0.5, 1}), .width = 80, .height = 80});
            const std::string hatching =
                fmt::format("{}pass {} s {{ keep_color {} ; }} ;", under, component, !under.empty());
            const image::Image plain = stage.picture(hatching), outlined = stage.picture(hatching + outline);
            const image::Image shape = stage.picture("pass render_base b { clear_color 0 1 0 ; } ;");
            int changed_inside = 0, changed_outside = 0;
            for (std::size_t i = 0; i < shape.pixels().size(); ++i) {
                const bool is_outside = shape.pixels()[i] == glm::u8vec4(0, 255, 0, 255);
                (is_outside ? changed_outside : changed_inside) += plain.pixels()[i] != outlined.pixels()[i];
            }
            EXPECT_EQ(changed_inside, 0) << component;
            EXPECT_GT(changed_outside, 300) << component;
        }
    }
}

TEST_F(HatchingTest, PlainPaperIsDrawnAsAnyOther) {
    for (const Style& style : toned_styles) {
        Stage stage(studio(), board_in_light(0.4, 100));
        const image::Image plain = stage.picture(toned(style, "clear_color 0.9 0.8 0.7 ;"));
        const image::Image kept =
            stage.picture("pass background p { color 0.9 0.8 0.7 ; } ; " + toned(style, "keep_color true ;"));
        EXPECT_LE(image::compare(plain, kept).maximum, 1) << style.component;
    }
}

TEST_F(HatchingTest, StrokesStayOnASurfaceThatMoves) {
    // Ten pixels to the right, in a pose: the picture is the same, ten pixels to the right.
    Stage stage(studio(), board_in_light(0.5, 200));
    const auto technique = studio().open(toned(toned_styles[3]));
    const image::Image before = stage.picture(*technique);
    model::Pose pose{{stage.model().meshes[0].positions, stage.model().meshes[0].normals}};
    for (glm::vec3& position : pose[0].positions) position.x += float(10 * 2.0 / (0.9 * 200));
    stage.scene().set_pose(pose);
    const image::Image after = stage.picture(*technique);
    double apart = 0;
    for (int y = 20; y < 180; ++y) {
        for (int x = 20; x < 160; ++x)
            apart = std::max(apart, double(std::abs(after.at(x + 10, y).x - before.at(x, y).x)));
    }
    EXPECT_LE(apart, 4);
}

// How often a row of the picture's middle goes from light to dark, a pixel.
double strokes_a_pixel(const image::Image& picture) {
    int changes = 0;
    for (int y = 70; y < 130; ++y) {
        for (int x = 70; x < 130; ++x) changes += picture.at(x, y).x >= 128 && picture.at(x + 1, y).x < 128;
    }
    return changes / 3600.0;
}

TEST_F(HatchingTest, StrokesOnTheSurfaceKeepTheirSizeFromNearAndFar) {
    std::vector<double> counts;
    for (double distance = 10; distance > 0.15; distance *= 0.8) {
        Shot shot = board_in_light(0.7, 200);
        shot.view.eye = glm::dvec3(0, 0, distance);
        shot.view.projection = model::Projection::perspective;
        counts.push_back(strokes_a_pixel(Stage(studio(), shot).picture(toned(toned_styles[3], "angle 90 ;"))));
    }
    const auto [fewest, most] = std::minmax_element(counts.begin(), counts.end());
    EXPECT_GT(*fewest, 0.02);
    EXPECT_LT(*most, 3 * *fewest) << "of the counts at distances from 10 to 0.15";
}

TEST_F(HatchingTest, TransparencyAtVerticesIsThresholdedAndInterpolated) {
    // Black strokes everywhere: the pixel is the opacity. The light's cosine is 0.4, so ink is 0.6.
    Stage stage(studio(), board_in_light(0.4, 60));
    const image::Image picture = stage.picture(fmt::format(
        "pass hatch_vertex s {{ {} strokes \"test_hatching:even\" ; scale 20 ; thresholds 0.2 1 ; }} ;", plain_tone));
    const int shade = picture.at(30, 30).x;
    const image::Image full = stage.picture(fmt::format(
        "pass hatch_vertex s {{ {} strokes \"test_hatching:even\" ; scale 20 ; thresholds 0 0.1 ; }} ;", plain_tone));
    EXPECT_NEAR(255 - shade, 0.5 * (255 - full.at(30, 30).x), 1);
}

TEST_F(HatchingTest, TheMapSaysHowTransparentTheStrokesAre) {
    const image::Image map = image::read(studio().resources().folders().find("textures/hatching", "ramp", ".png"));
    for (const double cosine : {0.0, 0.1, 0.3, 0.5, 0.58, 0.7, 0.95, 1.0}) {
        Stage stage(studio(), board_in_light(cosine, 300));
        const image::Image picture =
            stage.picture(fmt::format("pass hatch_projective s {{ {} highlight 0 ; }} ;", plain_tone));
        // The strokes' image has an ink share of two thirds.
        const double opacity = 1 - map.at(std::min(int(cosine * 256), 255), 0).x / 255.0;
        EXPECT_NEAR(1 - mean_tone(picture, 256), opacity * 2 / 3, 0.012) << cosine;
    }
}

// Seven even tones in two sizes: 10 to 50 between the first and the last.
image::Image tonal_image(int first, int last) {
    image::Image image(4, 14);
    for (int y = 0; y < 14; ++y) {
        const int tone = y < 2 ? first : y < 12 ? y / 2 * 10 : last;
        for (int x = 0; x < 4; ++x) image.at(x, y) = glm::u8vec4(std::uint8_t(tone));
    }
    return image;
}

TEST_F(HatchingTest, TellsOfStrokesThatDoNotFit) {
    EXPECT_EQ(error_of([] { (void)studio().open("pass hatch_screen s { strokes \"\" ; } ;"); }),
              "test.technique:1:1: pass \"s\": expected an image of strokes, found none");
    for (const auto& [width, height] : {std::pair(4, 10), {4, 4}}) {
        EXPECT_EQ(
            error_of([w = width, h = height] { (void)framework::cut_volume(image::Image(w, h), "a.png"); }),
            fmt::format("a.png: expected two or more square slices of a volume below each other, found {} x {} pixels",
                        width, height));
    }
    for (const auto& [first, last] : {std::pair(250, 0), {255, 4}, {0, 255}}) {
        EXPECT_EQ(error_of([a = first, b = last] { (void)framework::cut_tonal(tonal_image(a, b), "a.png"); }),
                  fmt::format("a.png: expected tones from white (255) to black (0), found {}.0 to {}.0", first, last));
    }
    for (const auto& [width, height] : {std::pair(6, 12), {8, 20}, {8, 18}, {1, 4}}) {
        EXPECT_EQ(error_of([w = width, h = height] { (void)framework::cut_tonal(image::Image(w, h), "a.png"); }),
                  fmt::format("a.png: expected 4, 7, 10, ... tones below each other, each half as high as the image is "
                              "wide, and that a power of two; found {} x {} pixels",
                              width, height));
    }
}

TEST_F(HatchingTest, TonalImagesAreCutIntoLayersOfFourTones) {
    const std::vector<gpu::Slices> levels = framework::cut_tonal(tonal_image(255, 0), "a.png");
    ASSERT_EQ(levels.size(), 2u);
    EXPECT_EQ(levels[0].pixels.size(), 2u * 2 * 2 * 4);
    EXPECT_EQ(levels[1].count, 2);
    EXPECT_EQ(levels[1].pixels, (std::vector<std::uint8_t>{255, 10, 20, 30, 30, 40, 50, 0}));
}

}  // namespace
}  // namespace croquis::components
