// edge_detect_normals on random images: equations 3.7 and 3.8 in double precision.
#include <fmt/format.h>

#include "components/cross.h"
#include "support/studio.h"

namespace croquis::components {
namespace {

using namespace test_support;

class EdgeDetectNormals : public StudioTest {};

image::Image random_normals(int width, int height, std::uint64_t seed) {
    const Random random(seed, "normals");
    image::Image image(width, height);
    std::uint64_t next = 0;
    for (glm::u8vec4& pixel : image.pixels()) {
        glm::dvec3 normal;
        do {
            for (int c = 0; c < 3; ++c) normal[c] = random.between(-1, 1, next++);
        } while (glm::length(normal) > 1 || glm::length(normal) < 0.1);
        // Half of them near one direction, so that all thresholds meet both sides.
        if (random.unit(next++) < 0.5) normal = glm::normalize(normal) * 0.4 + glm::dvec3(0.2, 0.3, 1.0);
        pixel = glm::u8vec4(glm::round((glm::normalize(normal) * 0.5 + 0.5) * 255.0), 255);
    }
    return image;
}

glm::dvec3 expanded(const glm::u8vec4& color) { return glm::normalize(glm::dvec3(color) / 255.0 * 2.0 - 1.0); }

std::array<double, 4> dots(const image::Image& normals, int x, int y) {
    const auto cross = cross_at(normals, x, y);
    std::array<double, 4> dots{};
    for (std::size_t i = 0; i < 4; ++i) dots[i] = glm::dot(expanded(cross[0]), expanded(cross[i + 1]));
    return dots;
}

TEST_F(EdgeDetectNormals, MatchesEquation37) {
    Stage stage(studio(), {});
    for (const auto& [threshold, seed] : {std::pair(0.7, 1u), {0.9, 2u}, {0.0, 3u}, {-0.5, 4u}, {0.99, 5u}}) {
        const image::Image normals = random_normals(stage.width(), stage.height(), seed);
        studio().sources()["n"] = normals;
        const image::Image edges = stage.picture(fmt::format(
            "pass test_source s {{ texture \"n\" ; }} ; pass edge_detect_normals e {{ texture \"<generated>:n\" ; "
            "threshold {} ; }} ;",
            threshold));
        expect_pixels(edges, [&, limit = threshold](int x, int y) -> std::optional<glm::vec4> {
            const auto d = dots(normals, x, y);
            const double sharpest = *std::min_element(d.begin(), d.end());
            if (std::abs(sharpest - limit) < 1e-5) return std::nullopt;
            return sharpest < limit ? glm::vec4(0, 0, 0, 1) : glm::vec4(1);
        });
    }
}

TEST_F(EdgeDetectNormals, MatchesEquation38WithoutThreshold) {
    Stage stage(studio(), {});
    for (const double factor : {0.1, 0.25, 1.0}) {
        const image::Image normals = random_normals(stage.width(), stage.height(), 6);
        studio().sources()["n"] = normals;
        const image::Image edges = stage.picture(fmt::format(
            "pass test_source s {{ texture \"n\" ; }} ; pass edge_detect_normals e {{ texture \"<generated>:n\" ; "
            "apply_threshold false ; edge_color 1 0 0.5 1 ; non_edge_color 0 1 0.25 1 ; threshold {} ; }} ;",
            factor));
        expect_pixels(
            edges,
            [&](int x, int y) -> std::optional<glm::vec4> {
                const auto d = dots(normals, x, y);
                const double f = std::clamp(factor * (4.0 - (d[0] + d[1] + d[2] + d[3])), 0.0, 1.0);
                return glm::mix(glm::vec4(0, 1, 0.25, 1), glm::vec4(1, 0, 0.5, 1), float(f));
            },
            0.6);
    }
}

TEST_F(EdgeDetectNormals, CoplanarSurfacesHaveNoIntensity) {
    Stage stage(studio(), {});
    studio().sources()["n"] = image::Image(stage.width(), stage.height(), {200, 40, 180, 255});
    const image::Image edges = stage.picture(
        "pass test_source s { texture \"n\" ; } ; pass edge_detect_normals e { texture "
        "\"<generated>:n\" ; apply_threshold false ; threshold 100 ; } ;");
    expect_pixels(edges, [](int, int) { return glm::vec4(1); });
}

}  // namespace
}  // namespace croquis::components
