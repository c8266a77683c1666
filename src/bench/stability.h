// How much a drawing changes while its model turns: what flickers and pops changes more than its shading.
#pragma once

#include <vector>

#include "bench/benchmark.h"

namespace croquis::bench {

/// The mean absolute change between two pictures of one size, in levels of 0 to 255 over red, green and blue.
[[nodiscard]] double mean_change(const Picture& before, const Picture& after);

/// Percent of the pixels that changed by more than 64 levels in some channel, but by at most 8 in all channels of the
/// default renderer's pictures of the same two views.
[[nodiscard]] double popped_share(const Picture& before, const Picture& after, const Picture& default_before,
                                  const Picture& default_after);

/// Draws the model from the view of `options` and from 12 more, each turned by another degree about the upright axis.
/// `change` is the mean over the steps, `pops` the largest share of a step. The first technique is the one that ratios
/// are to.
[[nodiscard]] std::vector<TechniqueStability> measure_stability(Renderer& renderer, const Model& model,
                                                                std::vector<Technique>& techniques,
                                                                const DrawOptions& options, const Step& step);

}  // namespace croquis::bench
