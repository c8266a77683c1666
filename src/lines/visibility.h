// Which parts of a view's lines are hidden, and by how many layers of surface (seed D, sections 3 and 4).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lines/crossings.h"
#include "lines/image_edges.h"
#include "lines/ray_caster.h"
#include "lines/viewpoint.h"

namespace croquis::lines {

/// A part of a line's edge over which the number of hiding layers is the same.
struct Piece {
    std::uint32_t edge = 0;   ///< image edge
    double from = 0, to = 1;  ///< shares of the edge in the picture
    /// Layers of surface in front, turned to the eye or away. Where only visible lines are asked for, 1 stands for any
    /// number that is not 0.
    std::uint32_t layers = 0;
};

/// Looks at the surface itself: what lies over one point of a line, what behind it.
class LayerProbe {
public:
    virtual ~LayerProbe() = default;

    /// Layers between the eye and the point at a share of an edge, not counting the faces of that edge, up to
    /// `at_most`. May be asked by several threads at once.
    [[nodiscard]] virtual std::uint32_t layers(const ImageEdge& edge, double share, std::uint32_t at_most) const = 0;

    /// True where nothing but the edge's own faces lies behind a point beside a visible part of it.
    [[nodiscard]] virtual bool is_open_behind(const ImageEdge& edge, const ImagePoint& beside) const = 0;
};

/// Asks a ray caster. Surfaces within `tolerance` (scene units) of the point hide nothing.
class RayProbe final : public LayerProbe {
public:
    RayProbe(const RayCaster& rays, const Surface& surface, const ImageEdges& edges, const Viewpoint& view,
             double tolerance);
    [[nodiscard]] std::uint32_t layers(const ImageEdge& edge, double share, std::uint32_t at_most) const override;
    [[nodiscard]] bool is_open_behind(const ImageEdge& edge, const ImagePoint& beside) const override;

private:
    const RayCaster& rays_;
    const Surface& surface_;
    const ImageEdges& edges_;
    const Viewpoint& view_;
    double tolerance_;
};

/// One view's edges and crossings, and what is asked about them.
struct VisibilityTask {
    const Surface& surface;
    const Viewpoint& view;
    const ImageEdges& edges;
    const std::vector<Crossing>& crossings;  ///< sorted by edge, then share
    bool count_layers = false;               ///< exact numbers of layers; else only whether there are any
};

struct VisibilityResult {
    std::vector<Piece> pieces;  ///< of lines alone, within the frame; by edge, then share
    std::size_t clusters = 0;
    std::size_t start_values = 0;
    std::size_t doubtful_clusters = 0;
};

/// Quantitative invisibility: clusters of connected edges, in which the number of layers is known but for one number a
/// cluster. `start` gives these; `robust` decides, piece by piece, clusters whose numbers contradict each other.
[[nodiscard]] VisibilityResult quantitative_invisibility(const VisibilityTask& task, const LayerProbe& start,
                                                         const LayerProbe& robust);

/// A probe for every piece between two crossings.
[[nodiscard]] VisibilityResult probed_visibility(const VisibilityTask& task, const LayerProbe& probe);

/// Everything visible.
[[nodiscard]] VisibilityResult all_visible(const VisibilityTask& task);

}  // namespace croquis::lines
