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
            fmt::format("pass comic_light c {{ softness 0 ; tones \"multiply\" ; shade_map \"toon:flat:0\" ; "
                        "highlight_size 25 ; highlight_color 1 0 0 ; {} }} ;",
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
            "rim_width 0.6 ; rim_color 0 0 1 ; rim_side \"" +
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
    const ModelPointer square = model_of({{"square", quad_corners({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0})}},
                                         {plain("white", glm::vec3(1))});
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
