// Silhouette finders, each as a ratio to the exhaustive one, while a model turns (seed D, section 3; seed E, table 1).
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <memory>
#include <vector>

#include "base/random.h"
#include "croquis/error.h"
#include "lines/gauss_map_finder.h"
#include "lines/silhouette_finder.h"
#include "model/load.h"
#include "ratio_reporter.h"

namespace croquis::bench {
namespace {

using lines::Surface;
using lines::Viewpoint;

/// An octahedron's sides cut into 8 n² triangles and brought onto a sphere; each vertex moved out by up to `noise`
/// times the length of an edge.
std::shared_ptr<const model::Model> sphere(int n, double noise) {
    const Random random(1, "noise");
    model::RawModel raw;
    model::RawMesh& mesh = raw.meshes.emplace_back();
    mesh.mesh.name = "sphere";
    const auto corner = [&](int x, int y, int z) {
        const glm::dvec3 sines = glm::sin(glm::dvec3(x, y, z) * (1.570796327 / n));
        const auto index = (std::uint64_t(x + n) * 4096 + std::uint64_t(y + n)) * 4096 + std::uint64_t(z + n);
        mesh.mesh.triangles.push_back(static_cast<std::uint32_t>(mesh.mesh.positions.size()));
        mesh.mesh.positions.emplace_back(glm::normalize(sines) * (1.0 + noise * random.unit(index) / n));
    };
    for (int octant = 0; octant < 8; ++octant) {
        const int sx = (octant & 1) != 0 ? -1 : 1, sy = (octant & 2) != 0 ? -1 : 1, sz = (octant & 4) != 0 ? -1 : 1;
        const bool mirrored = sx * sy * sz < 0;
        const auto triangle = [&](const glm::ivec2& a, const glm::ivec2& b, const glm::ivec2& c) {
            for (const glm::ivec2& p : {a, mirrored ? c : b, mirrored ? b : c}) {
                corner(sx * p.x, sy * p.y, sz * (n - p.x - p.y));
            }
        };
        for (int i = 0; i < n; ++i) {
            for (int k = 0; k < n - i; ++k) {
                triangle({i, k}, {i + 1, k}, {i, k + 1});
                if (i + k < n - 1) triangle({i + 1, k}, {i + 1, k + 1}, {i, k + 1});
            }
        }
    }
    return model::finish(std::move(raw), "sphere");
}

/// A turn by a degree a view.
Viewpoint turned(int degrees, model::Projection projection) {
    const double turn = 0.01745329 * degrees;
    Viewpoint view;
    view.projection = projection;
    view.back = glm::normalize(glm::dvec3(std::cos(turn), 0.5, std::sin(turn)));
    view.eye = 2.6 * view.back;
    return view;
}

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
