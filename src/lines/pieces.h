// Cutting edges into pieces: what the ways of deciding visibility have in common.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lines/visibility.h"

namespace croquis::lines {

struct Interval {
    double from = 0, to = 1;
};

/// The share of an edge that lies within the frame; from 0 to 0 where nothing does.
[[nodiscard]] Interval frame_interval(const Viewpoint& view, const ImageEdges& edges, const ImageEdge& edge);

/// Pixels.
[[nodiscard]] inline double length_of(const ImageEdges& edges, const Piece& piece) {
    return (piece.to - piece.from) * edges.length_of(edges.edges()[piece.edge]);
}

/// The crossings of each edge.
class CrossingsByEdge {
public:
    explicit CrossingsByEdge(const VisibilityTask& task);
    [[nodiscard]] std::span<const Crossing> of(std::uint32_t image_edge) const {
        return std::span(crossings_).subspan(starts_[image_edge], starts_[image_edge + 1] - starts_[image_edge]);
    }

private:
    const std::vector<Crossing>& crossings_;
    std::vector<std::uint32_t> starts_;
};

/// Appends a piece, or lengthens the last one if it goes on with as many layers.
void append_piece(std::vector<Piece>& pieces, const Piece& piece);

/// Appends the pieces of one edge, each decided by a probe in its middle.
void probe_edge(const VisibilityTask& task, const CrossingsByEdge& crossings, const LayerProbe& probe,
                std::uint32_t image_edge, std::vector<Piece>& pieces);

}  // namespace croquis::lines
