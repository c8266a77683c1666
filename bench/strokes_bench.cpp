// What strokes cost: 10,000 of them as a ratio to as many triangles of the same area, and what finding lines adds to
// a turning surface, each within one run.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "base/files.h"
#include "croquis/croquis.h"
#include "ratio_reporter.h"
#include "sample_models.h"

namespace croquis::bench {
namespace {

constexpr int width = 1024, height = 768;

struct Scene {
    Renderer renderer;
    Model model;
    DrawOptions options;
};

// Rows of triangles 18 pixels wide and 3.6 high, whose bases are tagged: strokes of 18 by 1.8 pixels have their area.
std::string write_tagged_triangles() {
    constexpr int columns = 50, rows = 200;
    constexpr double base = 18.0, rise = 3.6;
    std::string text;
    auto out = std::back_inserter(text);
    int vertex = 1;
    for (int i = 0; i < rows; ++i) {
        for (int k = 0; k < columns; ++k, vertex += 3) {
            const double x = k * double(width) / columns, y = i * double(height) / rows;
            fmt::format_to(out, "v {} {} 0\nv {} {} 0\nv {} {} 0\nf {} {} {}\nl {} {}\n", x, y, x + base, y,
                           x + 0.5 * base, y + rise, vertex, vertex + 1, vertex + 2, vertex, vertex + 1);
        }
    }
    const auto path = std::filesystem::temp_directory_path() / fmt::format("croquis-bench-{}-tagged.obj", ::getpid());
    write_file_whole(path, text);
    return path.string();
}

std::unique_ptr<Scene> make_scene(const std::string& path) {
    auto scene = std::make_unique<Scene>(Scene{Renderer::headless(), Model::load(path), DrawOptions{}});
    std::filesystem::remove(path);
    scene->options.width = width;
    scene->options.height = height;
    return scene;
}

struct Style {
    std::string shown;
    std::string technique;
    std::vector<std::string> settings;
};

// A technique's only pass.
void time_pass(benchmark::State& state, Scene& scene, const Style& style) {
    Technique technique = scene.renderer.open_technique(style.technique, style.settings);
    (void)scene.renderer.draw(scene.model, technique, scene.options);
    for (auto _ : state) {
        state.SetIterationTime(scene.renderer.time_passes(scene.model, technique, scene.options).front().milliseconds *
                               1e-3);
    }
}

void time_turning(benchmark::State& state, Scene& scene, const Style& style) {
    Technique technique = scene.renderer.open_technique(style.technique, style.settings);
    (void)scene.renderer.draw(scene.model, technique, scene.options);
    double angle = 0;
    for (auto _ : state) {
        angle += 0.02;
        scene.options.view.direction = {std::cos(angle), 0.7, std::sin(angle)};
        benchmark::DoNotOptimize(scene.renderer.draw(scene.model, technique, scene.options));
    }
}

using Measure = void (*)(benchmark::State&, Scene&, const Style&);

benchmark::internal::Benchmark* add(const std::string& group, Scene& scene, const Style& style, Measure measure) {
    const std::string name = fmt::format("{} at {}x{}/{}", group, width, height, style.shown);
    return benchmark::RegisterBenchmark(
               name.c_str(), [&scene, style, measure](benchmark::State& state) { measure(state, scene, style); })
        ->Unit(benchmark::kMillisecond)
        ->Repetitions(9)
        ->MinTime(0.1)
        ->ReportAggregatesOnly(false);
}

void add_strokes(Scene& scene) {
    scene.options.view = View::named("front");
    scene.options.view.parallel = true;
    scene.options.view.fit = 1;
    const Style styles[] = {
        {"yardstick: triangles", "base", {}},
        {"strokes", "lines", {"lines.classes=tagged", "lines.tagged_width=1.8", "lines.visibility=none"}}};
    for (const Style& style : styles) add("10,000 of the same area", scene, style, time_pass)->UseManualTime();
}

// What lines add, where they are found while the surfaces are drawn.
void add_turning(Scene& scene) {
    const Style styles[] = {{"yardstick: surfaces", "cartoon_strokes", {"lines.render=false"}},
                            {"lines", "cartoon_strokes", {"surfaces.render=false"}},
                            {"surfaces and lines", "cartoon_strokes", {}}};
    for (const Style& style : styles) add("turning 100 k triangles", scene, style, time_turning)->UseRealTime();
}

}  // namespace
}  // namespace croquis::bench

int main(int argc, char** argv) {
    using namespace croquis::bench;
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    try {
        const auto flat = make_scene(write_tagged_triangles());
        const auto torus = make_scene(write_bumpy_torus(100'000));
        add_strokes(*flat);
        add_turning(*torus);
        RatioReporter reporter;
        benchmark::RunSpecifiedBenchmarks(&reporter);
    } catch (const croquis::Error& error) {
        fmt::print(stderr, "croquis_bench_strokes: {}\n", error.what());
        return 2;
    }
    return 0;
}
