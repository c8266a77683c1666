// Which faces look at the eye, found without the GPU: the methods that seed A (3.5.2) compares. All but the first are
// wrong about some faces; a front face that is missed is a hole, one too many only costs time.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/animation.h"
#include "model/model.h"

namespace croquis::model {

enum class OrientationMethod {
    triangles_exact,      ///< a vector from the eye to each face's centre (table 9, first column)
    triangles_constant,   ///< one view vector for all faces
    triangles_corrected,  ///< the same, and faces within the perspective correction angle beyond it
    vertices_all,         ///< corrected, by vertex normals: all three of a face's vertices look at the eye
    vertices_two,         ///< at least two
    vertices_one,         ///< at least one
    marked_all,           ///< each vertex that looks at the eye marks all faces around it
    marked_some,          ///< it marks a random half of them (table 6: bad)
};

struct OrientationName {
    std::string_view name;
    OrientationMethod method;
};

/// All methods by the names that users give them, in the order above.
[[nodiscard]] std::span<const OrientationName> orientation_methods();

/// Throws Error with the nearest name.
[[nodiscard]] OrientationMethod orientation_method(const std::string& name);

/// Where the eye is, in the model's coordinates: a point, or the direction to it in a parallel projection.
struct Eye {
    glm::vec3 place{0.0f, 0.0f, 1.0f};
    bool is_far = false;
};

/// A model, at rest or in a pose, made ready to be asked from many eyes.
///
/// Faces are the triangles of all meshes in their order. A face looks at the eye when its winding is counter-clockwise
/// there; in a mesh that is wound inside out, clockwise.
class FaceOrientation {
public:
    FaceOrientation(const Model& model, const Pose* pose);

    [[nodiscard]] std::size_t face_count() const { return corners_.size(); }

    /// For each face 1 where the method takes it for one that looks at the eye. `seed` is that of marked_some.
    void find(OrientationMethod method, const Eye& eye, std::uint64_t seed, std::vector<std::uint8_t>& found) const;

private:
    using Corners = std::array<std::uint32_t, 3>;

    void add_mesh(const Mesh& mesh, std::span<const glm::vec3> positions, bool is_inverted);
    void average_normals();
    void find_attached_faces();
    void by_triangles(float cut_off, const glm::vec3& view, std::vector<std::uint8_t>& found) const;
    void by_exact_vectors(const Eye& eye, std::vector<std::uint8_t>& found) const;
    void by_vertices(float cut_off, const glm::vec3& view, int fewest, std::vector<std::uint8_t>& found) const;
    void by_marks(float cut_off, const glm::vec3& view, double share, std::uint64_t seed,
                  std::vector<std::uint8_t>& found) const;

    std::vector<Corners> corners_;         // of each face: vertices welded by their position
    std::vector<glm::vec3> face_normals_;  // unit; zero for a face of no area
    std::vector<glm::vec3> positions_;     // of the vertices
    std::vector<glm::vec3> vertex_normals_;
    std::vector<std::uint32_t> attached_starts_;  // where each vertex starts in attached_, and the end of the last
    std::vector<std::uint32_t> attached_;         // faces around each vertex
    Bounds box_;
};

}  // namespace croquis::model
