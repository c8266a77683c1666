#include <fmt/format.h>

#include "bench/reports.h"
#include "output/line_plot.h"

namespace croquis::bench {

std::string ratio_plot(const Benchmark& benchmark, const std::string& format) {
    output::LinePlot plot{.title = fmt::format("{} at {}x{}", benchmark.model, benchmark.width, benchmark.height),
                          .x_label = "triangles",
                          .y_label = fmt::format("time of a frame, {} = 1", default_renderer),
                          .lines = {}};
    const std::vector<TechniqueTime>& techniques = benchmark.levels.front().techniques;
    for (std::size_t t = 0; t < techniques.size(); ++t) {
        output::PlotLine& line = plot.lines.emplace_back();
        line.label = techniques[t].technique;
        for (const LevelTimes& level : benchmark.levels) {
            line.points.emplace_back(double(level.triangles), level.techniques[t].ratio);
        }
    }
    return output::line_plot_bytes(plot, format);
}

}  // namespace croquis::bench
