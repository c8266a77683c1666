// What one pass over the scene packs (row E6): normals, regions and linear depth of a rendered sphere against rays, the
// packing in C++ against its numbers, render_ids and render_normals.
#include "components/cross.h"
#include "framework/surface_attributes.h"
#include "support/ray_cast.h"
#include "support/studio.h"

namespace croquis::components {
namespace {

using namespace test_support;
using framework::SurfaceAttributes;

constexpr double degree = 3.14159265358979323846 / 180.0;

class Attributes : public StudioTest {};

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// Half a step of 255 on each axis.
constexpr double rounded_normal = 0.4 * degree;

TEST(PackedAttributes, KeepNormalsWithinTheirBytes) {
    const Random random(1, "normals");
    double largest = 0;
    for (std::uint64_t i = 0; i < 30000; i += 3) {
        const glm::dvec3 v(random.between(-1, 1, i), random.between(-1, 1, i + 1), random.between(-1, 1, i + 2));
        if (glm::length(v) < 0.05) continue;
        const glm::vec3 normal(glm::normalize(v));
        const SurfaceAttributes back = framework::unpack(framework::pack({.normal = normal}));
        largest = std::max(largest, angle_between(normal, back.normal));
        ASSERT_NEAR(glm::length(back.normal), 1.0f, 0.011f);
    }
    EXPECT_LT(largest, rounded_normal);
}

TEST(PackedAttributes, KeepRegionsDepthsAndFacing) {
    for (const auto& [region, kept] :
         {std::pair(0u, 0u), {1u, 1u}, {254u, 254u}, {255u, 255u}, {256u, 1u}, {510u, 255u}, {65536u, 1u}}) {
        EXPECT_EQ(framework::unpack(framework::pack({.region = region})).region, kept) << region;
    }
    for (const float share : {0.0f, 0.123456f, 0.5f, 0.99999f, 1.0f}) {
        EXPECT_NEAR(framework::unpack(framework::pack({.depth = share})).depth, share, 0.51f / 65535.0f);
        EXPECT_NEAR(framework::unpack(framework::pack({.facing = share})).facing, share, 0.51f / 255.0f);
    }
}

image::Raster<SurfaceAttributes> read_attributes(Studio& studio, const framework::Technique& technique) {
    const image::Image normals = read_colors(studio, technique, "attributes_normals");
    const image::Image distances = read_colors(studio, technique, "attributes_distances");
    image::Raster<SurfaceAttributes> attributes(normals.width(), normals.height());
    for (std::size_t i = 0; i < attributes.pixels().size(); ++i) {
        const glm::u8vec4 &n = normals.pixels()[i], &d = distances.pixels()[i];
        attributes.pixels()[i] = framework::unpack({{n.x, n.y, n.z, n.w}, {d.x, d.y, d.z, d.w}});
    }
    return attributes;
}

// How much the distance changes over the rasteriser's rounding: much on a steep surface.
double rounding_of_distance(const RayCaster& rays, int x, int y) {
    constexpr double rounding = 1.0 / 64.0;
    const double centre = rays.pixel(x, y)->eye_distance;
    const auto change = [&](double dx, double dy) {
        return std::abs(rays.at(x + 0.5 + dx, y + 0.5 + dy)->eye_distance - centre);
    };
    return std::max(change(rounding, rounding), change(-rounding, rounding));
}

TEST_F(Attributes, OfASphereMatchRays) {
    for (const auto projection : {model::Projection::perspective, model::Projection::parallel}) {
        Stage stage(studio(), {.model = icosphere(2), .view = seen_from({1, 0.7, 1}, projection)});
        const auto technique = studio().open("pass render_attributes a {} ;");
        stage.draw(*technique);
        const image::Raster<SurfaceAttributes> attributes = read_attributes(studio(), *technique);
        const image::Raster<double> window = read_depths(studio(), *technique, "attributes_depth");
        const RayCaster rays(stage.model(), stage.camera(), stage.width(), stage.height());
        const double near_plane = stage.camera().near_plane, range = stage.camera().far_plane - near_plane;
        int surface = 0, background = 0;
        for (int y = 0; y < stage.height(); ++y) {
            for (int x = 0; x < stage.width(); ++x) {
                if (!rays.is_certain(x, y)) continue;
                const auto hit = rays.pixel(x, y);
                const SurfaceAttributes& seen = attributes.at(x, y);
                if (!hit) {
                    ++background;
                    ASSERT_EQ(seen.region, 0u);
                    ASSERT_EQ(seen.depth, 1.0f);
                    ASSERT_LT(angle_between(seen.normal, -stage.camera().back), rounded_normal) << "into the screen";
                    ASSERT_EQ(window.at(x, y), 1.0);
                    continue;
                }
                ++surface;
                ASSERT_EQ(seen.region, 1u);
                ASSERT_NEAR(near_plane + double(seen.depth) * range, hit->eye_distance,
                            1e-4 + rounding_of_distance(rays, x, y));
                ASSERT_LT(angle_between(seen.normal, hit->normal), rounded_normal) << x << ", " << y;
                ASSERT_NEAR(double(seen.facing), std::max(glm::dot(hit->normal, hit->to_eye), 0.0), 0.01);
            }
        }
        EXPECT_GT(surface, 500);
        EXPECT_GT(background, 500);
    }
}

TEST_F(Attributes, NormalsFaceTheEyeOnBothSidesOfAnOpenSurface) {
    const ModelPointer board = model_of({{"board", quad_corners({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0})}});
    for (const double side : {1.0, -1.0}) {
        Stage stage(studio(), {.model = board, .view = seen_from({0.3, 0.1, side})});
        const auto technique = studio().open("pass render_attributes a {} ;");
        stage.draw(*technique);
        const SurfaceAttributes middle = read_attributes(studio(), *technique).at(32, 24);
        EXPECT_LT(angle_between(middle.normal, glm::dvec3(0, 0, side)), rounded_normal);
    }
}

TEST_F(Attributes, NormalsAsColoursMatchRaysAndTheBackgroundPointsIntoTheScreen) {
    Stage stage(studio(), {.model = icosphere(2)});
    const image::Image picture = stage.picture(*studio().open_named("normals"));
    const RayCaster rays(stage.model(), stage.camera(), stage.width(), stage.height());
    expect_pixels(
        picture,
        [&](int x, int y) -> std::optional<glm::vec4> {
            if (!rays.is_certain(x, y)) return std::nullopt;
            const auto hit = rays.pixel(x, y);
            const glm::dvec3 normal = hit ? hit->normal : -stage.camera().back;
            return glm::vec4(glm::vec3(normal * 0.5 + 0.5), 1.0f);
        },
        0.6, 0.05);
}

TEST_F(Attributes, IdsAreUnique) {
    // A row of boxes, each a region of its own.
    std::vector<Piece> pieces;
    for (int i = 0; i < 40; ++i) {
        const glm::vec3 low(float(i % 8) * 3.0f, float(i / 8) * 3.0f, 0.0f);
        pieces.push_back({"box" + std::to_string(i), box_corners(low, low + 2.0f)});
    }
    Stage stage(studio(), {.model = model_of(pieces), .view = seen_from({0, 0, 1}), .width = 96, .height = 72});
    const image::Image picture = stage.picture(*studio().open_named("ids"));
    const RayCaster rays(stage.model(), stage.camera(), stage.width(), stage.height());
    std::map<std::uint32_t, glm::u8vec4> color_of;
    for (int y = 0; y < stage.height(); ++y) {
        for (int x = 0; x < stage.width(); ++x) {
            if (!rays.is_certain(x, y)) continue;
            const auto hit = rays.pixel(x, y);
            if (!hit) {
                ASSERT_EQ(picture.at(x, y), black);
            } else {
                const auto known = color_of.try_emplace(hit->mesh, picture.at(x, y)).first;
                ASSERT_EQ(picture.at(x, y), known->second) << "mesh " << hit->mesh;
            }
        }
    }
    EXPECT_EQ(color_of.size(), 40u);
    for (const auto& [mesh, color] : color_of) {
        EXPECT_NE(color, black);
        for (const auto& [other, its_color] : color_of) EXPECT_TRUE(mesh == other || color != its_color);
    }
}

}  // namespace
}  // namespace croquis::components
