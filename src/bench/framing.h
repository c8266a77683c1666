// The fixed view of the protocol, and how much of the frame a model covers in it (seed A, tables 2 and 3).
#pragma once

#include "bench/benchmark.h"

namespace croquis::bench {

/// Percent of the frame's pixels that the model covers.
[[nodiscard]] double coverage(Renderer& renderer, const Model& model, const DrawOptions& options);

/// From the protocol's direction, at the distance from which the model covers the asked share of the frame; as near as
/// the model's box allows where it never covers so much. The eye stands at a point, so that levels of detail share it.
[[nodiscard]] View view_with_coverage(Renderer& renderer, const Model& model, const Protocol& protocol);

/// The eye carried around its target about the upright axis. The view has both.
[[nodiscard]] View turned(const View& view, double degrees);

}  // namespace croquis::bench
