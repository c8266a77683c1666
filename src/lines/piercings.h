// Where edges pass through faces of other parts, or of their own: layers change there. It does not depend on the view,
// so what was asked once is kept.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <unordered_map>
#include <vector>

#include "lines/crossings.h"
#include "lines/cut_curves.h"
#include "lines/image_edges.h"
#include "lines/ray_caster.h"
#include "lines/surface.h"

namespace croquis::lines {

class PiercingFinder {
public:
    /// All three must live as long.
    PiercingFinder(const Surface& surface, const CutCurves& cuts, const RayCaster& rays);

    /// The piercings of a view's edges as crossings, in the order of the edges.
    [[nodiscard]] std::vector<Crossing> find(const ImageEdges& edges, const Viewpoint& view);

private:
    /// A number for each edge of the surface, then for each segment of the cuts.
    [[nodiscard]] std::uint32_t number_of(const ImageEdge& edge) const;
    [[nodiscard]] std::array<glm::dvec3, 2> ends_of(std::uint32_t number) const;
    /// The faces that an edge or segment begins, ends or lies in.
    void append_own_faces(std::uint32_t number, std::vector<std::uint32_t>& faces) const;
    void look_at(const std::vector<std::uint32_t>& numbers);

    const Surface& surface_;
    const CutCurves& cuts_;
    const RayCaster& rays_;
    std::vector<bool> is_known_;  // one a number
    std::unordered_map<std::uint32_t, std::vector<Piercing>> piercings_;
};

}  // namespace croquis::lines
