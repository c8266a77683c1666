// Shading pixel by pixel against seed C's equations 4.1-4.6 in double precision, on surfaces found by rays (row C2).
#include <fmt/format.h>

#include "components/cross.h"
#include "image/image.h"
#include "support/ray_cast.h"
#include "support/studio.h"

namespace croquis::components {
namespace {

using namespace test_support;
using framework::Light;

struct Factors {
    double diffuse = 0, specular = 0;
};

struct Lit {
    const model::Material& material;
    const model::Camera& camera;
    const Light& light;

    [[nodiscard]] glm::dvec3 to_light(const glm::dvec3& position) const {
        glm::dvec3 place = light.place;
        if (light.bound == Light::Bound::viewer) {
            place = camera.right * place.x + camera.up * place.y + camera.back * place.z;
        }
        return glm::normalize(light.kind == Light::Kind::point ? place - position : place);
    }
    [[nodiscard]] glm::dvec3 to_eye(const glm::dvec3& position) const {
        return camera.projection == model::Projection::parallel ? camera.back : glm::normalize(camera.eye - position);
    }
    // Equations 4.2 and 4.3.
    [[nodiscard]] Factors factors(const glm::dvec3& normal, const glm::dvec3& position) const {
        const glm::dvec3 l = to_light(position), h = glm::normalize(l + to_eye(position));
        const double n_l = glm::dot(normal, l), n_h = glm::dot(normal, h);
        return {std::max(n_l, 0.0), n_l < 0 || n_h < 0 ? 0.0 : std::pow(n_h, double(material.shininess))};
    }
    // Equations 4.4 and 4.5.
    [[nodiscard]] double intensity(const Factors& f) const {
        return f.diffuse + f.specular * (0.3 * double(material.specular.r) + 0.6 * double(material.specular.g) +
                                         0.1 * double(material.specular.b));
    }
    // Equation 4.1.
    [[nodiscard]] glm::vec4 phong(const Factors& f) const {
        const glm::dvec3 color =
            glm::dvec3(material.ambient) + glm::dvec3(light.color) * (f.diffuse * glm::dvec3(material.diffuse) +
                                                                      f.specular * glm::dvec3(material.specular));
        return {glm::clamp(glm::vec3(color), 0.0f, 1.0f), 1.0f};
    }
    // Equation 4.6; nothing where rounding decides between two tones.
    [[nodiscard]] std::optional<glm::vec4> toon(double i, const image::Image& map) const {
        const double texel = std::clamp(i, 0.0, 1.0) * map.width();
        const bool is_step = std::abs(texel - std::round(texel)) < 2e-3;
        if (is_step && texel > 0.5 && texel < map.width() - 0.5) return std::nullopt;
        const int column = std::clamp(int(texel), 0, map.width() - 1);
        const glm::vec3 stepped = glm::vec3(map.at(column, 0)) / 255.0f;
        return glm::vec4(glm::clamp(material.ambient + light.color * stepped * material.diffuse, 0.0f, 1.0f), 1.0f);
    }
};

struct Setting {
    const char* name;
    model::Projection projection;
    Light light;
};

std::vector<Setting> settings() {
    using Bound = Light::Bound;
    using Kind = Light::Kind;
    std::vector<Setting> settings;
    for (const auto projection : {model::Projection::perspective, model::Projection::parallel}) {
        settings.push_back({"viewer", projection, {}});
        settings.push_back(
            {"world", projection, {Bound::world, Kind::direction, {0.9, 0.2, -0.3}, {1.0f, 0.9f, 0.8f}}});
        settings.push_back({"point", projection, {Bound::world, Kind::point, {0.4, 1.1, 0.9}, {0.7f, 1.0f, 0.9f}}});
    }
    return settings;
}

class Shading : public StudioTest {
protected:
    // Draws a sphere in each setting and compares it with what `truth` says of each hit.
    using Truth = std::function<std::optional<glm::vec4>(const Lit&, const RayCaster&, const Hit&)>;
    static void expect_shaded(const std::string& text, int subdivisions, const Truth& truth, double undecided = 0.05) {
        for (const Setting& setting : settings()) {
            SCOPED_TRACE(fmt::format("{} light, {}", setting.name,
                                     setting.projection == model::Projection::parallel ? "parallel" : "perspective"));
            Stage stage(studio(), {.model = icosphere(subdivisions),
                                   .view = seen_from({1, 0.5, 1}, setting.projection),
                                   .light = setting.light});
            const Lit lit{stage.model().materials.front(), stage.camera(), setting.light};
            const RayCaster rays(stage.model(), stage.camera(), stage.width(), stage.height());
            expect_pixels(
                stage.picture(text),
                [&](int x, int y) -> std::optional<glm::vec4> {
                    if (!rays.is_certain(x, y)) return std::nullopt;
                    const auto hit = rays.pixel(x, y);
                    return hit ? truth(lit, rays, *hit) : glm::vec4(1);
                },
                1.5, undecided);
        }
    }

    // A value at each corner of the hit's triangle, interpolated.
    template <typename AtVertex>
    static double interpolated(const RayCaster& rays, const Hit& hit, const AtVertex& at_vertex) {
        const RayCaster::Triangle& triangle = rays.triangle(hit);
        double sum = 0;
        for (int c = 0; c < 3; ++c) sum += hit.weights[c] * at_vertex(triangle.normals[c], triangle.corners[c]);
        return sum;
    }

