// Drawn light against its equations in double precision: highlights whose half vector is moved, stretched, split and
// squared (Anjyo and Hiramitsu, 2003), rims, and shadow sides.
#include "components/lit_sphere.h"

namespace croquis::components {
namespace {

using namespace testing;

constexpr double degrees = 3.14159265358979323846 / 180.0;

struct Style {
    const char* settings;
    glm::dvec2 shift{0.0}, stretch{0.0}, split{0.0};
    double turn = 0, squareness = 0;
    int sharpness = 4;
};

// The paper's steps one after another, on the picture's right and up laid on the surface.
glm::dvec3 styled(glm::dvec3 h, const glm::dvec3& normal, const glm::dvec3& picture_right, const Style& style) {
    glm::dvec3 u = glm::normalize(picture_right - glm::dot(picture_right, normal) * normal);
    glm::dvec3 v = glm::cross(normal, u);
    h = glm::normalize(h - style.shift.x * u - style.shift.y * v);
    const double c = std::cos(style.turn * degrees), s = std::sin(style.turn * degrees);
    std::tie(u, v) = std::pair(c * u + s * v, c * v - s * u);
    h = glm::normalize(h - style.stretch.x * glm::dot(h, u) * u);
    h = glm::normalize(h - style.stretch.y * glm::dot(h, v) * v);
    h = glm::normalize(h - style.split.x * glm::sign(glm::dot(h, u)) * u -
                       style.split.y * glm::sign(glm::dot(h, v)) * v);
    const double angle = std::atan2(glm::dot(h, v), glm::dot(h, u));
    const double squared = std::pow(std::abs(std::sin(2 * angle)), style.sharpness);
    return glm::normalize(h - style.squareness * squared * (glm::dot(h, u) * u + glm::dot(h, v) * v));
}

using ComicLight = Shading;

TEST_F(ComicLight, HighlightsFollowThePaper) {
    const std::vector<Style> styles{
        {.settings = ""},
        {.settings = "highlight_shift 0.2 -0.1 ;", .shift = {0.2, -0.1}},
        {.settings = "highlight_stretch 0.7 -0.5 ;", .stretch = {0.7, -0.5}},
        {.settings = "highlight_split 0.1 0.15 ;", .split = {0.1, 0.15}},
        {.settings = "highlight_squareness 0.8 ; highlight_sharpness 3 ;", .squareness = 0.8, .sharpness = 3},
        {.settings = "highlight_stretch 0.5 0 ; highlight_turn 30 ; highlight_split 0.05 0 ;",
         .stretch = {0.5, 0.0},
         .split = {0.05, 0.0},
         .turn = 30}};
    for (const Style& style : styles) {
        SCOPED_TRACE(style.settings);
        expect_shaded(
            fmt::format(
                "pass comic_light c {{ softness 0 ; tones \"multiply\" ; shade_map \"toon:flat:0\" ; "
                "highlight_size 25 ; highlight_color 1 0 0 ; highlight_reach 10000 ; highlight_detail 0 ; {} }} ;",
                style.settings),
            1,
            [&](const Lit& lit, const RayCaster&, const Hit& hit) -> std::optional<glm::vec4> {
                const glm::dvec3 half = glm::normalize(lit.to_light(hit.position) + lit.to_eye(hit.position));
                const double above =
                    glm::dot(hit.normal, styled(half, hit.normal, lit.camera.right, style)) - std::cos(25 * degrees);
                if (std::abs(above) < 2e-3) return std::nullopt;
                if (above > 0) return glm::vec4(1, 0, 0, 1);
                return glm::vec4(lit.light.color * lit.material.diffuse, 1.0f);
            },
            0.08);
    }
}

TEST_F(ComicLight, RimsLieWhereTheSurfaceTurnsAway) {
    for (const std::string side : {"lit", "all", "shadow"}) {
        expect_shaded(
            "pass comic_light c { softness 0 ; tones \"multiply\" ; shade_map \"toon:flat:0\" ; rim_strength 0.5 ; "
            "rim_width 0.6 ; rim_reach 10000 ; rim_color 0 0 1 ; rim_side \"" +
                side + "\" ; } ;",
            1,
            [&](const Lit& lit, const RayCaster& rays, const Hit& hit) -> std::optional<glm::vec4> {
                const double facing = glm::dot(hit.normal, lit.to_eye(hit.position));
                const double light =
                    interpolated(rays, hit, [&](const auto& n, const auto& p) { return glm::dot(n, lit.to_light(p)); });
                if (std::abs(facing - 0.6) < 2e-3 || std::abs(light) < 2e-3) return std::nullopt;
                const bool on_side = side == "all" || (light > 0) == (side == "lit");
                const glm::vec3 own = lit.light.color * lit.material.diffuse;
                return glm::vec4(facing < 0.6 && on_side ? glm::mix(own, glm::vec3(0, 0, 1), 0.5f) : own, 1.0f);
            },
            0.08);
    }
}

const std::string red_highlight =
    "softness 0 ; tones \"multiply\" ; shade_map \"toon:flat:0\" ; highlight_color 1 0 0 ; ";

ModelPointer white_square() {
    return model_of({{"square", quad_corners({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0})}},
                    {plain("white", glm::vec3(1))});
}

int count_of(const image::Image& picture, const glm::u8vec4& color) {
    return int(std::count(picture.pixels().begin(), picture.pixels().end(), color));
}

// Lit along the view, a face mirrors the light around its middle: in a circle of the reach where the angle would allow
// all of it.
TEST_F(ComicLight, OnAFlatFaceTheHighlightKeepsToItsReach) {
    Stage stage(studio(), {.model = white_square(),
                           .view = seen_from({0, 0, 1}),
                           .light = {framework::Light::Bound::world, framework::Light::Kind::direction, {0, 0, 1}},
                           .width = 200,
                           .height = 200});
    const glm::u8vec4 red(255, 0, 0, 255);
    const auto covered = [&](const std::string& reach) {
        return count_of(stage.picture("pass comic_light c { clear_color 0 0 0 ; highlight_size 40 ; highlight_reach " +
                                      reach + " ; " + red_highlight + " } ;"),
                        red);
    };
    const int black = count_of(stage.picture("pass comic_light c { clear_color 0 0 0 ; } ;"), {0, 0, 0, 255});
    EXPECT_EQ(covered("10000"), 200 * 200 - black);
    for (const double reach : {10.0, 25.0}) {
        const double circle = 3.14159265 * reach * reach;
        EXPECT_NEAR(covered(std::to_string(reach)), circle, 0.1 * circle);
    }
}

TEST_F(ComicLight, SmallHighlightsAreWhole) {
    Stage stage(studio(), {.model = icosphere(3)});
    const auto picture = [&](const std::string& settings) {
        return stage.picture("pass comic_light c { highlight_size 10 ; " + red_highlight + settings + " } ;");
    };
    const std::string window = "highlight_split 0.2 0.2 ; highlight_squareness 0.29 ; ";
    EXPECT_EQ(picture(window + "highlight_detail 10000 ;"), picture(""));
    EXPECT_NE(picture(window + "highlight_detail 0 ;"), picture(""));
}

// On a sphere of R pixels, N·V is the root of 1 - r^2 / R^2.
TEST_F(ComicLight, RimsKeepToTheirReach) {
    Stage stage(studio(), {.model = icosphere(4),
                           .view = seen_from({0, 0, 1}, model::Projection::parallel),
                           .width = 240,
                           .height = 240});
    const image::Image picture = stage.picture(
        "pass comic_light c { tones \"multiply\" ; shade_map \"toon:flat:0\" ; softness 0 ; rim_strength 1 ; rim_width "
        "1 ; "
        "rim_color 0 0 1 ; rim_side \"all\" ; rim_reach 10 ; } ;");
    const double radius = std::sqrt((240 * 240 - count_of(picture, {255, 255, 255, 255})) / 3.14159265);
    int near = 0, far = 0;
    for (int y = 0; y < 240; ++y) {
        for (int x = 0; x < 240; ++x) {
            const double from_contour = radius - std::hypot(x + 0.5 - 120, y + 0.5 - 120);
            const bool is_blue = picture.at(x, y) == glm::u8vec4(0, 0, 255, 255);
            if (from_contour > 2 && from_contour < 7) near += is_blue ? 1 : -20;
            if (from_contour > 18) far += is_blue;
        }
    }
    EXPECT_GT(near, 0) << "all but one in twenty";
    EXPECT_EQ(far, 0);
}

TEST_F(ComicLight, AGrazingFaceIsNoRim) {
    Stage stage(studio(), {.model = white_square(), .view = seen_from({1, 0, 0.15}), .width = 400, .height = 400});
    const std::string settings =
        "tones \"multiply\" ; shade_map \"toon:flat:0\" ; rim_strength 1 ; rim_width 0.6 ; rim_color 0 0 1 ; rim_side "
        "\"all\" ; ";
    const glm::u8vec4 blue(0, 0, 255, 255);
    EXPECT_GT(count_of(stage.picture("pass comic_light c { rim_reach 10000 ; " + settings + " } ;"), blue), 100);
    EXPECT_EQ(count_of(stage.picture("pass comic_light c { rim_reach 24 ; " + settings + " } ;"), blue), 0);
}

// A square whose light falls at one angle everywhere: its tone is known, and hatching must have it in the mean.
double mean_of_square(const image::Image& picture) {
    double sum = 0;
    int count = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            if (picture.at(x, y).y == 0 && picture.at(x, y).x == 255) continue;  // background
            sum += picture.at(x, y).x / 255.0;
            ++count;
        }
    }
    return sum / count;
}

TEST_F(ComicLight, TheMeanOfTheHatchingIsItsShare) {
    const ModelPointer square = white_square();
    for (const double share : {0.0, 0.05, 0.2, 0.5, 0.8, 0.95, 1.0}) {
        const double n_dot_l = 0.9 - 0.8 * share;
        const glm::dvec3 light(std::sqrt(1 - n_dot_l * n_dot_l), 0.0, n_dot_l);
        Stage stage(studio(), {.model = square,
                               .view = seen_from({0, 0, 1}),
                               .light = {framework::Light::Bound::world, framework::Light::Kind::direction, light},
                               .width = 300,
                               .height = 300});
        const std::string light_side =
            "tones \"multiply\" ; shade_map \"toon:flat:0\" ; shadow_edge 0.9 ; shadow_depth 0.8 ; clear_color 1 0 0 "
            "; ";
        for (const std::string shadow : {"shadow \"hatched\" ; hatching_angle 30 ;", "shadow \"ramped\" ;"}) {
            EXPECT_NEAR(mean_of_square(stage.picture("pass comic_light c { " + light_side + shadow + " } ;")),
                        1.0 - share, 0.02)
                << shadow;
        }
    }
}

}  // namespace
}  // namespace croquis::components
