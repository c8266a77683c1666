// From chains to the points of lines.
#pragma once

#include <vector>

#include "lines/chains.h"
#include "lines/drawing.h"
#include "lines/visibility.h"

namespace croquis::lines {

/// The drawing of a view's chains. Points between two pieces that go on straight are left out.
[[nodiscard]] Drawing trace(const VisibilityTask& task, const Chains& chains, const std::vector<Piece>& pieces,
                            const std::vector<ChainKey>& keys);

/// Drops lines that are seen end-on, as points. Their points stay in the drawing, named by no line.
void drop_points(Drawing& drawing);

}  // namespace croquis::lines
