// edge_detect on random packed attributes (one colour a cause), and edge_detect_id on random ids.
#include <fmt/format.h>

#include "components/cross.h"
#include "framework/surface_attributes.h"
#include "support/studio.h"

namespace croquis::components {
namespace {

using namespace test_support;

// The default cube before an eye so near that it covers the frame: elsewhere the pass looks for no edges.
model::ViewRequest filling_view() {
    model::ViewRequest view;
    view.eye = {0, 0, 2};
    return view;
}

class EdgeDetect : public StudioTest {};

using Attributes = image::Raster<framework::SurfaceAttributes>;

// Attributes as their bytes hold them; normals, regions and depths in blocks that often agree.
Attributes random_attributes(int width, int height, std::uint64_t seed) {
    const Random random(seed, "attributes");
    Attributes attributes(width, height);
    constexpr int block = 4;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto next = std::uint64_t(10 * (y / block * width + x / block));
            framework::SurfaceAttributes now{.normal = {0, 0, 1}, .region = 1, .depth = 0.5f, .facing = 1};
            if (random.unit(next) < 0.3) {
                const glm::dvec3 tilt(random.between(-2, 2, next + 1), random.between(-2, 2, next + 2),
                                      random.between(-1, 1, next + 3));
                now.normal = glm::vec3(glm::normalize(tilt + glm::dvec3(0, 0, 0.01)));
            }
            if (random.unit(next + 4) < 0.3) now.region = std::array{2u, 129u, 255u}[random.bits(next + 5) % 3];
            if (random.unit(next + 6) < 0.3) now.depth = float(random.unit(next + 7));
            attributes.at(x, y) = framework::unpack(framework::pack(now));
        }
    }
    return attributes;
}

// Hands the attributes to the passes of test_source named normals and distances.
void hand_on(Sources& sources, const Attributes& attributes) {
    image::Image normals(attributes.width(), attributes.height()), distances = normals;
    for (std::size_t i = 0; i < attributes.pixels().size(); ++i) {
        const framework::PackedAttributes packed = framework::pack(attributes.pixels()[i]);
        normals.pixels()[i] = {packed.normals[0], packed.normals[1], packed.normals[2], packed.normals[3]};
        distances.pixels()[i] = {packed.distances[0], packed.distances[1], packed.distances[2], packed.distances[3]};
    }
    sources["normals"] = normals;
    sources["distances"] = distances;
}

struct Causes {
    double sharpest = 1;   // equation 3.7
    double turn = 0;       // equation 3.8 without its factor
    double laplacian = 0;  // equation 3.13
    bool ids = false;
};

Causes causes_at(const Attributes& attributes, const model::Camera& camera, int x, int y) {
    const auto cross = cross_at(attributes, x, y);
    const glm::dvec3 centre = glm::normalize(glm::dvec3(cross[0].normal));
    const auto distance = [&](const framework::SurfaceAttributes& surface) {
        return camera.near_plane + double(surface.depth) * (camera.far_plane - camera.near_plane);
    };
    Causes causes;
    causes.laplacian = -4.0 * distance(cross[0]);
    for (std::size_t i = 1; i < 5; ++i) {
        const double dot = glm::dot(centre, glm::normalize(glm::dvec3(cross[i].normal)));
        causes.sharpest = std::min(causes.sharpest, dot);
        causes.turn += 1.0 - dot;
        causes.laplacian += distance(cross[i]);
        causes.ids = causes.ids || cross[i].region != cross[0].region;
    }
    causes.laplacian = std::abs(causes.laplacian);
    return causes;
}

// Bytes hold a normal to a hundredth of its length.
constexpr double rounded_dot = 0.012;

const glm::vec4 by_normals{0, 0, 1, 1}, by_depth{1, 0, 0, 1}, by_ids{0.6f, 0.9f, 0.6f, 1}, by_several{0, 0, 0, 1},
    none{1};

std::string text(const std::string& settings) {
    return "pass test_source n { texture \"normals\" ; } ; pass test_source d { texture \"distances\" ; } ; pass "
           "edge_detect e "
           "{ texture \"<generated>:normals\" ; distances \"<generated>:distances\" ; " +
           settings + " } ;";
}

