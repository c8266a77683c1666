// Offset patterns: what a hand adds to a line, as vectors in the line's own frame (seed D, section 4). The file format
// is described in docs/strokes.md.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace croquis::lines {

/// A vertex of an offset pattern: p' = p(s) + tangent · t(s) + normal · n(s).
struct OffsetPoint {
    double along = 0;    ///< s: where on the line the vertex is held, pixels from the beginning of the pattern
    double tangent = 0;  ///< o_t: pixels onwards along the line
    double normal = 0;   ///< o_n: pixels to the left of someone who walks along the line
    bool joined = true;  ///< to the vertex before it; false after a break. The first vertex: to the last pattern's last
};

/// A pattern that repeats along a line.
struct OffsetPattern {
    std::string help;
    double length = 0;  ///< of the line that one pattern covers, pixels
    std::vector<OffsetPoint> points;
};

/// Reads the text of an offset file. Throws Error at a line and column of `file_name`.
[[nodiscard]] OffsetPattern read_offsets(std::string_view text, const std::string& file_name);

constexpr std::size_t most_offset_points = 4096;

}  // namespace croquis::lines
