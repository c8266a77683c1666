// Where lines pass behind hiding edges in the picture, found on a grid (seed D, implementation details).
#pragma once

#include <cstdint>
#include <vector>

#include "lines/image_edges.h"

namespace croquis::lines {

/// A place on a line where the number of layers that hide it may change.
struct Crossing {
    std::uint32_t edge = 0;    ///< image edge of the line
    std::uint32_t other = 0;   ///< image edge that passes there; for a pierced face the face
    double share = 0;          ///< of the line's edge in the picture, from a to b
    std::int8_t gain = 0;      ///< layers gained beyond; 0 where the other edge lies behind the line
    bool is_piercing = false;  ///< the line goes through a face there
    bool is_doubtful = false;  ///< the two are so near each other in depth that rounding may decide
};

/// Finds where lines cross edges that hide, whichever of the two is nearer. Edges that share an end do not cross.
/// Sorted by edge, then share. Throws Error for a tangle, in which lines cross many million times.
class CrossingFinder {
public:
    void find(const ImageEdges& edges);
    [[nodiscard]] const std::vector<Crossing>& crossings() const { return crossings_; }

private:
    struct Grid {
        glm::dvec2 low{0.0};
        glm::dvec2 cells_a_pixel{1.0};
        int columns = 1, rows = 1;
    };
    template <typename Visit>
    void visit_cells(const glm::dvec2& a, const glm::dvec2& b, const Visit& visit) const;
    void place_grid(const ImageEdges& edges);
    void fill_grid(const ImageEdges& edges);
    /// Finds the crossings of an edge with edges that hide; of pairs that both hide, those in which it is the earlier.
    void test(const ImageEdges& edges, std::uint32_t line, std::vector<std::uint32_t>& met,
              std::vector<Crossing>& found) const;
    void sort_by_edge(const std::vector<std::vector<Crossing>>& found, std::size_t edge_count);

    struct Box {
        float left, top, right, bottom;
    };

    Grid grid_;
    std::vector<Box> boxes_;             // one an image edge, a little too large
    std::vector<std::uint32_t> hiding_;  // image edges with a step
    std::vector<std::uint32_t> cell_starts_, cell_edges_;
    std::vector<std::uint32_t> edge_starts_;  // in crossings_
    std::vector<Crossing> crossings_;
};

}  // namespace croquis::lines
