// A model's surface as the finding of lines needs it: everything that does not depend on the view, computed once.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <vector>

#include "lines/viewpoint.h"
#include "model/camera.h"
#include "model/model.h"

namespace croquis::lines {

/// The two faces of an edge.
struct FacePair {
    std::uint32_t first = 0;
    std::uint32_t second = 0;
};

/// The welded surface of a model, at rest or in a pose, with who touches whom. Immutable; shared between threads.
///
/// Edges, faces and vertices are numbered as in the model's topology. Points are in scene space (model/camera.h).
class Surface {
public:
    /// Keeps the model. Costs time and memory in proportion to its faces; the model's topology is made if no one has
    /// asked for it before.
    explicit Surface(std::shared_ptr<const model::Model> model, const model::Pose* pose = nullptr);

    [[nodiscard]] const model::Model& model() const { return *model_; }
    [[nodiscard]] const model::Topology& topology() const { return *topology_; }
    [[nodiscard]] std::size_t face_count() const { return planes_.size(); }
    [[nodiscard]] std::size_t edge_count() const { return pairs_.size(); }
    [[nodiscard]] std::size_t vertex_count() const { return positions_.size(); }

    /// A vertex in scene space, exact to the last bits of a double.
    [[nodiscard]] glm::dvec3 point(std::uint32_t vertex) const {
        return (glm::dvec3(positions_[vertex]) - centre_) * per_unit_;
    }

    /// Each face's plane in scene space: unit normal in xyz, and w so that dot(plane, (p, 1)) is p's height over it.
    /// In single precision: use `front_facing` where a sign decides. Zeros for a face that a pose folded to nothing.
    [[nodiscard]] std::span<const glm::vec4> planes() const { return planes_; }

    /// Each edge's two faces, if it is regular: exactly two faces, wound against each other. Irregular edges (borders,
    /// edges of three and more faces, neighbours that are wound two ways) have the same face twice, so that whoever
    /// compares the two finds no silhouette; `irregular_edges` lists them.
    [[nodiscard]] std::span<const FacePair> pairs() const { return pairs_; }
    [[nodiscard]] std::span<const std::uint32_t> irregular_edges() const { return irregular_edges_; }

    /// The faces at a vertex, in ascending order.
    [[nodiscard]] std::span<const std::uint32_t> faces_around(std::uint32_t vertex) const {
        return topology_->faces_around(vertex);
    }

    /// The cosine of the angle by which the surface bends between two faces: 1 where it is flat.
    [[nodiscard]] float bend_cosine(FacePair pair) const {
        return glm::dot(glm::vec3(planes_[pair.first]), glm::vec3(planes_[pair.second]));
    }

    /// True when the face's outer side is turned to the eye: n · (e − v) > 0 (seed D, section 2; seed E, 10.3.2).
    /// A face seen edge-on, within `edge_on_sine`, counts as turned away. Decided in double precision.
    [[nodiscard]] bool front_facing(std::uint32_t face, const Viewpoint& view) const {
        const double height = eye_height(planes_[face], view), doubt = eye_doubt(view);
        return height > doubt || (height > -doubt && eye_sine(face, view) > edge_on_sine);
    }

    /// True when a face is seen so nearly along its plane that rounding decides which side of it one sees.
    [[nodiscard]] bool is_edge_on(std::uint32_t face, const Viewpoint& view) const {
        return std::abs(eye_height(planes_[face], view)) <= eye_doubt(view) && std::abs(eye_sine(face, view)) < 4e-7;
    }

    /// Sine of the angle between a face and the view ray below which the face counts as seen edge-on: the noise of
    /// single precision positions.
    static constexpr double edge_on_sine = 1e-7;

    /// Edges where the surface bends by more than an angle (radians, from 0 of a flat surface to pi of a fold), where
    /// both faces exist and are wound alike. In ascending order.
    [[nodiscard]] std::vector<std::uint32_t> creases(double angle) const;
    /// Edges between two meshes or materials. In ascending order.
    [[nodiscard]] std::vector<std::uint32_t> material_boundaries() const;

private:
    /// The eye's height over a plane; in a parallel projection, that of the direction to it.
    static double eye_height(const glm::vec4& plane, const Viewpoint& view) {
        return view.projection == model::Projection::perspective
                   ? plane.x * view.eye.x + plane.y * view.eye.y + plane.z * view.eye.z + plane.w
                   : plane.x * view.back.x + plane.y * view.back.y + plane.z * view.back.z;
    }
    /// Single precision errs by some 1e-6 for an eye within a few units of the model.
    static double eye_doubt(const Viewpoint& view) {
        const bool perspective = view.projection == model::Projection::perspective;
        return 4e-6 * (1.0 + (perspective ? std::abs(view.eye.x) + std::abs(view.eye.y) + std::abs(view.eye.z) : 0.0));
    }
    /// Sine of the angle between a face and the ray to the eye, in double precision; 0 for a face without area.
    [[nodiscard]] double eye_sine(std::uint32_t face, const Viewpoint& view) const;
    void make_planes();
    void make_pairs();

    std::shared_ptr<const model::Model> model_;
    const model::Topology* topology_;
    std::vector<glm::vec3> posed_positions_;  // empty at rest
    std::span<const glm::vec3> positions_;
    glm::dvec3 centre_;
    double per_unit_ = 1;
    std::vector<glm::vec4> planes_;
    std::vector<FacePair> pairs_;
    std::vector<std::uint32_t> irregular_edges_;
};

}  // namespace croquis::lines
