// Corners of lines: where a hand would lift the pen.
#pragma once

#include <cstddef>
#include <vector>

#include "lines/stroke_spine.h"

namespace croquis::lines {

/// The vertices at which a line turns by more than `angle` (radians), in ascending order: it must turn so both between
/// the points `reach` pixels before and behind and between those a quarter as far. So neither the zigzag of a scan's
/// silhouette nor a small circle has corners. Of several within `reach` the sharpest is one.
[[nodiscard]] std::vector<std::size_t> corners_of(const Spine& spine, double angle, double reach);

}  // namespace croquis::lines