TEST_F(EdgeDetect, GivesEachCauseItsColour) {
    Stage stage(studio(), {.view = filling_view()});
    for (const auto& [normal, depth, ids] :
         {std::tuple(0.7, 0.1, true), {0.7, 0.1, false}, {0.0, 1.0, true}, {-1.0, 900.0, true}}) {
        const Attributes attributes = random_attributes(stage.width(), stage.height(), 3);
        hand_on(studio().sources(), attributes);
        int seen[5] = {};
        const image::Image edges = stage.picture(
            text(fmt::format("normal_threshold {} ; depth_threshold {} ; detect_ids {} ;", normal, depth, ids)));
        expect_pixels(
            edges,
            [&, n = normal, d = depth, i = ids](int x, int y) -> std::optional<glm::vec4> {
                const Causes causes = causes_at(attributes, stage.camera(), x, y);
                if (std::abs(causes.sharpest - n) < rounded_dot || std::abs(causes.laplacian - d) < 1e-5)
                    return std::nullopt;
                const bool from[] = {causes.sharpest<n, causes.laplacian> d, i && causes.ids};
                const int count = from[0] + from[1] + from[2];
                ++seen[count > 1 ? 4 : count == 0 ? 3 : from[0] ? 0 : from[1] ? 1 : 2];
                if (count == 0) return none;
                return count > 1 ? by_several : from[0] ? by_normals : from[1] ? by_depth : by_ids;
            },
            0.51, 0.03);
        EXPECT_EQ(seen[2] > 0, ids) << "ids alone";
        EXPECT_GT(seen[3], 0) << "no edge";
        if (normal == 0.7) {
            EXPECT_GT(seen[0], 0) << "normals alone";
            EXPECT_GT(seen[1], 0) << "depth alone";
            EXPECT_GT(seen[4], 0) << "several";
        }
    }
}

TEST_F(EdgeDetect, GivesGradualColoursWithoutThreshold) {
    Stage stage(studio(), {.view = filling_view()});
    const Attributes attributes = random_attributes(stage.width(), stage.height(), 4);
    hand_on(studio().sources(), attributes);
    const image::Image edges =
        stage.picture(text("apply_threshold false ; normal_threshold 0.3 ; depth_threshold 0.4 ; detect_ids false ;"));
    expect_pixels(
        edges,
        [&](int x, int y) -> std::optional<glm::vec4> {
            const Causes causes = causes_at(attributes, stage.camera(), x, y);
            // Each cause's colour by its share, the depth's over the normals'.
            const auto n = float(std::clamp(0.3 * causes.turn, 0.0, 1.0)),
                       d = float(std::clamp(0.4 * causes.laplacian, 0.0, 1.0));
            return glm::mix(glm::mix(none, by_normals, n), by_depth, d);
        },
        3.5);  // 4 dot products, each to a hundredth, times 0.3
}

TEST_F(EdgeDetect, TakesTheColoursAsked) {
    Stage stage(studio(), {.view = filling_view()});
    const Attributes attributes = random_attributes(stage.width(), stage.height(), 5);
    hand_on(studio().sources(), attributes);
    const image::Image edges =
        stage.picture(text("edge_color 1 1 0 1 ; normal_edge_color 0 1 1 1 ; depth_edge_color 1 0 1 1 ; "
                           "id_edge_color 0 1 0 1 ; non_edge_color 0.2 0.2 0.2 1 ; depth_threshold 0.1 ;"));
    std::array<int, 5> seen{};
    const std::array<glm::u8vec4, 5> colors{
        {{255, 255, 0, 255}, {0, 255, 255, 255}, {255, 0, 255, 255}, {0, 255, 0, 255}, {51, 51, 51, 255}}};
    for (const glm::u8vec4& pixel : edges.pixels()) {
        const auto found = std::find(colors.begin(), colors.end(), pixel);
        ASSERT_NE(found, colors.end());
        ++seen[std::size_t(found - colors.begin())];
    }
    for (const int count : seen) EXPECT_GT(count, 0);
}

TEST_F(EdgeDetect, ById) {
    Stage stage(studio(), {});
    const Random random(8, "ids");
    image::Image ids(stage.width(), stage.height());
    std::uint64_t next = 0;
    glm::u8vec4 id(0);
    for (glm::u8vec4& pixel : ids.pixels()) {
        if (random.unit(next++) < 0.15)
            id[int(random.between(0, 3, next))] ^= std::uint8_t(1u << random.bits(next) % 8);
        ++next;
        pixel = id;
    }
    studio().sources()["i"] = ids;
    expect_pixels(
        stage.picture(
            "pass test_source s { texture \"i\" ; } ; pass edge_detect_id e { texture \"<generated>:i\" ; } ;"),
        [&](int x, int y) -> std::optional<glm::vec4> {
            const auto cross = cross_at(ids, x, y);
            bool differs = false;
            for (std::size_t i = 1; i < 5; ++i) differs = differs || glm::u8vec3(cross[i]) != glm::u8vec3(cross[0]);
            return differs ? glm::vec4(0, 0, 0, 1) : glm::vec4(1);
        });
}

}  // namespace
}  // namespace croquis::components
