// Pieces of edges joined into long curves (SPEC row L8).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lines/image_edges.h"
#include "lines/visibility.h"

namespace croquis::lines {

/// What pieces must have in common to be one line.
struct ChainKey {
    LineClass line_class = LineClass::silhouette;
    std::uint32_t mesh = 0;
    std::uint32_t layers = 0;
    bool operator==(const ChainKey&) const = default;
};

/// A piece as a part of a chain.
struct Link {
    std::uint32_t piece = 0;
    bool reversed = false;  ///< passed from its later share to its earlier one
};

/// Chains of pieces, each from one end to the other.
struct Chains {
    struct Chain {
        std::uint32_t first_link = 0;
        std::uint32_t link_count = 0;
        bool closed = false;
    };
    std::vector<Chain> chains;
    std::vector<Link> links;

    [[nodiscard]] std::span<const Link> links_of(const Chain& chain) const {
        return std::span(links).subspan(chain.first_link, chain.link_count);
    }
};

/// Joins pieces with equal keys where they share an end. Where more than two meet, those go on into each other that
/// turn least, if they turn by less than 45 degrees. `pieces` are sorted by edge and share; one key a piece.
[[nodiscard]] Chains chain_pieces(const ImageEdges& edges, std::span<const Piece> pieces,
                                  std::span<const ChainKey> keys);

}  // namespace croquis::lines
