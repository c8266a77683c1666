// Visible lines of a turning model: what each way of deciding visibility costs, and what cleaning adds. Models named on
// the command line are measured too: croquis_bench_lines bunny.obj
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "croquis/error.h"
#include "line_models.h"
#include "lines/drafter.h"
#include "model/load.h"
#include "ratio_reporter.h"

namespace croquis::bench {
namespace {

using lines::Drafter;
using lines::LineClass;
using lines::Options;
using lines::Surface;
using lines::Visibility;
using SurfacePointer = std::shared_ptr<const Surface>;

Options exact(Visibility visibility) {
    Options options;
    options.classes = {LineClass::silhouette, LineClass::border, LineClass::crease};
    options.visibility = visibility;
    options.clean = false;
    return options;
}

enum class Views { one, turning };

void add(const std::string& group, const std::string& what, const SurfacePointer& surface, const Options& options,
         Views views = Views::one) {
    benchmark::RegisterBenchmark(
        fmt::format("{}/{}", group, what).c_str(),
        [=](benchmark::State& state) {
            Drafter drafter(surface, options);
            int degrees = 45;
            benchmark::DoNotOptimize(drafter.draw(turned(degrees, model::Projection::perspective)));
            for (auto _ : state) {
                if (views == Views::turning) ++degrees;
                benchmark::DoNotOptimize(drafter.draw(turned(degrees, model::Projection::perspective)));
            }
        })
        ->Unit(benchmark::kMillisecond)
        ->Repetitions(5)
        ->MinTime(0.1)
        ->UseRealTime();
}

void add_model(const std::string& name, const SurfacePointer& surface) {
    const std::string group = fmt::format("lines of {}, {} triangles", name, surface->face_count());
    Options cleaned = exact(Visibility::automatic);
    cleaned.clean = true;
    add(group, "yardstick: all edges drawn, no visibility", surface, exact(Visibility::none));
    add(group, "quantitative invisibility", surface, exact(Visibility::quantitative));
    add(group, "the same, a degree further each view", surface, exact(Visibility::quantitative), Views::turning);
    add(group, "walking in place of rays", surface, exact(Visibility::walking));
    add(group, "a ray a piece", surface, exact(Visibility::ray_cast));
    add(group, "cleaned", surface, cleaned);
    benchmark::RegisterBenchmark(fmt::format("{}/adjacency and trees, once", group).c_str(),
                                 [=](benchmark::State& state) {
                                     for (auto _ : state) {
                                         const auto made = std::make_shared<const Surface>(
                                             std::shared_ptr<const model::Model>(surface, &surface->model()));
                                         benchmark::DoNotOptimize(Drafter(made, exact(Visibility::automatic)));
                                     }
                                 })
        ->Unit(benchmark::kMillisecond)
        ->Repetitions(3)
        ->UseRealTime();
}

}  // namespace
}  // namespace croquis::bench

int main(int argc, char** argv) {
    using namespace croquis;
    using namespace croquis::bench;
    benchmark::Initialize(&argc, argv);
    try {
        add_model("a noisy sphere", std::make_shared<const Surface>(sphere(99, 0.5)));
        add_model("a smooth sphere", std::make_shared<const Surface>(sphere(354, 0)));
        for (int i = 1; i < argc; ++i) {
            add_model(std::filesystem::path(argv[i]).stem().string(),
                      std::make_shared<const Surface>(model::load(argv[i])));
        }
        RatioReporter reporter;
        benchmark::RunSpecifiedBenchmarks(&reporter);
    } catch (const croquis::Error& error) {
        fmt::print(stderr, "croquis_bench_lines: {}\n", error.what());
        return 2;
    }
    return 0;
}
