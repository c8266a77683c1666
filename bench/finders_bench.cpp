// Silhouette finders, each as a ratio to the exhaustive one, while a model turns (seed D, section 3; seed E, table 1).
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstdio>
#include <vector>

#include "croquis/error.h"
#include "line_models.h"
#include "lines/gauss_map_finder.h"
#include "lines/silhouette_finder.h"
#include "ratio_reporter.h"

namespace croquis::bench {
namespace {

using lines::Surface;

void add(const std::string& group, const Surface& surface, model::Projection projection,
         const std::vector<std::string>& finders) {
    for (const std::string& name : finders) {
        const std::string shown = fmt::format("{}/{}{}", group, name == "exhaustive" ? "yardstick: " : "", name);
        benchmark::RegisterBenchmark(shown.c_str(),
                                     [&surface, projection, name](benchmark::State& state) {
                                         const auto finder = lines::make_finder(name, surface);
                                         int degrees = 0;
                                         for (auto _ : state)
                                             benchmark::DoNotOptimize(finder->find(turned(++degrees, projection)));
                                     })
            ->Unit(benchmark::kMillisecond)
            ->Repetitions(5)
            ->MinTime(0.1)
            ->UseRealTime();
    }
}

void add_preparation(const std::string& group, const Surface& surface, const std::vector<std::string>& finders) {
    for (const std::string& name : finders) {
        const std::string shown = fmt::format("{}/{}{}", group, name == "hierarchy" ? "yardstick: " : "", name);
        benchmark::RegisterBenchmark(shown.c_str(),
                                     [&surface, name](benchmark::State& state) {
                                         for (auto _ : state)
                                             benchmark::DoNotOptimize(lines::make_finder(name, surface));
                                     })
            ->Unit(benchmark::kMillisecond)
            ->Repetitions(3)
            ->MinTime(0.1)
            ->UseRealTime();
    }
}

/// Seed E, table 2.
void print_gauss_map_levels(const std::string& name, const Surface& surface) {
    const auto separate = lines::gauss_map_counts(surface, lines::GaussBins::separate);
    const auto overlapping = lines::gauss_map_counts(surface, lines::GaussBins::overlapping);
    fmt::print("\narcs a level of the Gauss map: {}\n  level  no overlap  overlap\n", name);
    for (std::size_t level = 0; level < lines::gauss_map_levels; ++level) {
        fmt::print("  {:5} {:11} {:8}\n", level, separate[level], overlapping[level]);
    }
}

}  // namespace
}  // namespace croquis::bench

int main(int argc, char** argv) {
    using namespace croquis::bench;
    using croquis::model::Projection;
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    try {
        const Surface seed_e(sphere(99, 0)), noisy(sphere(99, 0.5)), million(sphere(354, 0)),
            noisy_million(sphere(354, 0.5));
        add("parallel, smooth 78 k", seed_e, Projection::parallel,
            {"exhaustive", "gauss_map", "gauss_map_overlapping", "hierarchy"});
        add("parallel, noisy 78 k", noisy, Projection::parallel,
            {"exhaustive", "gauss_map", "gauss_map_overlapping", "hierarchy"});
        add("perspective, noisy 78 k", noisy, Projection::perspective, {"exhaustive", "hierarchy", "randomised"});
        add("perspective, smooth 1 M", million, Projection::perspective, {"exhaustive", "hierarchy", "randomised"});
        add("perspective, noisy 1 M", noisy_million, Projection::perspective,
            {"exhaustive", "hierarchy", "randomised"});
        add_preparation("preparation, smooth 1 M", million, {"hierarchy", "randomised", "gauss_map"});
        RatioReporter reporter;
        benchmark::RunSpecifiedBenchmarks(&reporter);
        print_gauss_map_levels("smooth 78 k", seed_e);
        print_gauss_map_levels("noisy 78 k", noisy);
    } catch (const croquis::Error& error) {
        fmt::print(stderr, "croquis_bench_finders: {}\n", error.what());
        return 2;
    }
    return 0;
}
