// Cel shading (seed B, Cell Shading): exactly so many tones, by light interpolated from the vertices; and the edges of
// tones, antialiased over the area of a pixel.
#include <map>

#include "components/lit_sphere.h"

namespace croquis::components {
namespace {

using namespace testing;

using Cel = Shading;

double cosine(const Lit& lit, const glm::dvec3& normal, const glm::dvec3& position) {
    return glm::dot(normal, lit.to_light(position));
}

TEST_F(Cel, LevelsAreEven) {
    for (const int levels : {2, 3, 7, 16}) {
        for (const double darkest : {0.0, 0.25}) {
            expect_shaded(
                fmt::format("pass cel c {{ levels {} ; darkest {} ; softness 0 ; }} ;", levels, darkest), 1,
                [&](const Lit& lit, const RayCaster& rays, const Hit& hit) -> std::optional<glm::vec4> {
                    const double light =
                        interpolated(rays, hit, [&](const auto& n, const auto& p) { return cosine(lit, n, p); });
                    const double place = std::clamp(light, 0.0, 1.0) * levels;
                    const double step = std::round(place);
                    if (std::abs(place - step) < 1e-3 && step > 0 && step < levels) return std::nullopt;
                    const double level = std::min(std::floor(place), levels - 1.0) / (levels - 1.0);
                    const double tone = darkest + (1 - darkest) * level;
                    return glm::vec4(lit.light.color * lit.material.diffuse * float(tone), 1.0f);
                },
                0.08);
        }
    }
}

TEST_F(Cel, HasExactlySoManyTones) {
    for (const int levels : {2, 3, 5, 9, 16}) {
        Stage stage(studio(), {.model = icosphere(3, plain("white", glm::vec3(0.9f))), .width = 200, .height = 200});
        const image::Image picture =
            stage.picture(fmt::format("pass cel c {{ levels {} ; softness 0 ; clear_color 1 0 0 ; }} ;", levels));
        std::map<int, int> tones;
        for (const glm::u8vec4& p : picture.pixels()) {
            if (p.x == p.y) ++tones[p.x];
        }
        EXPECT_EQ(int(tones.size()), levels);
    }
}

TEST_F(Cel, TheTonesCanBeAMaps) {
    const image::Image map = map_image("toon", "four_tone");
    expect_shaded(
        "pass cel_mapped c { light_map \"toon:four_tone:0\" ; softness 0 ; } ;", 1,
        [&](const Lit& lit, const RayCaster& rays, const Hit& hit) -> std::optional<glm::vec4> {
            const double light =
                interpolated(rays, hit, [&](const auto& n, const auto& p) { return cosine(lit, n, p); });
            const double place = std::clamp(light, 0.0, 1.0) * map.width();
            if (std::abs(place - std::round(place)) < 2e-3) return std::nullopt;
            const glm::vec3 tone = glm::vec3(map.at(std::min(int(place), map.width() - 1), 0)) / 255.0f;
            return glm::vec4(lit.light.color * lit.material.diffuse * tone, 1.0f);
        },
        0.3);
}

// A square facing its light, in one colour with a texture of another.
TEST_F(Cel, TheTextureIsBlendedWithTheColour) {
    model::RawModel raw;
    model::RawMesh& mesh = raw.meshes.emplace_back();
    mesh.mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.mesh.texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.mesh.triangles = {0, 1, 2, 0, 2, 3};
    model::Material material = plain("tinted", {0.8f, 0.6f, 1.0f});
    material.texture = std::make_shared<image::Image>(2, 2, glm::u8vec4(51, 255, 102, 255));
    raw.materials.push_back(material);
    Stage stage(studio(), {.model = model::finish(std::move(raw), "square"),
                           .view = seen_from({0, 0, 1}),
                           .light = {framework::Light::Bound::world, framework::Light::Kind::direction, {0, 0, 1}}});
    for (const double share : {0.0, 0.5, 1.0}) {
        const image::Image picture = stage.picture(fmt::format("pass cel c {{ texture_share {} ; }} ;", share));
        const glm::dvec3 tint = 1.0 - share + share * glm::dvec3(0.2, 1.0, 0.4);
        const glm::dvec3 expected = 255.0 * tint * glm::dvec3(0.8, 0.6, 1.0);
        const glm::u8vec4 found = picture.at(picture.width() / 2, picture.height() / 2);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], 1.5) << share;
    }
}

// ---- The edges of tones
// ----------------------------------------------------------------------------------------------

