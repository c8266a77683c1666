// Where along a line a stroke has its points: the line's own vertices, and more where width or noise ask for them;
// dashes; repeated offset patterns.
#pragma once

#include <vector>

#include "lines/stroke_offsets.h"
#include "lines/stroke_spine.h"
#include "lines/stroke_style.h"

namespace croquis::lines {

/// A part of a line and how finely it is sampled.
struct MarkRequest {
    double begin = 0;  ///< arc lengths, pixels
    double end = 0;
    double taper_start = 0;  ///< lengths from the line's ends that are sampled finely
    double taper_end = 0;
    double step = 0;  ///< at most between two marks; 0: any
};

/// The arc lengths of the points that a part of a line is drawn with, ascending from `begin` to `end`. Each vertex of
/// the line between them is one.
void mark(const Spine& spine, const MarkRequest& request, std::vector<double>& marks);

/// A part of a line, by arc lengths.
struct Stretch {
    double begin = 0;
    double end = 0;
};

/// Scales on, off, on, off … so that an open line begins and ends with a dash, or a closed one closes with a gap. A
/// line too short for one gap becomes one dash.
void fit_dashes(std::vector<double>& lengths, double line_length, bool closed);

/// The dashes of a line. A pattern too fine to be seen, of less than a quarter of a pixel, gives one for all of it.
[[nodiscard]] std::vector<Stretch> dashes(const std::vector<double>& lengths, double line_length);

/// The scale at which a pattern runs along a line. At most 16 points of it fall on a pixel.
[[nodiscard]] double fitted_scale(const OffsetPattern& pattern, double scale, OffsetRun run, double line_length);

/// Two neighbouring vertices of a repeated pattern, cut off at the line's end; in pixels of the drawing.
struct OffsetPiece {
    OffsetPoint begin, end;
    bool joined = true;  ///< to the piece before
};

/// The pieces of a pattern repeated over a line, in order.
[[nodiscard]] std::vector<OffsetPiece> offset_pieces(const OffsetPattern& pattern, double scale, double line_length);

}  // namespace croquis::lines
