#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "bench/reports.h"

namespace croquis::bench {
namespace {

using Json = nlohmann::ordered_json;

Json times(const LevelTimes& level) {
    Json list = Json::array();
    for (const TechniqueTime& time : level.techniques) {
        Json& one = list.emplace_back(Json{{"technique", time.technique},
                                           {"ms", time.milliseconds},
                                           {"fps", time.frames_a_second()},
                                           {"ratio", time.ratio},
                                           {"frames", time.frames}});
        for (const PassTime& pass : time.passes) {
            one["passes"].push_back({{"pass", pass.pass}, {"ms", pass.milliseconds}});
        }
    }
    return list;
}

}  // namespace

std::string json(const Benchmark& benchmark) {
    Json root{{"machine",
               {{"renderer", benchmark.machine.renderer},
                {"version", benchmark.machine.version},
                {"api", benchmark.machine.api},
                {"software", benchmark.machine.is_software}}},
              {"size", fmt::format("{}x{}", benchmark.width, benchmark.height)},
              {"model", benchmark.model},
              {"techniques", times(benchmark.levels.front())},
              {"levels", Json::array()}};
    for (const LevelTimes& level : benchmark.levels) {
        root["levels"].push_back(
            {{"triangles", level.triangles}, {"coverage", level.coverage}, {"techniques", times(level)}});
    }
    for (const TechniqueStability& one : benchmark.stabilities) {
        root["stability"].push_back(
            {{"technique", one.technique}, {"change", one.change}, {"ratio", one.ratio}, {"pops", one.pops}});
    }
    return root.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace croquis::bench
