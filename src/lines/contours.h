// Which silhouettes and borders are the outline of the whole drawing.
#pragma once

#include <vector>

#include "lines/chains.h"
#include "lines/visibility.h"

namespace croquis::lines {

/// Cuts visible pieces of hiding edges where the surface behind them may begin or end, and marks those with nothing
/// of the model behind their outer side: their class becomes contour. One key a piece, before and after.
void find_contours(const VisibilityTask& task, const LayerProbe& probe, std::vector<Piece>& pieces,
                   std::vector<ChainKey>& keys);

}  // namespace croquis::lines
