// Shading pixel by pixel against seed C's equations 4.1-4.6 in double precision, on surfaces found by rays (row C2).
#include "components/lit_sphere.h"

namespace croquis::components {
namespace {

using namespace testing;

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
        const image::Image map = map_image("toon", name);
        expect_shaded(
            "pass render_toon t { toon_map \"toon:" + name + ":0\" ; } ;", 2,
            [&](const Lit& lit, const RayCaster&, const Hit& hit) {
                return lit.toon(lit.intensity(lit.factors(hit.normal, hit.position)), map);
            },
            0.08);
    }
}

TEST_F(Shading, ToonPerVertexInterpolatesTheVerticesIntensity) {
    const image::Image map = map_image("toon", "four_tone");
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
