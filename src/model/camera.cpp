#include "model/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <span>

#include "base/error.h"
#include "base/names.h"

namespace croquis::model {
namespace {

struct NamedView {
    const char* name;
    glm::dvec3 direction;
};
constexpr std::array<NamedView, 7> named_views{{{"front", {0, 0, 1}},
                                                {"back", {0, 0, -1}},
                                                {"left", {-1, 0, 0}},
                                                {"right", {1, 0, 0}},
                                                {"top", {0, 1, 0}},
                                                {"bottom", {0, -1, 0}},
                                                {"iso", {1, 1, 1}}}};

bool is_usable(const glm::dvec3& direction) {
    const double length = glm::length(direction);
    return std::isfinite(length) && length > 0;
}

// Calls `use(point)` for every vertex, in scene space.
template <typename Use>
void for_each_vertex(const Model& model, const Pose* pose, const SceneSpace& space, const Use& use) {
    const glm::dvec3 offset = space.centre - model.origin;
    for (std::size_t m = 0; m < model.meshes.size(); ++m) {
        const std::span<const glm::vec3> positions = pose ? (*pose)[m].positions : model.meshes[m].positions;
        for (const glm::vec3& position : positions) use((glm::dvec3(position) - offset) / space.radius);
    }
}

// The axes of a camera that looks against `back`. An up vector along the view gives way to another.
void set_axes(Camera& camera, const glm::dvec3& back, const glm::dvec3& up) {
    camera.back = glm::normalize(back);
    glm::dvec3 right = glm::cross(up, camera.back);
    if (glm::length(right) < 1e-6 * glm::length(up)) {
        const glm::dvec3 other = std::abs(camera.back.z) < 0.9 ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0);
        right = glm::cross(camera.back.y < 0 ? -other : other, camera.back);
    }
    camera.right = glm::normalize(right);
    camera.up = glm::cross(camera.back, camera.right);
}

// A vertex at (x, y, z) from the target, along the camera's axes, lies within the share `fit` of the frame when the eye
// stands at least z + max(|x| / aspect, |y|) / (fit · tangent) away.
void stand_back(Camera& camera, const Model& model, const Pose* pose, const SceneSpace& space, const glm::dvec3& target,
                double fit, double aspect) {
    double distance = 0, half_height = 0, front = 0;
    for_each_vertex(model, pose, space, [&](const glm::dvec3& point) {
        const glm::dvec3 from_target = point - target;
        const double x = std::abs(glm::dot(from_target, camera.right)) / aspect;
        const double y = std::abs(glm::dot(from_target, camera.up));
        const double z = glm::dot(from_target, camera.back);
        distance = std::max(distance, z + std::max(x, y) / (fit * camera.tangent));
        half_height = std::max(half_height, std::max(x, y) / fit);
        front = std::max(front, z);
    });
    camera.half_height = half_height > 0 ? half_height : 1.0;
    if (camera.projection == Projection::parallel) distance = front + 1.0;
    camera.eye = target + std::max(distance, 1e-3) * camera.back;
}

// Near and far planes and the covered part of the frame, from every vertex.
void fit_planes(Camera& camera, const Model& model, const Pose* pose, const SceneSpace& space, double aspect) {
    double nearest = std::numeric_limits<double>::max(), farthest = std::numeric_limits<double>::lowest();
    glm::dvec2 low(nearest), high(farthest);
    for_each_vertex(model, pose, space, [&](const glm::dvec3& point) {
        const glm::dvec3 from_eye = point - camera.eye;
        const double depth = -glm::dot(from_eye, camera.back);
        nearest = std::min(nearest, depth);
        farthest = std::max(farthest, depth);
        const double half_height =
            camera.projection == Projection::parallel ? camera.half_height : depth * camera.tangent;
        const glm::dvec2 place(glm::dot(from_eye, camera.right) / (aspect * half_height),
                               glm::dot(from_eye, camera.up) / half_height);
        low = glm::min(low, place);
        high = glm::max(high, place);
    });
    constexpr double margin = 0.01;  // of the depth range, so that no vertex lies on a plane
    const double range = std::max(farthest - nearest, 1e-3);
    camera.far_plane = std::max(farthest + margin * range, 1e-3);
    camera.near_plane = nearest - margin * range;
    const bool is_before_eye = camera.projection == Projection::parallel || nearest > 0;
    camera.covered_low = is_before_eye ? glm::clamp(low, -1.0, 1.0) : glm::dvec2(-1.0);
    camera.covered_high = is_before_eye ? glm::clamp(high, -1.0, 1.0) : glm::dvec2(1.0);
    if (camera.projection == Projection::parallel) return;
    // An eye within the model: 24 bits of depth bear a ratio of some ten thousand between the planes.
    camera.near_plane = std::max(camera.near_plane, camera.far_plane * 1e-4);
}

void check(const ViewRequest& request) {
    if (!(request.fit > 0 && request.fit <= 1))
        fail("expected the fit to be above 0 and at most 1, found {}", request.fit);
    if (!(request.field_of_view > 0.001 && request.field_of_view < 3.1)) {
        fail("expected the field of view to be above 0.1 and below 178 degrees, found {:g}",
             request.field_of_view * 180 / 3.14159265358979);
    }
    if (!is_usable(request.up)) fail("expected the up vector to have a length, found 0,0,0");
    if (!request.eye && !is_usable(request.direction)) fail("expected the view to have a direction, found 0,0,0");
}

}  // namespace

