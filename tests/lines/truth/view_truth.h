// What one view must show of a surface: its feature edges and, at any point of them, how many layers hide it. By brute
// force: every face that the straight way from the point to the eye passes through counts, whichever way it is turned.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "lines/drafter.h"
#include "lines/viewpoint.h"
#include "truth/surface_truth.h"

namespace croquis::lines::truth {

/// How much hides a point.
struct Sight {
    std::uint32_t layers = 0;
    bool certain = true;  ///< false so near to a change that rounding may decide
};

/// The part of a feature edge that lies in the frame.
struct SeenEdge {
    std::uint32_t known = 0;  ///< index into SurfaceTruth::edges
    ImagePoint begin, end;
    /// What it may be called. An outline's class stands as silhouette or border; whether it is the contour is a
    /// question to each point.
    LineClasses classes;
    bool required = false;    ///< false where rounding, or a model without inside, leaves it open whether it is a line
    glm::dvec2 outward{0.0};  ///< of an outline: unit, in the picture, away from its faces; else 0

    [[nodiscard]] double length() const;
    [[nodiscard]] ImagePoint at(double share) const;  ///< 0 at the beginning, 1 at the end
};

class ViewTruth {
public:
    /// Pixels to a change of visibility below which a sight is not certain.
    static constexpr double doubt = 1e-4;

    ViewTruth(const SurfaceTruth& surface, const Viewpoint& view);

    [[nodiscard]] const Viewpoint& view() const { return view_; }
    [[nodiscard]] const SurfaceTruth& surface() const { return surface_; }
    [[nodiscard]] const std::vector<SeenEdge>& edges() const { return edges_; }

    /// How many layers hide a point of an edge.
    [[nodiscard]] Sight sight(const SeenEdge& edge, const ImagePoint& point) const;
    /// Whether nothing of the model lies before or behind the picture just outside of an outline's point.
    [[nodiscard]] Verdict is_contour(const SeenEdge& edge, const ImagePoint& point) const;

private:
    enum class Side : std::int8_t { right = -1, edge_on = 0, left = 1 };

    [[nodiscard]] Side side_of(const KnownEdge& edge, std::uint32_t face) const;
    void classify(std::uint32_t known);
    [[nodiscard]] bool clip(const KnownEdge& edge, SeenEdge& seen) const;
    [[nodiscard]] glm::dvec2 outward_of(const SeenEdge& seen, std::uint32_t face) const;

    struct Ray;
    [[nodiscard]] Ray ray_through(const ImagePoint& point) const;
    /// Counts the faces that a ray passes between `low` and `high`.
    [[nodiscard]] Sight cast(const Ray& ray, double low, double high, const KnownEdge& own) const;
    void meet(std::uint32_t face, const Ray& ray, double low, double high, const KnownEdge& own, Sight& sight) const;
    [[nodiscard]] double pixels_to(const Ray& ray, double low, double high, const KnownEdge& edge) const;

    const SurfaceTruth& surface_;
    Viewpoint view_;
    std::vector<bool> changes_layers_;  // an entry an edge of the topology: layers differ between its sides
    std::vector<SeenEdge> edges_;
};

}  // namespace croquis::lines::truth
