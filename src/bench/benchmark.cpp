#include "bench/benchmark.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "bench/frame_times.h"
#include "bench/framing.h"
#include "bench/stability.h"

namespace croquis::bench {
namespace {

constexpr std::int64_t most_levels = 20;
constexpr std::int64_t most_frames = 10'000'000;

void check(const Protocol& protocol) {
    if (protocol.levels < 1 || protocol.levels > most_levels) {
        fail("expected 1 to {} levels of detail, found {}", most_levels, protocol.levels);
    }
    if (protocol.frames < 1 || protocol.frames > most_frames) {
        fail("expected 1 to {} frames to measure, found {}", most_frames, protocol.frames);
    }
    if (!(protocol.seconds > 0)) fail("expected more than 0 seconds to measure, found {:g}", protocol.seconds);
    if (!(protocol.coverage > 0 && protocol.coverage <= 100)) {
        fail("expected the model to cover more than 0 and at most 100 percent, found {:g}", protocol.coverage);
    }
}

/// The default renderer, and then each other technique once.
std::vector<std::string> names_to_measure(const Protocol& protocol) {
    std::vector<std::string> names{default_renderer};
    for (const std::string& name : protocol.techniques) {
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    return names;
}

std::vector<std::size_t> level_sizes(const Model& model, const Protocol& protocol) {
    if (!protocol.triangles.empty()) return protocol.triangles;
    std::vector<std::size_t> sizes;
    for (std::int64_t level = 0; level < protocol.levels; ++level) {
        sizes.push_back(std::size_t(std::lround(double(model.triangle_count()) / std::pow(2.0, double(level)))));
    }
    return sizes;
}

/// Each level is made from the whole model, so that errors do not add up.
std::vector<Model> levels_of_detail(const Model& model, const Protocol& protocol) {
    std::vector<Model> levels;
    for (const std::size_t triangles : level_sizes(model, protocol)) {
        if (triangles > model.triangle_count()) {
            fail("expected a model of at least {} triangles, found {}", triangles, model.triangle_count());
        }
        levels.push_back(model.simplified(triangles));
    }
    return levels;
}

}  // namespace

std::size_t step_count(const Protocol& protocol) {
    const std::size_t levels = protocol.triangles.empty() ? std::size_t(protocol.levels) : protocol.triangles.size();
    return levels * batches_of_each + (protocol.stability ? names_to_measure(protocol).size() : 0);
}

Benchmark measure(Renderer& renderer, const Model& model, const std::string& name, const Protocol& protocol,
                  const Step& step) {
    check(protocol);
    std::vector<Technique> techniques;
    for (const std::string& each : names_to_measure(protocol)) techniques.push_back(renderer.open_technique(each));
    const std::vector<Model> levels = levels_of_detail(model, protocol);
    DrawOptions options;
    options.width = protocol.width;
    options.height = protocol.height;
    options.view = view_with_coverage(renderer, model, protocol);
    Benchmark result{.machine = renderer.info(),
                     .model = name,
                     .width = protocol.width,
                     .height = protocol.height,
                     .levels = {},
                     .stabilities = {}};
    for (const Model& level : levels) {
        const auto next = [&] { step(std::to_string(level.triangle_count()) + " triangles"); };
        LevelTimes times{.triangles = level.triangle_count(),
                         .coverage = coverage(renderer, level, options),
                         .techniques = time_interleaved(renderer, level, techniques, options, protocol, next)};
        if (protocol.passes) add_passes(renderer, level, techniques, options, times.techniques);
        result.levels.push_back(std::move(times));
    }
    if (protocol.stability) result.stabilities = measure_stability(renderer, model, techniques, options, step);
    return result;
}

}  // namespace croquis::bench
