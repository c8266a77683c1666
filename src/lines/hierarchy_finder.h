// Silhouettes by a hierarchy in dual space: exact for perspective and parallel views (SPEC row L5).
#pragma once

#include <memory>

#include "lines/silhouette_finder.h"

namespace croquis::lines {

/// A face is the point (n, w) of its plane n · x + w = 0 in a space of four dimensions, an edge the segment between its
/// two faces. A view is a hyperplane through the origin there: (e, 1) for an eye at e, (d, 0) for the direction d of a
/// parallel projection. The silhouettes are the segments that it cuts. Segments are sorted into blocks that are compact
/// in that space, with boxes over the blocks in a tree: a box beside the hyperplane holds no silhouette.
[[nodiscard]] std::unique_ptr<SilhouetteFinder> make_hierarchy_finder(const Surface& surface);

}  // namespace croquis::lines
