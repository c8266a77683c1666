// Layers over a point of the picture without a ray and without a tree: by walking over the surface from where it comes
// into the way (seed D, "Walking").
//
// A straight path leads from the point out of the picture's silhouettes, to where there is no surface. Each sheet that
// lies over the point comes into the path at an edge that hides, and goes on from face to face until it is over the
// point or until it ends at another edge that hides. If no edge lies on the path, nothing encloses the point.
//
// Which face follows is decided by which side of the path's line each vertex lies on and by how faces are turned to the
// eye, each decided once and for all: no rounding leads a walk astray, and each walk ends. What rounding can change is
// a layer whose edge is, within rounding, at the point itself, or a face that is seen edge-on over it. As in
// the seed, edges that hide and were not found count no layers.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <limits>
#include <span>
#include <vector>

#include "lines/image_edges.h"
#include "lines/surface.h"
#include "lines/viewpoint.h"
#include "lines/visibility.h"

namespace croquis::lines {

/// One view's hiding edges, and walks from them. May be shared between threads. What it is made of must live as long.
class Walker {
public:
    /// False for views from among the surface, in which a part of it is nearer to the eye than the near distance:
    /// sheets that begin there have no edge to be found by. The frame, in contrast, may cut off what it likes.
    [[nodiscard]] static bool serves(const Surface& surface, const Viewpoint& view);

    /// `silhouettes` are the view's regular edges between faces turned to the eye and away; `edges` are gathered from
    /// them, and hold all that is needed unless the frame cut some off.
    Walker(const Surface& surface, const Viewpoint& view, const ImageEdges& edges,
           std::span<const std::uint32_t> silhouettes);

    /// What to count over a point of the picture.
    struct Aim {
        glm::dvec2 position{0.0};
        /// Only what is nearer to the eye than this counts; scene units.
        double eye_distance = std::numeric_limits<double>::infinity();
        std::array<std::uint32_t, 2> own_edge{no_vertex, no_vertex};  ///< faces that hold both vertices count nothing
        std::uint32_t at_most = 0xffffffffu;                          ///< enough to count up to here
    };
    struct Walk {
        std::uint32_t layers = 0;
        std::uint32_t sheets = 0;  ///< walked over
        std::uint32_t faces = 0;   ///< walked over: the cost
    };
    [[nodiscard]] Walk walk(const Aim& aim) const;

private:
    struct End {
        ImagePoint point;
        std::uint32_t vertex = no_vertex;
    };
    /// An edge that the path's line passes: its lower end has at most the path's coordinate, its upper end more.
    struct Gate {
        End lower, upper;
    };
    struct HidingEdge {
        End a, b;
        int step = 0;  ///< as ImageEdge::step
    };
    /// The hiding edges by the stretch that they cover of x or of y.
    struct Bands {
        double low = 0, bands_a_pixel = 1;
        std::size_t count = 1;
        std::vector<std::uint32_t> starts, edges;

        [[nodiscard]] std::size_t band_of(double coordinate) const;
    };
    struct Path;
    struct Entrance;

    [[nodiscard]] End end_at(std::uint32_t vertex) const;
    void take(const ImageEdges& edges);
    void gather(std::span<const std::uint32_t> silhouettes);
    void add(std::uint32_t edge, int step);
    void sort_into_bands(int axis);
    void find_entrances(const Aim& aim, Path* pair) const;
    void enter(const Aim& aim, const Path& path, const Entrance& entrance, Walk& walk) const;
    [[nodiscard]] bool follow(const Aim& aim, const Path& path, Gate gate, std::uint32_t face, Walk& walk) const;
    [[nodiscard]] std::uint32_t next_face(const Path& path, const Gate& gate, std::uint32_t face) const;

    const Surface& surface_;
    const Viewpoint& view_;
    std::vector<HidingEdge> hiding_;
    std::array<Bands, 2> bands_;  // of x, of y
};

/// Asks a walker. Surfaces within `tolerance` (scene units) before the point hide nothing.
class WalkProbe final : public LayerProbe {
public:
    WalkProbe(const Walker& walker, const Surface& surface, const ImageEdges& edges, const Viewpoint& view,
              double tolerance);
    [[nodiscard]] std::uint32_t layers(const ImageEdge& edge, double share, std::uint32_t at_most) const override;
    [[nodiscard]] bool is_open_behind(const ImageEdge& edge, const ImagePoint& beside) const override;

private:
    const Walker& walker_;
    const Surface& surface_;
    const ImageEdges& edges_;
    const Viewpoint& view_;
    double tolerance_;
};

}  // namespace croquis::lines
