// The depth-based detectors on random depth buffers: equations 3.11, 3.12 and 3.13 in double precision, and the same in
// parallel projection.
#include <fmt/format.h>

#include "components/cross.h"
#include "support/studio.h"

namespace croquis::components {
namespace {

using namespace test_support;

class EdgeDetectDepth : public StudioTest {
protected:
    [[nodiscard]] static Stage stage(model::Projection projection) {
        return Stage(studio(), {.view = seen_from({1, 0.7, 1}, projection)});
    }
};

// Depth buffer values over the whole range, most of them near a neighbour's.
DepthValues random_depths(int width, int height, std::uint64_t seed) {
    const Random random(seed, "depths");
    DepthValues depths(width, height);
    std::uint64_t next = 0;
    double level = 0.5;
    for (std::uint32_t& depth : depths.pixels()) {
        level = random.unit(next++) < 0.2 ? random.unit(next++)
                                          : std::clamp(level + random.between(-0.02, 0.02, next++), 0.0, 1.0);
        depth = std::uint32_t(level * largest_depth);
    }
    return depths;
}

// Equation 3.11, or the plain interpolation of a parallel projection.
double linear(std::uint32_t depth, const model::Camera& camera) {
    const double n = camera.near_plane, f = camera.far_plane, window = double(depth) / double(largest_depth);
    if (camera.projection == model::Projection::parallel) return n + window * (f - n);
    return -2.0 * n * f / ((2.0 * window - 1.0) * (f - n) - (f + n));
}

struct Detector {
    const char* component;
    double (*measure)(const std::array<double, 5>& depths);  // of the centre and its four neighbours
};

constexpr Detector detectors[] = {
    {"edge_detect_depth_deltas",
     [](const std::array<double, 5>& d) {
         double largest = 0;
         for (std::size_t i = 1; i < 5; ++i) largest = std::max(largest, std::abs(d[0] - d[i]));
         return largest;
     }},
    {"edge_detect_depth_2nd_derivative",
     [](const std::array<double, 5>& d) { return std::abs(d[1] + d[2] + d[3] + d[4] - 4.0 * d[0]); }},
};

double measure(const Detector& detector, const DepthValues& depths, const model::Camera& camera, int x, int y) {
    const auto cross = cross_at(depths, x, y);
    std::array<double, 5> distances{};
    for (std::size_t i = 0; i < 5; ++i) distances[i] = linear(cross[i], camera);
    return detector.measure(distances);
}

std::string text(const Detector& detector, double threshold, bool apply) {
    return fmt::format(
        "pass test_source s {{ texture \"d\" ; format \"depth\" ; }} ; pass {} e {{ texture \"<generated>:d\" ; "
        "threshold {} ; apply_threshold {} ; }} ;",
        detector.component, threshold, apply);
}

TEST_F(EdgeDetectDepth, MatchesEquations312And313) {
    for (const Detector& detector : detectors) {
        for (const auto projection : {model::Projection::perspective, model::Projection::parallel}) {
            Stage setting = stage(projection);
            std::uint64_t seed = 0;
            for (const double threshold : {0.02, 0.1, 0.5}) {
                const DepthValues depths = random_depths(setting.width(), setting.height(), ++seed);
                studio().sources()["d"] = depths;
                expect_pixels(setting.picture(text(detector, threshold, true)),
                              [&](int x, int y) -> std::optional<glm::vec4> {
                                  const double d = measure(detector, depths, setting.camera(), x, y);
                                  if (std::abs(d - threshold) < 1e-5) return std::nullopt;
                                  return d > threshold ? glm::vec4(0, 0, 0, 1) : glm::vec4(1);
                              });
            }
        }
    }
}

TEST_F(EdgeDetectDepth, IntensityIsTheMeasureTimesThreshold) {
    for (const Detector& detector : detectors) {
        Stage setting = stage(model::Projection::perspective);
        const DepthValues depths = random_depths(setting.width(), setting.height(), 9);
        studio().sources()["d"] = depths;
        expect_pixels(
            setting.picture(text(detector, 0.8, false)),
            [&](int x, int y) -> std::optional<glm::vec4> {
                const double f = std::clamp(0.8 * measure(detector, depths, setting.camera(), x, y), 0.0, 1.0);
                return glm::vec4(glm::vec3(float(1.0 - f)), 1.0f);
            },
            0.6);
    }
}

}  // namespace
}  // namespace croquis::components
