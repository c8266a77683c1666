// Where edges pass through faces of other parts, or of their own: layers change there. It does not depend on the view,
// so what was asked once is kept.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "lines/crossings.h"
#include "lines/image_edges.h"
#include "lines/ray_caster.h"
#include "lines/surface.h"

namespace croquis::lines {

class PiercingFinder {
public:
    PiercingFinder(const Surface& surface, const RayCaster& rays);

    /// The piercings of a view's edges as crossings, in the order of the edges.
    [[nodiscard]] std::vector<Crossing> find(const ImageEdges& edges, const Viewpoint& view);

private:
    void look_at(const std::vector<std::uint32_t>& edges);

    const Surface& surface_;
    const RayCaster& rays_;
    std::vector<bool> is_known_;  // one an edge of the surface
    std::unordered_map<std::uint32_t, std::vector<Piercing>> piercings_;
};

}  // namespace croquis::lines
