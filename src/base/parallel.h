// The one helper for parallel loops.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstddef>

namespace croquis {

/// Calls `body(begin, end)` for pieces that together cover [0, count), on all cores. Pieces of fewer than `grain`
/// items are not worth a thread. The body must not depend on how the range is cut.
template <typename Body>
void parallel_for(std::size_t count, std::size_t grain, const Body& body) {
    if (count <= grain) {
        if (count > 0) body(std::size_t{0}, count);
        return;
    }
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                      [&](const tbb::blocked_range<std::size_t>& piece) { body(piece.begin(), piece.end()); });
}

}  // namespace croquis
