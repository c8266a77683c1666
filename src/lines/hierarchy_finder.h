// Silhouettes by a tree in dual space: exact for perspective and parallel views (SPEC row L5).
#pragma once

#include <memory>

#include "lines/silhouette_finder.h"

namespace croquis::lines {

/// Finds what the exhaustive finder finds, from the edges that a DualTree leaves over. On a smooth model these are in
/// proportion to the root of all edges; on a noisy one to all.
[[nodiscard]] std::unique_ptr<SilhouetteFinder> make_hierarchy_finder(const Surface& surface);

}  // namespace croquis::lines
