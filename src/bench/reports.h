// What was measured, for people, for programs and as a picture.
#pragma once

#include <string>

#include "bench/benchmark.h"

namespace croquis::bench {

/// A block of lines a level, and one for stability.
[[nodiscard]] std::string table(const Benchmark& benchmark);

/// See docs/bench.md for the keys.
[[nodiscard]] std::string json(const Benchmark& benchmark);

/// The ratios over the number of faces, as the bytes of an "svg" or "png" file.
[[nodiscard]] std::string ratio_plot(const Benchmark& benchmark, const std::string& format);

}  // namespace croquis::bench