SceneSpace SceneSpace::of(const Model& model) {
    SceneSpace space;
    const glm::dvec3 low(model.bounds.low), high(model.bounds.high);
    space.centre = model.origin + 0.5 * (low + high);
    space.radius = 0.5 * glm::length(high - low);
    if (!(space.radius > 0)) space.radius = 1.0;
    return space;
}

glm::dvec3 named_view(std::string_view name) {
    for (const NamedView& view : named_views) {
        if (name == view.name) return view.direction;
    }
    fail("unknown view \"{}\"{}", name, suggestion(name, view_names()));
}

std::vector<std::string> view_names() {
    std::vector<std::string> names;
    for (const NamedView& view : named_views) names.emplace_back(view.name);
    return names;
}

glm::mat4 Camera::eye_from_scene() const {
    glm::dmat4 matrix(1.0);
    for (int i = 0; i < 3; ++i) {
        matrix[i] = glm::dvec4(right[i], up[i], back[i], 0.0);
    }
    matrix[3] = glm::dvec4(-glm::dot(right, eye), -glm::dot(up, eye), -glm::dot(back, eye), 1.0);
    return glm::mat4(matrix);
}

glm::mat4 Camera::clip_from_eye(double aspect) const {
    const double n = near_plane, f = far_plane;
    glm::dmat4 matrix(0.0);
    if (projection == Projection::perspective) {
        // Seed C, equation 3.9.
        matrix[0][0] = 1.0 / (aspect * tangent);
        matrix[1][1] = 1.0 / tangent;
        matrix[2][2] = -(f + n) / (f - n);
        matrix[2][3] = -1.0;
        matrix[3][2] = -2.0 * n * f / (f - n);
    } else {
        matrix[0][0] = 1.0 / (aspect * half_height);
        matrix[1][1] = 1.0 / half_height;
        matrix[2][2] = -2.0 / (f - n);
        matrix[3][2] = -(f + n) / (f - n);
        matrix[3][3] = 1.0;
    }
    return glm::mat4(matrix);
}

Camera place_camera(const Model& model, const Pose* pose, const ViewRequest& request, double aspect) {
    check(request);
    const SceneSpace space = SceneSpace::of(model);
    const glm::dvec3 target = space.from_file(request.target.value_or(space.centre));
    Camera camera;
    camera.projection = request.projection;
    camera.tangent = std::tan(0.5 * request.field_of_view);
    if (request.eye) {
        camera.eye = space.from_file(*request.eye);
        if (!is_usable(camera.eye - target))
            fail("expected the eye at a distance from the target, found {:g}", glm::length(camera.eye - target));
        set_axes(camera, camera.eye - target, request.up);
        camera.half_height = camera.tangent * glm::length(camera.eye - target);
    } else {
        set_axes(camera, request.direction, request.up);
        stand_back(camera, model, pose, space, target, request.fit, aspect);
    }
    fit_planes(camera, model, pose, space, aspect);
    return camera;
}

}  // namespace croquis::model
