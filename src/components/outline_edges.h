// The edges that outlines are drawn along: which of a surface's edges bound what the eye sees of it, as lines for
// data/shaders/outline.glsl. Found on the processor: a software renderer would run the vertex shader for the four
// corners of every edge of the mesh.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <vector>

#include "lines/silhouette_finder.h"
#include "lines/surface.h"
#include "lines/viewpoint.h"

namespace croquis::components {

/// A line to draw. Points are in scene space.
struct OutlineEdge {
    glm::vec3 start, end;
    glm::vec3 inside;  ///< a point on the side of the line where the surface lies
    glm::u8vec4 start_color, end_color;
};

/// An edge and the third corner of one of its faces.
struct EdgeWithFace {
    std::uint32_t edge = 0;
    std::uint32_t inside = 0;
};

/// Finds edges of one surface, view after view.
class OutlineEdges {
public:
    explicit OutlineEdges(std::shared_ptr<const lines::Surface> surface);

    [[nodiscard]] const lines::Surface& surface() const { return *surface_; }

    /// Edges all whose shown faces lie on one side of them as the eye sees it: of a closed surface those between a face
    /// that is turned to the eye and one that is not, and borders always. `shown` has an entry a mesh.
    [[nodiscard]] std::vector<EdgeWithFace> contours(const lines::Viewpoint& view, const std::vector<bool>& shown);

    enum class Facing { front, back };
    /// The edges of the faces that are turned to the eye, or away from it: what drawing those faces in line mode shows.
    /// Of edges with two faces only those that faces of both kinds share: other back edges are hidden or lie within a
    /// surface, other front edges have no back edge to meet.
    [[nodiscard]] std::vector<EdgeWithFace> edges_of_faces(const lines::Viewpoint& view, Facing facing,
                                                           const std::vector<bool>& shown) const;

    /// Edges on the surface that hold in every view: where it bends by more than an angle (radians), where two meshes
    /// or materials meet, and what the model's author marked.
    [[nodiscard]] std::vector<EdgeWithFace> inner_edges(double crease_angle, const std::vector<bool>& shown) const;

    /// The lines without those that hang together and are shorter in all than so many pixels of the picture.
    [[nodiscard]] std::vector<EdgeWithFace> without_specks(std::vector<EdgeWithFace> lines,
                                                           const lines::Viewpoint& view, double shortest) const;

private:
    [[nodiscard]] bool bounds_its_faces(std::uint32_t edge, const lines::Viewpoint& view,
                                        const std::vector<bool>& shown) const;
    [[nodiscard]] std::vector<std::uint32_t> contour_candidates(const lines::Viewpoint& view,
                                                                const std::vector<bool>& shown);
    [[nodiscard]] std::uint32_t third_corner(std::uint32_t edge, std::uint32_t face) const;

    std::shared_ptr<const lines::Surface> surface_;
    std::unique_ptr<lines::SilhouetteFinder> finder_;
    std::vector<std::uint32_t> material_boundaries_;
};

}  // namespace croquis::components
