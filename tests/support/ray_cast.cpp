#include "support/ray_cast.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace croquis::test_support {

RayCaster::RayCaster(const model::Model& model, const model::Camera& camera, int width, int height)
    : camera_(camera), width_(width), height_(height) {
    const model::SceneSpace space = model::SceneSpace::of(model);
    for (std::size_t m = 0; m < model.meshes.size(); ++m) {
        const model::Mesh& mesh = model.meshes[m];
        for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
            Triangle triangle;
            triangle.mesh = std::uint32_t(m);
            for (std::size_t c = 0; c < 3; ++c) {
                const std::uint32_t vertex = mesh.triangles[t + c];
                triangle.corners[c] = space.from_file(model.origin + glm::dvec3(mesh.positions[vertex]));
                triangle.normals[c] = glm::dvec3(mesh.normals[vertex]);
            }
            triangles_.push_back(triangle);
            boxes_.push_back(box_of(triangle));
        }
    }
}

// Where a ray can meet the triangle, in pixels and a little more; everywhere when a corner lies behind the eye.
RayCaster::Box RayCaster::box_of(const Triangle& triangle) const {
    constexpr double margin = 1e-3;
    Box box{1e300, -1e300, 1e300, -1e300};
    for (const glm::dvec3& corner : triangle.corners) {
        const glm::dvec3 from_eye = corner - camera_.eye;
        const double distance = -glm::dot(from_eye, camera_.back);
        const bool is_parallel = camera_.projection == model::Projection::parallel;
        if (!is_parallel && distance < 1e-6) return {-1e300, 1e300, -1e300, 1e300};
        const double half = is_parallel ? camera_.half_height : camera_.tangent * distance;
        const double x = 0.5 * (width_ + height_ * glm::dot(from_eye, camera_.right) / half);
        const double y = 0.5 * height_ * (1.0 - glm::dot(from_eye, camera_.up) / half);
        box = {std::min(box.left, x - margin), std::max(box.right, x + margin), std::min(box.top, y - margin),
               std::max(box.bottom, y + margin)};
    }
    return box;
}

std::optional<Hit> RayCaster::at(double x, double y) const {
    const double aspect = double(width_) / double(height_);
    const double right = (2.0 * x / width_ - 1.0) * aspect, up = 1.0 - 2.0 * y / height_;
    glm::dvec3 origin = camera_.eye, direction = -camera_.back;
    if (camera_.projection == model::Projection::parallel) {
        origin += camera_.half_height * (right * camera_.right + up * camera_.up);
    } else {
        direction += camera_.tangent * (right * camera_.right + up * camera_.up);
    }
    std::optional<Hit> nearest;
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
        const Box& box = boxes_[i];
        if (x < box.left || x > box.right || y < box.top || y > box.bottom) continue;
        const Triangle& triangle = triangles_[i];
        const glm::dvec3 ab = triangle.corners[1] - triangle.corners[0], ac = triangle.corners[2] - triangle.corners[0];
        const glm::dvec3 p = glm::cross(direction, ac);
        const double determinant = glm::dot(ab, p);
        if (determinant == 0) continue;
        const glm::dvec3 from_corner = origin - triangle.corners[0];
        const double b = glm::dot(from_corner, p) / determinant;
        if (b < 0 || b > 1) continue;
        const glm::dvec3 q = glm::cross(from_corner, ab);
        const double c = glm::dot(direction, q) / determinant;
        if (c < 0 || b + c > 1) continue;
        const double distance = glm::dot(ac, q) / determinant;
        if (nearest && nearest->eye_distance <= distance) continue;
        nearest = Hit{.eye_distance = distance,
                      .mesh = triangle.mesh,
                      .triangle = std::uint32_t(i),
                      .weights = {1.0 - b - c, b, c}};
    }
    if (!nearest) return nearest;
    const Triangle& triangle = triangles_[nearest->triangle];
    nearest->position = origin + nearest->eye_distance * direction;
    nearest->to_eye = -glm::normalize(direction);
    for (int corner = 0; corner < 3; ++corner) nearest->normal += nearest->weights[corner] * triangle.normals[corner];
    nearest->normal = glm::normalize(nearest->normal);
    const glm::dvec3 facing =
        glm::cross(triangle.corners[1] - triangle.corners[0], triangle.corners[2] - triangle.corners[0]);
    if (glm::dot(facing, nearest->to_eye) < 0) nearest->normal = -nearest->normal;
    return nearest;
}

bool RayCaster::is_certain(int x, int y) const {
    const std::optional<Hit> centre = pixel(x, y);
    constexpr double rounding = 1.0 / 64.0;  // of the rasteriser, in pixels
    for (const auto& [dx, dy] :
         {std::pair(rounding, rounding), {-rounding, rounding}, {rounding, -rounding}, {-rounding, -rounding}}) {
        const std::optional<Hit> beside = at(x + 0.5 + dx, y + 0.5 + dy);
        if (beside.has_value() != centre.has_value()) return false;
        if (!beside) continue;
        if (beside->mesh != centre->mesh || glm::dot(beside->normal, centre->normal) < 0.98) return false;
        if (std::abs(beside->eye_distance - centre->eye_distance) > 0.1) return false;
    }
    return true;
}

}  // namespace croquis::test_support
