#include "model/face_orientation.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <numeric>

#include "base/error.h"
#include "base/names.h"
#include "base/random.h"
#include "model/welding.h"

namespace croquis::model {
namespace {

using Method = OrientationMethod;

constexpr std::array<OrientationName, 8> methods{{{"triangles_exact", Method::triangles_exact},
                                                  {"triangles_constant", Method::triangles_constant},
                                                  {"triangles_corrected", Method::triangles_corrected},
                                                  {"vertices_all", Method::vertices_all},
                                                  {"vertices_two", Method::vertices_two},
                                                  {"vertices_one", Method::vertices_one},
                                                  {"marked_all", Method::marked_all},
                                                  {"marked_some", Method::marked_some}}};

constexpr double marked_share = 0.5;

glm::vec3 unit_or_zero(const glm::vec3& v) {
    const float length = glm::length(v);
    return length > 0 ? v / length : glm::vec3(0.0f);
}

// The constant view vector of seed A, 3.5.2.1, from the eye to the centre of the bounding box, and the cut-off below
// which a normal's product with it counts as front: 0, or with correction sin(alpha) = a / |V|, where a is the box's
// longest side. cos(pi/2 - alpha) is that sine; its sign is that of a view vector that points away from the eye.
struct View {
    glm::vec3 direction;
    float correction = 0;

    View(const Eye& eye, const Bounds& box) {
        const glm::vec3 from_eye = eye.is_far ? -eye.place : box.centre() - eye.place;
        direction = unit_or_zero(from_eye);
        const glm::vec3 sides = box.high - box.low;
        if (!eye.is_far) {
            const float distance = std::max(glm::length(from_eye), std::numeric_limits<float>::min());
            correction = std::max({sides.x, sides.y, sides.z}) / distance;
        }
    }
};

}  // namespace

std::span<const OrientationName> orientation_methods() { return methods; }

OrientationMethod orientation_method(const std::string& name) {
    std::vector<std::string> names;
    for (const OrientationName& known : methods) {
        if (known.name == name) return known.method;
        names.emplace_back(known.name);
    }
    fail("no face orientation \"{}\"{}", name, suggestion(name, names));
}

FaceOrientation::FaceOrientation(const Model& model, const Pose* pose) {
    const Topology& topology = model.topology();
    for (std::size_t i = 0; i < model.meshes.size(); ++i) {
        const Mesh& mesh = model.meshes[i];
        add_mesh(mesh, pose != nullptr ? (*pose)[i].positions : mesh.positions, topology.mesh_is_inverted[i]);
    }
    for (const glm::vec3& position : positions_) box_.add(position);
    average_normals();
    find_attached_faces();
}

// Welded at rest: who belongs together does not change with the pose.
void FaceOrientation::add_mesh(const Mesh& mesh, std::span<const glm::vec3> positions, bool is_inverted) {
    const std::span<const glm::vec3> at_rest = mesh.positions;
    const WeldedPoints welded = weld_points({&at_rest, 1});
    const std::vector<std::uint32_t>& vertex = welded.ids;
    const auto first = std::uint32_t(positions_.size());
    positions_.resize(first + welded.positions.size());
    for (std::size_t i = 0; i < vertex.size(); ++i) positions_[first + vertex[i]] = positions[i];
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
        Corners corners{};
        for (std::size_t c = 0; c < 3; ++c) corners[c] = first + vertex[mesh.triangles[i + c]];
        if (is_inverted) std::swap(corners[1], corners[2]);
        corners_.push_back(corners);
        const glm::vec3 &a = positions_[corners[0]], &b = positions_[corners[1]], &c = positions_[corners[2]];
        face_normals_.push_back(unit_or_zero(glm::cross(b - a, c - a)));
    }
}