    static image::Image toon_map(const std::string& name) {
        return image::read(studio().resources().folders().find("textures/toon", name, ".png"));
    }
};

TEST_F(Shading, PhongMatchesEquation41) {
    expect_shaded("pass render_phong p { clear_color 1 1 1 ; } ;", 2,
                  [](const Lit& lit, const RayCaster&, const Hit& hit) {
                      return lit.phong(lit.factors(hit.normal, hit.position));
                  });
}

TEST_F(Shading, GouraudInterpolatesTheVerticesLight) {
    expect_shaded("pass render_gouraud g { clear_color 1 1 1 ; } ;", 1,
                  [](const Lit& lit, const RayCaster& rays, const Hit& hit) {
                      const auto diffuse = [&](const auto& n, const auto& p) { return lit.factors(n, p).diffuse; };
                      const auto specular = [&](const auto& n, const auto& p) { return lit.factors(n, p).specular; };
                      return lit.phong({interpolated(rays, hit, diffuse), interpolated(rays, hit, specular)});
                  });
}

TEST_F(Shading, FlatHasOneNormalATriangle) {
    expect_shaded(
        "pass render_flat f { clear_color 1 1 1 ; } ;", 1,
        [](const Lit& lit, const RayCaster& rays, const Hit& hit) -> std::optional<glm::vec4> {
            if (std::min({hit.weights.x, hit.weights.y, hit.weights.z}) < 0.1)
                return std::nullopt;  // derivatives across two
            const RayCaster::Triangle& triangle = rays.triangle(hit);
            const glm::dvec3 normal = glm::normalize(
                glm::cross(triangle.corners[1] - triangle.corners[0], triangle.corners[2] - triangle.corners[0]));
            return lit.phong(lit.factors(normal, hit.position));
        },
        0.5);
}

TEST_F(Shading, BaseIsTheDiffuseColour) {
    expect_shaded("pass render_base b { clear_color 1 1 1 ; } ;", 1,
                  [](const Lit& lit, const RayCaster&, const Hit&) { return glm::vec4(lit.material.diffuse, 1.0f); });
}

TEST_F(Shading, ToonMatchesEquations42To46) {
    for (const std::string name : {"three_tone", "two_tone", "spectrum"}) {
        SCOPED_TRACE(name);
        const image::Image map = toon_map(name);
        expect_shaded(
            "pass render_toon t { toon_map \"toon:" + name + ":0\" ; } ;", 2,
            [&](const Lit& lit, const RayCaster&, const Hit& hit) {
                return lit.toon(lit.intensity(lit.factors(hit.normal, hit.position)), map);
            },
            0.08);
    }
}

TEST_F(Shading, ToonPerVertexInterpolatesTheVerticesIntensity) {
    const image::Image map = toon_map("four_tone");
    expect_shaded(
        "pass render_toon_per_vertex t { toon_map \"toon:four_tone:0\" ; } ;", 1,
        [&](const Lit& lit, const RayCaster& rays, const Hit& hit) {
            return lit.toon(
                interpolated(rays, hit, [&](const auto& n, const auto& p) { return lit.intensity(lit.factors(n, p)); }),
                map);
        },
        0.08);
}

TEST_F(Shading, RenderersDifferFromEachOther) {
    Stage stage(studio(), {.model = icosphere(1)});
    const std::vector<std::string> names{"base", "phong", "gouraud", "flat", "metallic"};
    std::vector<image::Image> pictures;
    for (const std::string& name : names) {
        pictures.push_back(stage.picture("pass render_" + name + " p { clear_color 1 1 1 ; } ;"));
        for (std::size_t i = 0; i + 1 < pictures.size(); ++i) {
            EXPECT_GT(image::compare(pictures[i], pictures.back()).mean, 0.3) << names[i] << " and " << name;
        }
    }
}

TEST_F(Shading, TheMetallicMapCounts) {
    Stage stage(studio(), {.model = icosphere(2)});
    const image::Image chrome = stage.picture("pass render_metallic p { sphere_map \"metal:chrome\" ; } ;");
    EXPECT_GT(image::compare(chrome, stage.picture("pass render_metallic p { sphere_map \"metal:gold\" ; } ;")).mean,
              1.0);
}

TEST_F(Shading, ATextureTintsTheDiffuseColour) {
    // A quad whose texture coordinates cover the image once: its upper left texel is the image's upper left.
    model::RawModel raw;
    model::RawMesh& mesh = raw.meshes.emplace_back();
    mesh.mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.mesh.texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.mesh.triangles = {0, 1, 2, 0, 2, 3};
    auto tile = std::make_shared<image::Image>(2, 2, glm::u8vec4(0, 0, 0, 255));
    tile->at(0, 0) = {255, 0, 0, 255};
    tile->at(1, 1) = {0, 255, 0, 255};
    model::Material material = plain("tiled", glm::vec3(1.0f));
    material.texture = tile;
    raw.materials.push_back(material);
    Stage stage(
        studio(),
        {.model = model::finish(std::move(raw), "quad"), .view = seen_from({0, 0, 1}), .width = 48, .height = 48});
    const image::Image picture = stage.picture("pass render_base b {} ;");
    // Filtered, so not quite pure.
    const auto expect_near = [&](int x, int y, int red, int green) {
        EXPECT_NEAR(picture.at(x, y).x, red, 40) << x << ", " << y;
        EXPECT_NEAR(picture.at(x, y).y, green, 40) << x << ", " << y;
    };
    expect_near(13, 13, 255, 0);
    expect_near(34, 13, 0, 0);
    expect_near(34, 34, 0, 255);
}

}  // namespace
}  // namespace croquis::components
