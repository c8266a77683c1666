// Surfaces lit by seed C's equations in double precision, found by rays: what tests of shading compare pictures with.
#pragma once

#include <fmt/format.h>

#include "components/cross.h"
#include "image/image.h"
#include "support/ray_cast.h"
#include "support/studio.h"

namespace croquis::components::testing {

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

inline std::vector<Setting> settings() {
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

    static image::Image map_image(const std::string& folder, const std::string& name) {
        return image::read(studio().resources().folders().find("textures/" + folder, name, ".png"));
    }
};

}  // namespace croquis::components::testing