// A sphere so finely cut that its silhouette is smooth; the same tones of each technique.
struct Softened {
    image::Image hard, soft;
    image::Image samples;  // hard, in 8 x 8 samples a pixel
    image::Image truth;    // their mean
};

class StepEdges : public Shading {
protected:
    static constexpr int size = 96, scale = 8;

    static Softened softened(const std::string& component, const std::string& settings) {
        const auto text = [&](const char* softness) {
            return "pass " + component + " c { clear_color 1 0 0 ; softness " + softness + " ; " + settings + " } ;";
        };
        const ModelPointer sphere = icosphere(3, plain("white", glm::vec3(0.9f)));
        Stage stage(studio(), {.model = sphere, .width = size, .height = size});
        Stage large(studio(), {.model = sphere, .width = size * scale, .height = size * scale});
        Softened pictures{stage.picture(text("0")), stage.picture(text("1")), large.picture(text("0")),
                          image::Image(size, size)};
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                glm::vec4 sum(0.0f);
                for (int i = 0; i < scale * scale; ++i) {
                    sum += glm::vec4(pictures.samples.at(x * scale + i % scale, y * scale + i / scale));
                }
                pictures.truth.at(x, y) = glm::u8vec4(sum / float(scale * scale) + 0.5f);
            }
        }
        return pictures;
    }

    // The sphere is grey, what lies behind it red.
    static bool is_background(const glm::u8vec4& pixel) { return pixel.x != pixel.y; }

    // Within a level of the samples of a pixel and its neighbours.
    static bool is_between_tones(const Softened& pictures, int x, int y) {
        int low = 255, high = 0;
        for (int v = (y - 1) * scale; v < (y + 2) * scale; ++v) {
            for (int u = (x - 1) * scale; u < (x + 2) * scale; ++u) {
                const glm::u8vec4 sample = pictures.samples.at(u, v);
                if (is_background(sample)) continue;
                low = std::min(low, int(sample.x));
                high = std::max(high, int(sample.x));
            }
        }
        const int soft = pictures.soft.at(x, y).x;
        return soft + 1 >= low && soft <= high + 1;
    }

    // True where the pixel and its neighbours lie on the sphere: the silhouette is no step of tones.
    static bool is_inside(const image::Image& picture, int x, int y) {
        for (int v = y - 1; v <= y + 1; ++v) {
            for (int u = x - 1; u <= x + 1; ++u) {
                if (u < 0 || v < 0 || u >= size || v >= size) return false;
                if (is_background(picture.at(u, v))) return false;
            }
        }
        return true;
    }
};

const std::vector<std::pair<std::string, std::string>> stepped{
    {"cel", "levels 4 ;"},
    {"comic", "tones \"multiply\" ; shade_map \"shade:three_shares:0\" ;"},
    {"comic_extended", "full_light 1 ; shininess 8 ; shade_map \"shade:banded:0\" ;"},
    {"render_toon_soft", "toon_map \"toon:four_tone:0\" ;"}};

TEST_F(StepEdges, AreTheMeanOverThePixel) {
    for (const auto& [component, settings] : stepped) {
        const Softened pictures = softened(component, settings);
        double hard_error = 0, soft_error = 0;
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                if (!is_inside(pictures.hard, x, y)) continue;
                hard_error += std::abs(int(pictures.hard.at(x, y).y) - int(pictures.truth.at(x, y).y));
                soft_error += std::abs(int(pictures.soft.at(x, y).y) - int(pictures.truth.at(x, y).y));
            }
        }
        EXPECT_GT(hard_error, 1000) << component;
        EXPECT_LT(soft_error, 0.35 * hard_error) << component;
    }
}

// A pixel lies between the tones that are seen around it: no fringe of a third one. At the silhouette its area reaches
// over the edge of the surface, and a few pixels show some of a tone that begins beyond.
TEST_F(StepEdges, AddNoFringes) {
    for (const auto& [component, settings] : stepped) {
        const Softened pictures = softened(component, settings);
        int fringes = 0, fringes_of_silhouette = 0, silhouette = 0;
        for (int y = 1; y + 1 < size; ++y) {
            for (int x = 1; x + 1 < size; ++x) {
                if (is_background(pictures.soft.at(x, y))) continue;
                const bool inside = is_inside(pictures.soft, x, y);
                silhouette += inside ? 0 : 1;
                if (is_between_tones(pictures, x, y)) continue;
                ++(inside ? fringes : fringes_of_silhouette);
            }
        }
        EXPECT_EQ(fringes, 0) << component;
        EXPECT_LE(fringes_of_silhouette, 0.03 * silhouette) << component;
    }
}

}  // namespace
}  // namespace croquis::components