// Seed A, 3.5.2: a vertex's normal is the average of the normals of all triangles of which it is a part.
void FaceOrientation::average_normals() {
    vertex_normals_.assign(positions_.size(), glm::vec3(0.0f));
    for (std::size_t face = 0; face < corners_.size(); ++face) {
        for (const std::uint32_t corner : corners_[face]) vertex_normals_[corner] += face_normals_[face];
    }
    for (glm::vec3& normal : vertex_normals_) normal = unit_or_zero(normal);
}

void FaceOrientation::find_attached_faces() {
    attached_starts_.assign(positions_.size() + 1, 0);
    for (const Corners& corners : corners_) {
        for (const std::uint32_t corner : corners) ++attached_starts_[corner + 1];
    }
    std::partial_sum(attached_starts_.begin(), attached_starts_.end(), attached_starts_.begin());
    attached_.resize(3 * corners_.size());
    std::vector<std::uint32_t> next(attached_starts_.begin(), attached_starts_.end() - 1);
    for (std::uint32_t face = 0; face < corners_.size(); ++face) {
        for (const std::uint32_t corner : corners_[face]) attached_[next[corner]++] = face;
    }
}

void FaceOrientation::find(OrientationMethod method, const Eye& eye, std::uint64_t seed,
                           std::vector<std::uint8_t>& found) const {
    found.assign(corners_.size(), 0);
    const View view(eye, box_);
    switch (method) {
        case Method::triangles_exact:
            return by_exact_vectors(eye, found);
        case Method::triangles_constant:
            return by_triangles(0.0f, view.direction, found);
        case Method::triangles_corrected:
            return by_triangles(view.correction, view.direction, found);
        case Method::vertices_all:
            return by_vertices(view.correction, view.direction, 3, found);
        case Method::vertices_two:
            return by_vertices(view.correction, view.direction, 2, found);
        case Method::vertices_one:
            return by_vertices(view.correction, view.direction, 1, found);
        case Method::marked_all:
            return by_marks(view.correction, view.direction, 1.0, seed, found);
        case Method::marked_some:
            return by_marks(view.correction, view.direction, marked_share, seed, found);
    }
}

void FaceOrientation::by_exact_vectors(const Eye& eye, std::vector<std::uint8_t>& found) const {
    for (std::size_t face = 0; face < corners_.size(); ++face) {
        const Corners& c = corners_[face];
        const glm::vec3 centre = (positions_[c[0]] + positions_[c[1]] + positions_[c[2]]) / 3.0f;
        const glm::vec3 from_eye = eye.is_far ? -eye.place : centre - eye.place;
        found[face] = glm::dot(face_normals_[face], from_eye) < 0.0f;
    }
}

void FaceOrientation::by_triangles(float cut_off, const glm::vec3& view, std::vector<std::uint8_t>& found) const {
    for (std::size_t face = 0; face < corners_.size(); ++face) {
        found[face] = glm::dot(face_normals_[face], view) < cut_off;
    }
}

// Vertices are asked once each, faces then ask their vertices.
void FaceOrientation::by_vertices(float cut_off, const glm::vec3& view, int fewest,
                                  std::vector<std::uint8_t>& found) const {
    std::vector<std::uint8_t> is_front(positions_.size());
    for (std::size_t i = 0; i < is_front.size(); ++i) is_front[i] = glm::dot(vertex_normals_[i], view) < cut_off;
    for (std::size_t face = 0; face < corners_.size(); ++face) {
        const Corners& c = corners_[face];
        found[face] = is_front[c[0]] + is_front[c[1]] + is_front[c[2]] >= fewest;
    }
}

void FaceOrientation::by_marks(float cut_off, const glm::vec3& view, double share, std::uint64_t seed,
                               std::vector<std::uint8_t>& found) const {
    const Random random(seed, "faces marked by vertices");
    for (std::size_t i = 0; i < positions_.size(); ++i) {
        if (!(glm::dot(vertex_normals_[i], view) < cut_off)) continue;
        for (std::uint32_t a = attached_starts_[i]; a < attached_starts_[i + 1]; ++a) {
            if (share >= 1.0 || random.unit(a) < share) found[attached_[a]] = 1;
        }
    }
}

}  // namespace croquis::model
