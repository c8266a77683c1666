// Simple and fine crosshatching against seed B's equations in double precision, on surfaces found by rays (rows H1,
// H2). The strokes are even tones here, so that a pixel tells its level.
#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "components/cross.h"
#include "model/shade_split.h"
#include "support/ray_cast.h"
#include "support/studio.h"

namespace croquis::components {
namespace {

using namespace test_support;
using framework::Light;

constexpr int levels = 7;

// A white surface in white light and no light else: the cosine is the tone.
std::string pass(const char* component, const std::string& more = {}) {
    return fmt::format(
        "pass {} s {{ strokes \"test_hatching:even\" ; ink_color 0 0 0 ; ambient 0 ; material_share 0 ; tone_range 0 1 "
        "; "
        "levels {} ; {} }} ;",
        component, levels, more);
}

// The cosines at which one level ends and the next begins, from dark to light.
std::vector<double> thresholds() {
    std::vector<double> all;
    for (int i = 1; i < levels; ++i) all.push_back(double(i) / levels);
    return all;
}

// Level 0 of the splitter, the darkest, has the darkest strokes; nothing where rounding decides.
std::optional<glm::vec4> tone_of(double cosine) {
    const double place = cosine * levels;
    if (std::abs(place - std::round(place)) < 2e-3) return std::nullopt;
    const double tone = double(model::shade_level(cosine, thresholds())) / (levels - 1);
    return glm::vec4(glm::vec3(float(std::round(255 * tone) / 255)), 1.0f);
}

struct Setting {
    const char* name;
    model::Projection projection;
    Light light;
};

const std::vector<Setting> settings{
    {"direction", model::Projection::perspective, {Light::Bound::world, Light::Kind::direction, {0.9, 0.6, -0.3}}},
    {"point", model::Projection::parallel, {Light::Bound::world, Light::Kind::point, {0.4, 1.1, 0.9}}}};

class HatchingLevels : public StudioTest {
protected:
    using Truth =
        std::function<std::optional<glm::vec4>(const RayCaster::Triangle&, const Hit&, const glm::dvec4& light)>;
    static void expect_levels(const std::string& text, int subdivisions, const Truth& truth) {
        for (const Setting& setting : settings) {
            SCOPED_TRACE(setting.name);
            Stage stage(studio(), {.model = icosphere(subdivisions),
                                   .view = seen_from({1, 0.5, 1}, setting.projection),
                                   .light = setting.light});
            const bool is_point = setting.light.kind == Light::Kind::point;
            const glm::dvec4 light(is_point ? setting.light.place : glm::normalize(setting.light.place), is_point);
            const RayCaster rays(stage.model(), stage.camera(), stage.width(), stage.height());
            expect_pixels(
                stage.picture(text),
                [&](int x, int y) -> std::optional<glm::vec4> {
                    if (!rays.is_certain(x, y)) return std::nullopt;
                    const auto hit = rays.pixel(x, y);
                    // Beside an edge, rounding says which triangle it is.
                    if (hit && std::min({hit->weights.x, hit->weights.y, hit->weights.z}) < 0.02) return std::nullopt;
                    return hit ? truth(rays.triangle(*hit), *hit, light) : glm::vec4(1);
                },
                1.5, 0.3);
        }
    }
};

glm::dvec3 to_light(const glm::dvec4& light, const glm::dvec3& position) {
    return glm::normalize(glm::dvec3(light) - light.w * position);
}

// Equation 4.2: the summed normal and the barycentre; of unit vectors, three times a cosine.
double cosine_at_barycentre(const RayCaster::Triangle& t, const glm::dvec4& light) {
    const glm::dvec3 barycentre = (t.corners[0] + t.corners[1] + t.corners[2]) / 3.0;
    return glm::dot(t.normals[0] + t.normals[1] + t.normals[2], to_light(light, barycentre)) / 3;
}

model::ShadeTriangle corners_of(const RayCaster::Triangle& t, const glm::dvec4& light) {
    model::ShadeTriangle corners;
    for (std::size_t c = 0; c < 3; ++c) {
        corners[c] = {t.corners[c], glm::dot(t.normals[c], to_light(light, t.corners[c]))};
    }
    return corners;
}

// The piece that a point of the triangle's plane lies in, or none where two are equally near.
std::optional<int> level_of_piece(const std::vector<model::ShadePiece>& pieces, const glm::dvec3& point) {
    for (const model::ShadePiece& piece : pieces) {
        const auto& [a, b, c] = piece.corners;
        const glm::dvec3 normal = glm::cross(b.position - a.position, c.position - a.position);
        const auto side = [&](const model::ShadeCorner& from, const model::ShadeCorner& to) {
            return glm::dot(glm::cross(to.position - from.position, point - from.position), normal) /
                   (glm::length(normal) * glm::distance(from.position, to.position));
        };
        if (std::min({side(a, b), side(b, c), side(c, a)}) > 1e-9) return piece.level;
    }
    return std::nullopt;
}

TEST_F(HatchingLevels, SimpleHasTheLevelOfEquation42) {
    expect_levels(pass("hatch_simple"), 1, [](const RayCaster::Triangle& t, const Hit&, const glm::dvec4& light) {
        return tone_of(cosine_at_barycentre(t, light));
    });
}

TEST_F(HatchingLevels, FineHasTheLevelOfThePieceThatTheSplitterMakes) {
    expect_levels(
        pass("hatch_fine", "smallest_split 0 ;"), 0,
        [](const RayCaster::Triangle& t, const Hit& hit, const glm::dvec4& light) -> std::optional<glm::vec4> {
            const model::ShadeTriangle corners = corners_of(t, light);
            double cosine = 0;
            for (int c = 0; c < 3; ++c) cosine += hit.weights[c] * corners[std::size_t(c)].cosine;
            const auto pieces = model::split_by_shade(corners, thresholds(), 0);
            const std::optional<int> level = level_of_piece(pieces, hit.position);
            if (!level || !tone_of(cosine)) return std::nullopt;
            return tone_of((*level + 0.5) / levels);
        });
}

TEST_F(HatchingLevels, SmallTrianglesAreShadedAsInSimpleCrosshatching) {
    Stage stage(studio(), {.model = icosphere(2)});
    const image::Image simple = stage.picture(pass("hatch_simple"));
    EXPECT_EQ(simple, stage.picture(pass("hatch_fine", "smallest_split 10000 ;")));
    EXPECT_NE(simple, stage.picture(pass("hatch_fine", "smallest_split 0 ;")));
}

TEST_F(HatchingLevels, TheLimitIsTheLongestSideInPixels) {
    // Half a board from the front: its longest side is the diagonal.
    const ModelPointer half = model_of({{"half", {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}}}});
    Stage stage(studio(), {.model = half,
                           .view = seen_from({0, 0, 1}, model::Projection::parallel),
                           .light = {Light::Bound::world, Light::Kind::point, {0.8, 0.8, 0.3}},
                           .width = 100,
                           .height = 100});
    const double diagonal = std::sqrt(2.0) * 0.9 * 100;
    const image::Image whole = stage.picture(pass("hatch_simple"));
    const auto with_limit = [&](double limit) {
        return stage.picture(pass("hatch_fine", fmt::format("smallest_split {} ;", limit)));
    };
    EXPECT_EQ(with_limit(diagonal * 1.02), whole);
    EXPECT_NE(with_limit(diagonal * 0.98), whole);
}

TEST_F(HatchingLevels, NothingIsUploadedInAFrame) {
    for (const char* component : {"hatch_simple", "hatch_fine"}) {
        Stage stage(studio(), {.model = icosphere(2)});
        const auto technique = studio().open(pass(component));
        stage.draw(*technique);
        const gpu::Counters before = studio().counters();
        for (int i = 0; i < 3; ++i) stage.draw(*technique);
        EXPECT_EQ(studio().counters().geometry_uploads, before.geometry_uploads);
        EXPECT_EQ(studio().counters().texture_uploads, before.texture_uploads);
        EXPECT_EQ(studio().counters().draws, before.draws + 3);
    }
}

TEST_F(HatchingLevels, FacetsFollowAPose) {
    // The sphere squeezed flat towards the eye: all normals face it, and so does the light.
    Stage stage(studio(), {.model = icosphere(1),
                           .view = seen_from({0, 0, 1}),
                           .light = {Light::Bound::world, Light::Kind::direction, {0, 0, 1}}});
    const auto technique = studio().open(pass("hatch_simple"));
    EXPECT_NE(stage.picture(*technique), stage.picture("pass background b {} ;"));
    model::Pose pose{{stage.model().meshes[0].positions, stage.model().meshes[0].normals}};
    for (glm::vec3& position : pose[0].positions) position.z *= 0.01f;
    for (glm::vec3& normal : pose[0].normals) normal = {0, 0, 1};
    stage.scene().set_pose(pose);
    EXPECT_EQ(stage.picture(*technique), stage.picture("pass background b {} ;")) << "white all over";
    stage.scene().clear_pose();
    EXPECT_NE(stage.picture(*technique), stage.picture("pass background b {} ;"));
}

}  // namespace
}  // namespace croquis::components
