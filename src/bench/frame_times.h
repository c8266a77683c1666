// Times of finished frames, in turn: what slows the machine for a while slows all techniques alike.
#pragma once

#include <functional>
#include <vector>

#include "bench/benchmark.h"

namespace croquis::bench {

/// Each technique's frames are measured in so many batches. Odd, so that the median is one of them.
constexpr int batches_of_each = 11;

/// The middle value; the mean of both where the count is even. Of at least one value.
[[nodiscard]] double median(std::vector<double> values);

/// Draws each technique warm, then a batch of each in turn, over and over. `next_round` is called before each turn. The
/// first technique is the one that ratios are to.
[[nodiscard]] std::vector<TechniqueTime> time_interleaved(Renderer& renderer, const Model& model,
                                                          std::vector<Technique>& techniques,
                                                          const DrawOptions& options, const Protocol& protocol,
                                                          const std::function<void()>& next_round);

/// Adds each pass's time, the median of some frames in turn.
void add_passes(Renderer& renderer, const Model& model, std::vector<Technique>& techniques, const DrawOptions& options,
                std::vector<TechniqueTime>& times);

}  // namespace croquis::bench
