#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "bench/reports.h"

namespace croquis::bench {
namespace {

std::size_t name_width(const Benchmark& benchmark) {
    std::size_t width = 9;  // "technique"
    for (const LevelTimes& level : benchmark.levels) {
        for (const TechniqueTime& time : level.techniques) width = std::max(width, time.technique.size());
    }
    return width;
}

}  // namespace

std::string table(const Benchmark& benchmark) {
    std::string text;
    auto out = std::back_inserter(text);
    const std::size_t width = name_width(benchmark);
    fmt::format_to(out, "{} on {} ({})\n", benchmark.model, benchmark.machine.renderer, benchmark.machine.api);
    for (const LevelTimes& level : benchmark.levels) {
        fmt::format_to(out, "\n{} triangles, {:.1f} % of {}x{} pixels\n", level.triangles, level.coverage,
                       benchmark.width, benchmark.height);
        fmt::format_to(out, "  {:{}} {:>9} {:>8} {:>7} {:>7}\n", "technique", width, "ms", "fps", "ratio", "frames");
        for (const TechniqueTime& time : level.techniques) {
            fmt::format_to(out, "  {:{}} {:9.3f} {:8.1f} {:7.2f} {:7}\n", time.technique, width, time.milliseconds,
                           time.frames_a_second(), time.ratio, time.frames);
            for (const PassTime& pass : time.passes) {
                fmt::format_to(out, "    {:{}} {:9.3f}\n", pass.pass, width - 2, pass.milliseconds);
            }
        }
    }
    if (benchmark.stabilities.empty()) return text;
    fmt::format_to(out, "\nturning by a degree a picture\n  {:{}} {:>9} {:>8} {:>7}\n", "technique", width, "change",
                   "ratio", "pops %");
    for (const TechniqueStability& one : benchmark.stabilities) {
        fmt::format_to(out, "  {:{}} {:9.3f} {:8.2f} {:7.2f}\n", one.technique, width, one.change, one.ratio, one.pops);
    }
    return text;
}

}  // namespace croquis::bench
