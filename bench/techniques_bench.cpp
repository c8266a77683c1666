// Frame times of the techniques as ratios to phong, and the edge pass as a ratio to a full-screen copy, each within one
// run and interleaved, so that a machine's drift meets all alike.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

#include "croquis/croquis.h"
#include "ratio_reporter.h"
#include "sample_models.h"

namespace croquis::bench {
namespace {

// The picture size of seed A's protocol (2.4), and the one of the edge pass's limit.
constexpr int protocol_width = 620, protocol_height = 500;
constexpr int large_width = 1024, large_height = 768;

struct Scene {
    Renderer renderer;
    Model model;
};

void time_frames(benchmark::State& state, Scene& scene, const std::string& name) {
    Technique technique = scene.renderer.open_technique(name);
    DrawOptions options;
    options.width = protocol_width;
    options.height = protocol_height;
    (void)scene.renderer.draw(scene.model, technique, options);  // compiles and uploads
    for (auto _ : state) benchmark::DoNotOptimize(scene.renderer.draw(scene.model, technique, options));
}

void time_pass(benchmark::State& state, Scene& scene, const std::string& name, std::size_t pass) {
    Technique technique = scene.renderer.open_technique(name);
    DrawOptions options;
    options.width = large_width;
    options.height = large_height;
    (void)scene.renderer.draw(scene.model, technique, options);
    for (auto _ : state) {
        state.SetIterationTime(scene.renderer.time_passes(scene.model, technique, options)[pass].milliseconds * 1e-3);
    }
}

benchmark::internal::Benchmark* repeated(benchmark::internal::Benchmark* measured) {
    return measured->Unit(benchmark::kMillisecond)->Repetitions(9)->MinTime(0.1)->ReportAggregatesOnly(false);
}

void add_frames(Scene& scene, int thousands) {
    for (const std::string& technique : scene.renderer.technique_names()) {
        if (technique == "copy") continue;
        const std::string shown = technique == "phong" ? "yardstick: phong" : technique;
        const std::string name = fmt::format("{:3} k triangles at 620x500/{}", thousands, shown);
        repeated(benchmark::RegisterBenchmark(name.c_str(), [&scene, technique](benchmark::State& state) {
            time_frames(state, scene, technique);
        }))->UseRealTime();
    }
}

// Each technique's second pass.
void add_full_screen_passes(Scene& scene) {
    const std::pair<const char*, const char*> passes[] = {
        {"yardstick: a copy", "copy"}, {"edges, one colour", "ink_lines"}, {"edges, by cause", "edges"}};
    for (const auto& [shown, technique] : passes) {
        const std::string name = fmt::format("full-screen passes at 1024x768/{}", shown);
        repeated(benchmark::RegisterBenchmark(name.c_str(), [&scene, technique = std::string(technique)](
                                                                benchmark::State& state) {
            time_pass(state, scene, technique, 1);
        }))->UseManualTime();
    }
}

std::unique_ptr<Scene> make_scene(int triangles) {
    const std::string path = write_bumpy_torus(triangles);
    auto scene = std::make_unique<Scene>(
        Scene{Renderer::headless({.api = {}, .device = {}, .data_folders = {CROQUIS_BENCH_DATA}}), Model::load(path)});
    std::filesystem::remove(path);
    return scene;
}

}  // namespace
}  // namespace croquis::bench

int main(int argc, char** argv) {
    using namespace croquis::bench;
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    try {
        const auto small = make_scene(10'000);
        const auto large = make_scene(100'000);
        add_frames(*small, 10);
        add_frames(*large, 100);
        add_full_screen_passes(*small);
        RatioReporter reporter;
        benchmark::RunSpecifiedBenchmarks(&reporter);
    } catch (const croquis::Error& error) {
        fmt::print(stderr, "croquis_bench: {}\n", error.what());
        return 2;
    }
    return 0;
}
