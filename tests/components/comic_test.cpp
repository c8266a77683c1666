// Comic shading against seed A in double precision: indices interpolated from the vertices (3.3), tones by hue,
// saturation and brightness (table 5), specular light by equation 2 and by the direct form of equation 1b.
#include <set>

#include "components/lit_sphere.h"
#include "image/palette.h"

namespace croquis::components {
namespace {

using namespace testing;

// ---- Hue, saturation, brightness, by their definition: hue in sixths of a turn
// ---------------------------------------

struct Hsb {
    double hue = 0, saturation = 0, brightness = 0;
};

Hsb to_hsb(const glm::dvec3& c) {
    const double high = std::max({c.r, c.g, c.b}), spread = high - std::min({c.r, c.g, c.b});
    if (spread == 0) return {0, 0, high};
    double hue = 4 + (c.r - c.g) / spread;
    if (high == c.g) hue = 2 + (c.b - c.r) / spread;
    if (high == c.r) hue = (c.g - c.b) / spread;
    return {std::fmod(hue + 6, 6.0), spread / high, high};
}

glm::dvec3 to_rgb(const Hsb& c) {
    const auto channel = [&](double n) {
        const double k = std::fmod(n + c.hue, 6.0);
        return c.brightness * (1 - c.saturation * std::max(0.0, std::min({k, 4 - k, 1.0})));
    };
    return {channel(5), channel(3), channel(1)};
}

// Table 5: in the dark the brightness falls and the saturation rises; but a dark colour's falls less, a grey's rises
// not.
glm::dvec3 darkened(const glm::dvec3& color, double shade, double darkening, double gain) {
    Hsb hsb = to_hsb(color);
    hsb.saturation = std::clamp(hsb.saturation + shade * std::min(gain, hsb.saturation), 0.0, 1.0);
    const double share = hsb.brightness >= 0.5 ? 1.0 : hsb.brightness / 0.5;
    hsb.brightness = std::max(hsb.brightness - shade * darkening * share, 0.0);
    return to_rgb(hsb);
}

// ---- Light at the vertices
// -------------------------------------------------------------------------------------------

double n_dot_l(const Lit& lit, const glm::dvec3& normal, const glm::dvec3& position) {
    return glm::dot(normal, lit.to_light(position));
}

// Equation 1b: the light mirrored at the surface, times the vector to the eye.
double r_dot_v_direct(const glm::dvec3& normal, const glm::dvec3& to_light, const glm::dvec3& to_eye) {
    return glm::dot(glm::reflect(-to_light, normal), to_eye);
}

// The mirror of specular.glsl: equation 2.
double r_dot_v_expanded(double l_dot_v, double n_dot_l, double n_dot_v) { return 2.0 * n_dot_l * n_dot_v - l_dot_v; }

// The texel of a map at an index, or nothing where rounding decides between two that differ.
std::optional<int> texel(double index, int texels) {
    const double place = std::clamp(index, 0.0, 1.0) * texels;
    const bool is_between = std::abs(place - std::round(place)) < 2e-3;
    if (is_between && place > 0.5 && place < texels - 0.5) return std::nullopt;
    return std::clamp(int(place), 0, texels - 1);
}

glm::dvec3 map_color(const image::Image& map, int column, int row_from_below) {
    return glm::dvec3(map.at(column, map.height() - 1 - row_from_below)) / 255.0;
}

glm::vec4 opaque(const glm::dvec3& color) { return {glm::clamp(glm::vec3(color), 0.0f, 1.0f), 1.0f}; }

using Comic = Shading;

TEST_F(Comic, InterpolatesTheIndexAndDarkensByTable5) {
    const image::Image map = map_image("shade", "three_shares");
    for (const auto& [darkening, gain] : {std::pair(0.242, 0.12), std::pair(0.155, 0.042), std::pair(0.9, -0.3)}) {
        expect_shaded(
            fmt::format("pass comic c {{ shade_map \"shade:three_shares:0\" ; softness 0 ; darkening {} ; "
                        "saturation_gain {} ; }} ;",
                        darkening, gain),
            1,
            [&, d = darkening, g = gain](const Lit& lit, const RayCaster& rays,
                                         const Hit& hit) -> std::optional<glm::vec4> {
                const double index =
                    interpolated(rays, hit, [&](const auto& n, const auto& p) { return n_dot_l(lit, n, p); });
                const auto column = texel(index, map.width());
                if (!column) return std::nullopt;
                const glm::dvec3 color =
                    darkened(glm::dvec3(lit.material.diffuse), 1.0 - map_color(map, *column, 0).r, d, g);
                return opaque(glm::dvec3(lit.light.color) * color);
            },
            0.08);
    }
}

// A square in shadow, in colours of all kinds: dark, grey, nearly grey, saturated.
TEST_F(Comic, DarkensAnyColour) {
    const std::vector<glm::vec3> colors{{0.9f, 0.2f, 0.2f},  {0.2f, 0.1f, 0.15f}, {0.7f, 0.7f, 0.7f},
                                        {0.62f, 0.6f, 0.6f}, {0.0f, 1.0f, 1.0f},  {0.0f, 0.0f, 0.0f},
                                        {1.0f, 1.0f, 1.0f},  {0.3f, 0.35f, 0.9f}};
    for (const glm::vec3& color : colors) {
        const auto square = model_of({{"square", quad_corners({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0})}},
                                     {plain("coloured", color)});
        Stage stage(studio(), {.model = square,
                               .view = seen_from({0, 0, 1}),
                               .light = {Light::Bound::world, Light::Kind::direction, {0, 0, -1}}});
        const image::Image picture = stage.picture("pass comic c {} ;");
        const glm::dvec3 expected = 255.0 * darkened(glm::dvec3(color), 1.0, 0.242, 0.12);
        const glm::u8vec4 found = picture.at(picture.width() / 2, picture.height() / 2);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(found[c], expected[c], 0.6) << color.r << " " << color.g << " " << color.b;
    }
}

TEST_F(Comic, MultipliesColouredMapsAndTurnsWhiteAboveFullLight) {
    const image::Image map = map_image("toon", "spectrum");
    expect_shaded(
        "pass comic c { shade_map \"toon:spectrum:0\" ; softness 0 ; tones \"multiply\" ; full_light 0.7 ; } ;", 1,
        [&](const Lit& lit, const RayCaster& rays, const Hit& hit) -> std::optional<glm::vec4> {
            const auto column = texel(
                interpolated(rays, hit, [&](const auto& n, const auto& p) { return n_dot_l(lit, n, p); }), map.width());
            if (!column) return std::nullopt;
            glm::dvec3 color;
            for (int c = 0; c < 3; ++c) {
                const double tone = map_color(map, *column, 0)[c], own = double(lit.material.diffuse[c]);
                color[c] = tone <= 0.7 ? own * tone / 0.7 : own + (1 - own) * (tone - 0.7) / 0.3;
            }
            return opaque(glm::dvec3(lit.light.color) * color);
        },
        0.3);
}

TEST_F(Comic, EquationTwoEqualsTheDirectForm) {
    const Random random(1, "vectors");
    std::uint64_t i = 0;
    const auto unit = [&] {
        glm::dvec3 v(random.between(-1, 1, i), random.between(-1, 1, i + 1), random.between(-1, 1, i + 2));
        i += 3;
        return glm::normalize(v);
    };
    for (int trial = 0; trial < 1000; ++trial) {
        const glm::dvec3 n = unit(), l = unit(), v = unit();
        EXPECT_NEAR(r_dot_v_expanded(glm::dot(l, v), glm::dot(n, l), glm::dot(n, v)), r_dot_v_direct(n, l, v), 1e-14);
    }
}

// The red of the additive map is the specular light, its green the diffuse: the direct form says what they must be.
class ComicExtended : public Shading {
protected:
    using Vectors = std::function<std::pair<glm::dvec3, glm::dvec3>(const Lit&, const glm::dvec3&)>;  // light, eye
    static void expect_extended(const std::string& settings, double exponent, const Vectors& vectors) {
        const image::Image map = map_image("shade", "additive");
        expect_shaded(
            "pass comic_extended c { shade_map \"shade:additive:0\" ; softness 0 ; color_share 0 ; full_light 1 ; " +
                settings + " } ;",
            1,
            [&](const Lit& lit, const RayCaster& rays, const Hit& hit) -> std::optional<glm::vec4> {
                const double diffuse =
                    interpolated(rays, hit, [&](const auto& n, const auto& p) { return n_dot_l(lit, n, p); });
                const double specular = interpolated(rays, hit, [&](const auto& n, const auto& p) {
                    const auto [to_light, to_eye] = vectors(lit, p);
                    // L·V by the chosen vectors, N·L by the light's own.
                    const glm::dvec3 own_light = lit.to_light(p);
                    const double reflected =
                        own_light == to_light
                            ? r_dot_v_direct(n, to_light, to_eye)
                            : r_dot_v_expanded(glm::dot(to_light, to_eye), glm::dot(n, own_light), glm::dot(n, to_eye));
                    return std::pow(std::max(reflected, 0.0), exponent);
                });
                if (std::abs(diffuse) < 2e-3) return std::nullopt;
                const auto column = texel(diffuse, map.width()), row = texel(diffuse > 0 ? specular : 0, map.height());
                if (!column || !row) return std::nullopt;
                return opaque(glm::dvec3(lit.light.color) * map_color(map, *column, *row));
            },
            0.2);
    }
};

TEST_F(ComicExtended, SpecularLightIsTheDirectForm) {
    for (const double exponent : {1.0, 6.0, 40.0}) {
        expect_extended(fmt::format("shininess {} ;", exponent), exponent,
                        [](const Lit& lit, const glm::dvec3& p) { return std::pair(lit.to_light(p), lit.to_eye(p)); });
    }
}

TEST_F(ComicExtended, ShininessZeroIsTheMaterials) {
    expect_extended("shininess 0 ;", double(glossy().shininess),
                    [](const Lit& lit, const glm::dvec3& p) { return std::pair(lit.to_light(p), lit.to_eye(p)); });
}

TEST_F(ComicExtended, LightAtEachPixelIsTheDirectForm) {
    const image::Image map = map_image("shade", "additive");
    expect_shaded(
        "pass comic_extended_per_pixel c { shade_map \"shade:additive:0\" ; softness 0 ; color_share 0 ; full_light 1 "
        "; "
        "shininess 6 ; } ;",
        1,
        [&](const Lit& lit, const RayCaster&, const Hit& hit) -> std::optional<glm::vec4> {
            const glm::dvec3 to_light = lit.to_light(hit.position);
            const double reflected = r_dot_v_direct(hit.normal, to_light, lit.to_eye(hit.position));
            const auto column = texel(glm::dot(hit.normal, to_light), map.width());
            const auto row = texel(std::pow(std::max(reflected, 0.0), 6.0), map.height());
            if (!column || !row) return std::nullopt;
            return opaque(glm::dvec3(lit.light.color) * map_color(map, *column, *row));
        },
        0.2);
}

// Light from behind is mirrored towards the eye by the surfaces that it does not reach.
TEST_F(ComicExtended, NothingShinesOnTheUnlitSide) {
    const framework::Light light{framework::Light::Bound::world, framework::Light::Kind::direction, {0.2, -0.3, -1}};
    Stage stage(studio(), {.model = icosphere(3), .view = seen_from({0, 0, 1}), .light = light});
    const Lit lit{stage.model().materials.front(), stage.camera(), light};
    const RayCaster rays(stage.model(), stage.camera(), stage.width(), stage.height());
    for (const std::string component : {"comic_extended", "comic_extended_per_pixel"}) {
        const image::Image picture =
            stage.picture("pass " + component +
                          " c { shade_map \"shade:additive:0\" ; color_share 0 ; full_light 1 ; softness 0 ; } ;");
        int mirrored = 0;
        expect_pixels(
            picture,
            [&](int x, int y) -> std::optional<glm::vec4> {
                const auto hit = rays.is_certain(x, y) ? rays.pixel(x, y) : std::nullopt;
                if (!hit) return std::nullopt;
                const glm::dvec3 to_light = lit.to_light(hit->position);
                if (glm::dot(hit->normal, to_light) > -0.02) return std::nullopt;
                mirrored += r_dot_v_direct(hit->normal, to_light, lit.to_eye(hit->position)) > 0.9;
                return glm::vec4(0, 0, 0, 1);
            },
            1.5, 1.0);
        EXPECT_GT(mirrored, 20) << "pixels where the equation alone would shine";
    }
}

// Figure 25b.
TEST_F(ComicExtended, AConstantViewVectorIsTheCentres) {
    expect_extended("shininess 6 ; view_vector \"constant\" ;", 6, [](const Lit& lit, const glm::dvec3&) {
        return std::pair(lit.to_light(glm::dvec3(0.0)), lit.to_eye(glm::dvec3(0.0)));
    });
}

// ---- Colours of surfaces
// ---------------------------------------------------------------------------------------------

ModelPointer coloured_square() {
    model::RawModel raw;
    model::RawMesh& mesh = raw.meshes.emplace_back();
    mesh.mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.mesh.colors = {{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}, {255, 255, 0, 255}};
    mesh.mesh.triangles = {0, 1, 2, 0, 2, 3};
    raw.materials.push_back(plain("coloured", glm::vec3(1.0f)));
    return model::finish(std::move(raw), "square");
}

std::set<std::array<int, 3>> colors_of(const image::Image& picture) {
    std::set<std::array<int, 3>> colors;
    for (const glm::u8vec4& p : picture.pixels()) colors.insert({p.x, p.y, p.z});
    return colors;
}

TEST_F(Comic, EachTriangleHasOneColour) {
    Stage stage(studio(), {.model = coloured_square(), .view = seen_from({0, 0, 1})});
    const image::Image picture = stage.picture("pass comic_surface c {} ;");
    // The means of red, green and blue and of red, blue and yellow, and the background.
    const std::set<std::array<int, 3>> expected{{85, 85, 85}, {170, 85, 85}, {255, 255, 255}};
    EXPECT_EQ(colors_of(picture), expected);
    EXPECT_EQ(colors_of(stage.picture("pass comic_surface c { orientation \"triangles_exact\" ; } ;")), expected);
}

// A square with a texture of noise.
ModelPointer textured_square(const std::shared_ptr<const image::Image>& texture) {
    model::RawModel raw;
    model::RawMesh& mesh = raw.meshes.emplace_back();
    mesh.mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.mesh.texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.mesh.triangles = {0, 1, 2, 0, 2, 3};
    model::Material material = plain("textured", glm::vec3(1.0f));
    material.texture = texture;
    raw.materials.push_back(material);
    return model::finish(std::move(raw), "square");
}

std::shared_ptr<const image::Image> noise() {
    const Random random(3, "texture");
    auto pixels = std::make_shared<image::Image>(32, 32);
    for (std::size_t i = 0; i < pixels->pixels().size(); ++i) {
        pixels->pixels()[i] = {random.unit(3 * i) * 255, random.unit(3 * i + 1) * 255, random.unit(3 * i + 2) * 255,
                               255};
    }
    return pixels;
}

TEST_F(Comic, TextureColoursAreThePalettes) {
    const auto texture = noise();
    const auto few = std::make_shared<const image::Image>(image::with_fewer_colors(*texture, 5));
    Stage own(studio(), {.model = textured_square(texture), .view = seen_from({0, 0, 1})});
    Stage reduced(studio(), {.model = textured_square(few), .view = seen_from({0, 0, 1})});
    const std::string as_it_is = "pass comic_surface c {} ;";
    EXPECT_EQ(own.picture("pass comic_surface c { texture_colors 5 ; } ;"), reduced.picture(as_it_is));
    EXPECT_NE(own.picture(as_it_is), reduced.picture(as_it_is));
}

TEST_F(Comic, ATextureIsReducedOnce) {
    Stage stage(studio(), {.model = textured_square(noise()), .view = seen_from({0, 0, 1})});
    const auto technique = studio().open("pass comic_surface c { texture_colors 5 ; } ;");
    stage.draw(*technique);
    const auto uploads = studio().counters().texture_uploads;
    stage.draw(*technique);
    EXPECT_EQ(studio().counters().texture_uploads, uploads);
}

// ---- Face orientation
// ------------------------------------------------------------------------------------------------

TEST_F(Comic, ChosenFacesFillThePictureWhereTheyLeaveNoHoles) {
    Stage stage(studio(), {.model = icosphere(2)});
    const image::Image exact = stage.picture("pass comic c {} ;");
    for (const std::string method : {"triangles_exact", "triangles_corrected", "vertices_one", "marked_all"}) {
        EXPECT_EQ(stage.picture("pass comic c { orientation \"" + method + "\" ; } ;"), exact) << method;
    }
    EXPECT_NE(stage.picture("pass comic c { orientation \"marked_some\" ; } ;"), exact);
    EXPECT_EQ(stage.picture("pass comic c {} ;"), exact) << "afterwards";
}

TEST_F(Comic, AnOpenMeshShowsItsBackWhateverTheChoice) {
    Stage stage(studio(), {.model = coloured_square(), .view = seen_from({0.3, 0.2, -1})});
    EXPECT_EQ(stage.picture("pass comic c { orientation \"triangles_exact\" ; } ;"),
              stage.picture("pass comic c {} ;"));
}

}  // namespace
}  // namespace croquis::components
