// Prints each measurement as a ratio to another of the same run.
#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>

namespace croquis::bench {

/// Measurements are named "group/what"; within a group the one called `yardstick` is 1.
class RatioReporter final : public benchmark::ConsoleReporter {
public:
    explicit RatioReporter(std::string yardstick) : yardstick_(std::move(yardstick)) {}

    void ReportRuns(const std::vector<Run>& runs) override;
    void Finalize() override;

private:
    std::string yardstick_;
    std::map<std::string, std::map<std::string, std::vector<double>>> milliseconds_;  // group, what, repetitions
};

}  // namespace croquis::bench
