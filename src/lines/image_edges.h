// The edges of one view in the picture: those that are lines, and those that hide (seed D, section 3).
#pragma once

#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <span>
#include <vector>

#include "lines/features.h"
#include "lines/line_class.h"
#include "lines/surface.h"
#include "lines/viewpoint.h"

namespace croquis::lines {

constexpr std::uint32_t no_vertex = 0xffffffffu;

/// An end of image edges.
struct ImageVertex {
    glm::dvec2 position{0.0};  ///< pixels, moved by a billionth of the frame at most, so that no three ends line up
    double nearness = 0;       ///< as ImagePoint::nearness
    std::uint32_t vertex = no_vertex;  ///< of the surface; none for an end that was cut off or lies within faces
};

/// A piece of a mesh edge, or of another curve on the surface, in the picture.
struct ImageEdge {
    std::uint32_t a = 0, b = 0;  ///< image vertices
    std::uint32_t edge = 0;      ///< of the surface; of an intersection, the segment of Features::cuts
    /// Layers of surface gained by passing behind the edge from the side where orientation(a, b, p) is positive to the
    /// other: 2 or -2 for a silhouette, 1 or -1 for a border, 0 for an edge that ends no surface in the picture.
    std::int8_t step = 0;
    LineClass line_class = LineClass::silhouette;
    bool is_line = false;     ///< to be drawn; else it only hides
    bool never_seen = false;  ///< a concave silhouette or a turned away crease of a solid: its own body hides it
    /// One of its faces is seen edge-on: at its ends and beside it, what hides what is a matter of rounding.
    bool is_edge_on = false;
    bool is_sharp = false;  ///< of a regular silhouette: it bends as a crease does
    /// Of a regular silhouette: 1 where it is convex, its nearer face turned to the eye (seed D calls it front facing),
    /// -1 where it is concave; 0 where that is too close to call, and for other edges.
    std::int8_t bend = 0;
};

/// A vertex of the surface in the picture, moved as ImageVertex::position is.
[[nodiscard]] ImagePoint image_of(const Surface& surface, const Viewpoint& view, std::uint32_t vertex);

/// +1 where a face lies on the side of one of its edges where orientation(first vertex, second vertex, p) is negative
/// in the picture, else -1.
[[nodiscard]] int side_of(const Surface& surface, const model::Edge& edge, std::uint32_t face, const Viewpoint& view);

/// All edges of a view that are lines or hide, with the ends that they share.
class ImageEdges {
public:
    explicit ImageEdges(const Surface& surface);

    /// Gathers a view's edges. `silhouettes` are regular edges in ascending order.
    void gather(const Viewpoint& view, const Features& features, std::span<const std::uint32_t> silhouettes,
                LineClasses classes);

    [[nodiscard]] const std::vector<ImageVertex>& vertices() const { return vertices_; }
    [[nodiscard]] const std::vector<ImageEdge>& edges() const { return edges_; }

    /// The two faces that an edge belongs to: of an intersection, those that meet there; of an irregular edge, one of
    /// its faces twice.
    [[nodiscard]] FacePair faces_of(const ImageEdge& edge) const {
        if (edge.line_class != LineClass::intersection) return surface_.pairs()[edge.edge];
        const auto& [first, second] = cuts_->segments[edge.edge].faces;
        return {first, second};
    }

    /// The image edges at an image vertex.
    [[nodiscard]] std::span<const std::uint32_t> edges_at(std::uint32_t vertex) const {
        return std::span(around_).subspan(around_starts_[vertex], around_starts_[vertex + 1] - around_starts_[vertex]);
    }
    /// True when nothing of the surface's edges was cut off or left out because it lies outside of the frame.
    [[nodiscard]] bool is_whole() const { return is_whole_; }

    /// From a to b, and how far that is, in pixels.
    [[nodiscard]] glm::dvec2 along(const ImageEdge& edge) const {
        return vertices_[edge.b].position - vertices_[edge.a].position;
    }
    [[nodiscard]] double length_of(const ImageEdge& edge) const { return glm::length(along(edge)); }

    /// A point of an edge: 0 is a, 1 is b; shares are of the length in the picture.
    [[nodiscard]] ImagePoint point_at(const ImageEdge& edge, double share) const;

    /// The same, moved by some pixels to the outer side of the surface that ends there. The edge must have a step and a
    /// length.
    [[nodiscard]] ImagePoint point_beside(const ImageEdge& edge, double share, double pixels) const;

private:
    /// An end in space. Numbers count the surface's vertices, then the nodes of cuts.
    struct End {
        glm::dvec3 point;
        std::uint32_t number;
    };
    /// An edge on its way into the picture.
    struct Candidate {
        ImageEdge edge;
        std::array<ImagePoint, 2> image;
        std::array<std::uint32_t, 2> numbers{no_vertex, no_vertex};  ///< of ends that other edges may share
        bool is_in_picture = false;
        bool is_whole = true;
    };
    /// What all candidates of a view have in common.
    struct Gathering;

    [[nodiscard]] Candidate candidate(const Gathering& gathering, std::size_t index) const;
    [[nodiscard]] Candidate of_silhouette(const Gathering& gathering, std::uint32_t edge) const;
    [[nodiscard]] Candidate of_feature(const Gathering& gathering, const Feature& feature) const;
    [[nodiscard]] Candidate of_irregular(const Gathering& gathering, const IrregularEdge& irregular) const;
    [[nodiscard]] Candidate of_cut(const Gathering& gathering, std::uint32_t segment) const;
    [[nodiscard]] Candidate projected(const Viewpoint& view, ImageEdge edge) const;
    [[nodiscard]] Candidate projected(const Viewpoint& view, const ImageEdge& edge, std::array<End, 2> ends) const;
    void place(const Candidate& candidate);
    [[nodiscard]] std::uint32_t placed(const ImagePoint& point, std::uint32_t number);
    void connect();

    const Surface& surface_;
    std::vector<ImageVertex> vertices_;
    std::vector<ImageEdge> edges_;
    std::vector<std::uint32_t> around_starts_, around_;
    const CutCurves* cuts_ = nullptr;             // of the view at hand
    std::vector<std::uint32_t> image_vertex_of_;  // one a number of an end
    std::vector<std::uint32_t> shared_numbers_;   // whose image_vertex_of_ is set
    std::vector<Candidate> candidates_;
    bool is_whole_ = true;
};

}  // namespace croquis::lines
