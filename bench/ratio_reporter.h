// Prints each measurement as a ratio to another of the same run.
#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>

namespace croquis::bench {

/// Measurements are named "group/what"; the one of a group whose name starts with "yardstick" is 1.
class RatioReporter final : public benchmark::ConsoleReporter {
public:
    void ReportRuns(const std::vector<Run>& runs) override;
    void Finalize() override;

private:
    std::map<std::string, std::map<std::string, std::vector<double>>> milliseconds_;  // group, what, repetitions
};

}  // namespace croquis::bench
