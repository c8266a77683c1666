// What an illustrator would leave out and what he would close: docs/lines.md tells how this decides.
#pragma once

#include <vector>

#include "lines/chains.h"
#include "lines/drawing.h"
#include "lines/ray_caster.h"
#include "lines/visibility.h"

namespace croquis::lines {

/// All in pixels. Those of length grow with frames over 1,024 pixels: a drawing printed more finely tells no more, but
/// nothing below a dozen pixels can be told.
struct CleaningLimits {
    /// For the shorter side of a frame.
    explicit CleaningLimits(double frame);

    double longest_gap = 3;    ///< of a curve that its own surface hides for a moment
    double crumb = 12;         ///< shorter lines that stand alone go
    double long_line = 48;     ///< lines as long as this stay, whatever they show
    double depth_step = 3;     ///< what lies less far behind a silhouette is the same surface
    double reach = 3;          ///< ends nearer than this are joined, if one goes on as the other
    double longest_spur = 14;  ///< what a line may run on beyond the place where another takes over
    double joint_depth = 40;   ///< how far apart in depth joined lines may lie
    double shadow = 2.5;       ///< short lines go that keep this near to another one
    // These do not grow.
    double smoothing = 0.5;  ///< how far a point may move
    double detail = 0.12;    ///< points that change a line by less are left out
};

/// What speaks for keeping a line.
struct Merit {
    double length = 0;            ///< pixels
    double length_with_step = 0;  ///< of it, with nothing close behind the outer side
    double sharp_length = 0;      ///< of it, on edges that bend as a crease does
    double company = 0;           ///< length of all lines that hang together with it, or of its longest edge
};

/// Makes short hidden stretches visible between visible pieces of one curve, where nothing hides them but surface that
/// lies close in front: the folds of a bumpy surface, not another part of the model.
void close_gaps(const VisibilityTask& task, const RayCaster& rays, const CleaningLimits& limits,
                std::vector<Piece>& pieces);

/// The merits of chains; depth steps are looked for only where they decide.
[[nodiscard]] std::vector<Merit> merits_of(const VisibilityTask& task, const RayCaster& rays,
                                           const CleaningLimits& limits, const std::vector<Piece>& pieces,
                                           const std::vector<ChainKey>& keys, const Chains& chains);

/// Joins the visible lines of a drawing where one takes over from another, and cuts off what runs on beyond; merits go
/// along. One merit a line.
[[nodiscard]] Drawing join_lines(const Drawing& drawing, const Viewpoint& view, const CleaningLimits& limits,
                                 std::vector<Merit>& merits);

/// Leaves out lines of no merit.
[[nodiscard]] Drawing without_crumbs(const Drawing& drawing, const CleaningLimits& limits,
                                     const std::vector<Merit>& merits);

/// Takes zigzags out of lines, then points that say nothing. Corners between long edges stay.
[[nodiscard]] Drawing smoothed(const Drawing& drawing, const CleaningLimits& limits);

}  // namespace croquis::lines
