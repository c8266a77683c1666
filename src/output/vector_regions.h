// Flat regions: which mesh is seen where, as areas to be filled.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "lines/surface.h"
#include "lines/viewpoint.h"
#include "output/vector_page.h"

namespace croquis::output {

constexpr std::uint32_t no_region = 0xffffffffu;

/// A straight piece of a line that may part two regions, pixels.
struct BoundaryPiece {
    glm::dvec2 from{0.0};
    glm::dvec2 to{0.0};
};

/// What is at a point of the picture: a region's number, or no_region.
using RegionAt = std::function<std::uint32_t(const glm::dvec2&)>;

/// Cuts a frame into regions along pieces of lines, and gives each region's area as closed rings for the nonzero rule;
/// one entry a region, `count` of them.
///
/// The frame is cut into bands at the heights where pieces begin, end or cross, and each band at the pieces that pass
/// through it. `region_at` is asked once for each cell that this gives; then cells of one region grow together. Where
/// lines part what they should, areas are exact; a gap in a line shifts the border within the cells at the gap alone.
[[nodiscard]] std::vector<std::vector<Ring>> regions_between(std::span<const BoundaryPiece> pieces, double width,
                                                             double height, std::uint32_t count,
                                                             const RegionAt& region_at);

/// Finds the mesh that is seen at a point of a view, by the faces whose projections lie there.
class MeshPicker {
public:
    /// Both must live as long.
    MeshPicker(const lines::Surface& surface, const lines::Viewpoint& view);

    /// The nearest face's mesh, or no_region.
    [[nodiscard]] std::uint32_t mesh_at(const glm::dvec2& pixel) const;

private:
    struct Span {
        int low_x, low_y, high_x, high_y;
    };
    [[nodiscard]] Span cells_of(std::uint32_t face) const;
    [[nodiscard]] double nearness_at(std::uint32_t face, const glm::dvec3& eye, const glm::dvec3& ray) const;

    const lines::Surface& surface_;
    const lines::Viewpoint& view_;
    double cell_ = 8;  // pixels
    int columns_ = 1, rows_ = 1;
    std::vector<std::uint32_t> starts_, faces_;  // by cell
};

}  // namespace croquis::output
