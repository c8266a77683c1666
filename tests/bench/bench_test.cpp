// The protocol of croquis bench: its view against the closed form of a sphere's outline, its numbers against each other
// and against pictures made by hand.
#include "bench/benchmark.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "bench/frame_times.h"
#include "bench/framing.h"
#include "bench/reports.h"
#include "bench/stability.h"

namespace croquis::bench {
namespace {

constexpr double pi = 3.14159265358979323846;

Model shipped(const std::string& name) {
    return Model::load(std::string(std::getenv("CROQUIS_DATA")) + "/models/" + name);
}

/// A picture of one colour, some of whose pixels have another.
Picture grey(int width, int height, int level, int changed_pixels = 0, int changed_level = 0) {
    std::vector<std::uint8_t> pixels(std::size_t(width * height) * 4, 255);
    for (std::size_t i = 0; i < pixels.size(); i += 4) {
        const bool is_changed = int(i / 4) < changed_pixels;
        for (std::size_t c = i; c < i + 3; ++c) pixels[c] = std::uint8_t(is_changed ? changed_level : level);
    }
    return Picture(width, height, std::move(pixels));
}

TEST(Median, IsTheMiddle) {
    EXPECT_EQ(median({3}), 3);
    EXPECT_EQ(median({9, 1}), 5);
    EXPECT_EQ(median({100, 2, 1}), 2);
    EXPECT_EQ(median({4, 1, 3, 2}), 2.5);
    EXPECT_EQ(median({5, 5, 5, 1, 900}), 5);
}

TEST(Stability, MeanChangeIsOverAllPixelsAndColours) {
    EXPECT_EQ(mean_change(grey(10, 10, 40), grey(10, 10, 40)), 0);
    EXPECT_DOUBLE_EQ(mean_change(grey(10, 10, 40), grey(10, 10, 30)), 10);
    EXPECT_DOUBLE_EQ(mean_change(grey(10, 10, 40), grey(10, 10, 40, 25, 240)), 50);  // a quarter changes by 200
}

TEST(Stability, OnlySuddenChangesOfWhatIsStillElsewherePop) {
    const Picture before = grey(10, 10, 100), still = grey(10, 10, 50);
    EXPECT_EQ(popped_share(before, grey(10, 10, 100, 30, 164), still, still), 0);   // by 64: not sudden
    EXPECT_EQ(popped_share(before, grey(10, 10, 100, 30, 165), still, still), 30);  // by 65
    EXPECT_EQ(popped_share(before, grey(10, 10, 100, 30, 20), still, still), 30);   // darker by 80
    const Picture stirred = grey(10, 10, 50, 10, 59), hardly = grey(10, 10, 50, 10, 58);
    EXPECT_EQ(popped_share(before, grey(10, 10, 100, 30, 165), still, stirred), 20);  // ten of them moved there too
    EXPECT_EQ(popped_share(before, grey(10, 10, 100, 30, 165), still, hardly), 30);
}

// A sphere of radius 1 at a distance d is a circle of radius 1 / sqrt(d^2 - 1) on the plane at distance 1.
TEST(Framing, CoversTheAskedShare) {
    Renderer renderer = Renderer::headless();
    const Model sphere = shipped("sphere.obj");
    Protocol protocol;
    protocol.coverage = 20;
    DrawOptions options;
    options.width = protocol.width;
    options.height = protocol.height;
    options.view = view_with_coverage(renderer, sphere, protocol);
    EXPECT_NEAR(coverage(renderer, sphere, options), 20, 0.3);

    const Vector3 eye = options.view.eye.value(), target = options.view.target.value();
    const double distance = std::hypot(eye[0] - target[0], eye[1] - target[1], eye[2] - target[2]);
    const double sphere_radius = 0.5 * (sphere.high_corner()[0] - sphere.low_corner()[0]);
    const double d = distance / sphere_radius;
    const double pixels_at_one = 0.5 * protocol.height / std::tan(0.5 * options.view.field_of_view * pi / 180);
    const double area = pi * pixels_at_one * pixels_at_one / (d * d - 1);
    EXPECT_NEAR(100 * area / (protocol.width * protocol.height), 20, 0.5);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR((eye[axis] - target[axis]) / distance, protocol.direction[axis] / 25.249, 1e-3);
    }
}

TEST(Framing, TurnsAboutTheUprightAxis) {
    View view;
    view.target = Vector3{1, 2, 3};
    view.eye = Vector3{1, 7, 13};
    const Vector3 quarter = turned(view, 90).eye.value();
    for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(quarter[axis], (Vector3{11, 7, 3})[axis], 1e-12);
    const Vector3 back = turned(turned(view, 77), -77).eye.value();
    for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(back[axis], view.eye.value()[axis], 1e-12);
}

TEST(FrameTimes, ReadNothingBack) {
    Renderer renderer = Renderer::headless();
    const Model cube = shipped("cube.obj");
    Technique technique = renderer.open_technique("cartoon");
    DrawOptions options;
    options.width = options.height = 64;
    (void)renderer.time_frames(cube, technique, {options});
    const Renderer::Counts before = renderer.counts();
    (void)renderer.time_frames(cube, technique, {options});
    const Renderer::Counts one = renderer.counts();
    EXPECT_GT(renderer.time_frames(cube, technique, std::vector<DrawOptions>(5, options)), 0);
    const Renderer::Counts after = renderer.counts();
    EXPECT_EQ(after.draws - one.draws, 5 * (one.draws - before.draws));
    EXPECT_GT(one.draws, before.draws);
    EXPECT_EQ(after.read_backs, before.read_backs);
    EXPECT_EQ(after.geometry_uploads, before.geometry_uploads);
}

Protocol quick() {
    Protocol protocol;
    protocol.width = 96;
    protocol.height = 80;
    protocol.frames = 22;
    protocol.techniques = {"base", "phong", "base"};
    return protocol;
}

TEST(Measure, RatiosAreToTheDefaultRendererOfTheLevel) {
    Renderer renderer = Renderer::headless();
    Protocol protocol = quick();
    protocol.levels = 3;
    protocol.passes = protocol.stability = true;
    std::size_t steps = 0;
    const Benchmark result =
        measure(renderer, shipped("sphere.obj"), "sphere.obj", protocol, [&](const std::string&) { ++steps; });
    EXPECT_EQ(steps, step_count(protocol));
    ASSERT_EQ(result.levels.size(), 3u);
    for (std::size_t level = 0; level < 3; ++level) {
        const LevelTimes& times = result.levels[level];
        EXPECT_NEAR(double(times.triangles) * std::pow(2, level) / 5120, 1, 0.03);
        EXPECT_NEAR(times.coverage, 15, 0.13 * 15);
        ASSERT_EQ(times.techniques.size(), 2u);  // each once, the default renderer first
        EXPECT_EQ(times.techniques[0].technique, "phong");
        EXPECT_EQ(times.techniques[1].technique, "base");
        EXPECT_EQ(times.techniques[0].ratio, 1);
        for (const TechniqueTime& time : times.techniques) {
            EXPECT_GT(time.milliseconds, 0);
            EXPECT_DOUBLE_EQ(time.ratio, time.milliseconds / times.techniques[0].milliseconds);
            EXPECT_EQ(time.frames, 22);
            ASSERT_EQ(time.passes.size(), 1u);
            EXPECT_GT(time.passes[0].milliseconds, 0);
        }
    }
    ASSERT_EQ(result.stabilities.size(), 2u);
    EXPECT_EQ(result.stabilities[0].ratio, 1);
    EXPECT_EQ(result.stabilities[0].pops, 0);  // where it changes, it changes
    EXPECT_GT(result.stabilities[1].change, 0);
}

// Lines are found and uploaded anew only when the view changed.
TEST(Measure, TurnsFromFrameToFrame) {
    Renderer renderer = Renderer::headless();
    const Model cube = shipped("cube.obj");
    const auto uploads = [&](double turn) {
        Protocol protocol = quick();
        protocol.techniques = {"lines"};
        protocol.turn = turn;
        const long long before = renderer.counts().geometry_uploads;
        (void)measure(renderer, cube, "cube.obj", protocol, [](const std::string&) {});
        return renderer.counts().geometry_uploads - before;
    };
    const long long still = uploads(0);
    EXPECT_GE(uploads(1), still + 22);
}

TEST(Measure, SaysWhatIsWrong) {
    Renderer renderer = Renderer::headless();
    const Model cube = shipped("cube.obj");
    const auto message = [&](const Protocol& protocol) -> std::string {
        try {
            (void)measure(renderer, cube, "cube.obj", protocol, [](const std::string&) {});
        } catch (const Error& error) {
            return error.what();
        }
        return {};
    };
    Protocol protocol = quick();
    protocol.techniques = {"fong"};
    EXPECT_NE(message(protocol).find("did you mean \"phong\"?"), std::string::npos) << message(protocol);
    protocol = quick();
    protocol.triangles = {13};
    EXPECT_EQ(message(protocol), "expected a model of at least 13 triangles, found 12");
    protocol = quick();
    protocol.levels = 0;
    EXPECT_EQ(message(protocol), "expected 1 to 20 levels of detail, found 0");
    protocol = quick();
    protocol.levels = 5;
    EXPECT_NE(message(protocol).find("found 1: nothing would be left"), std::string::npos) << message(protocol);
    protocol = quick();
    protocol.seconds = 0;
    EXPECT_EQ(message(protocol), "expected more than 0 seconds to measure, found 0");
    protocol = quick();
    protocol.direction = {0, 0, 0};
    EXPECT_EQ(message(protocol), "expected the view to have a direction, found 0,0,0");
}

}  // namespace
}  // namespace croquis::bench
