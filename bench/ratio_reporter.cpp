#include "ratio_reporter.h"

#include <fmt/format.h>

#include <algorithm>

namespace croquis::bench {
namespace {

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

}  // namespace

void RatioReporter::ReportRuns(const std::vector<Run>& runs) {
    for (const Run& run : runs) {
        if (run.run_type != Run::RT_Iteration) continue;
        const std::string& name = run.run_name.function_name;
        const std::size_t slash = name.find('/');
        milliseconds_[name.substr(0, slash)][name.substr(slash + 1)].push_back(run.GetAdjustedRealTime());
    }
}

void RatioReporter::Finalize() {
    for (const auto& [group, measured] : milliseconds_) {
        const auto yardstick = std::find_if(measured.begin(), measured.end(),
                                            [](const auto& entry) { return entry.first.starts_with("yardstick"); });
        fmt::print("\n{}\n  {:24} {:>9} {:>7}\n", group, "", "ms", "ratio");
        for (const auto& [what, times] : measured) {
            fmt::print("  {:24} {:9.2f}", what, median(times));
            if (yardstick != measured.end()) fmt::print(" {:7.2f}", median(times) / median(yardstick->second));
            fmt::print("\n");
        }
    }
}

}  // namespace croquis::bench
