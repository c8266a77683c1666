#include "lines/viewpoint.h"

#include <glm/geometric.hpp>

namespace croquis::lines {

Viewpoint Viewpoint::of(const model::Camera& camera, double width, double height) {
    Viewpoint view;
    view.projection = camera.projection;
    view.eye = camera.eye;
    view.right = camera.right;
    view.up = camera.up;
    view.back = camera.back;
    const bool perspective = camera.projection == model::Projection::perspective;
    view.scale = 0.5 * height / (perspective ? camera.tangent : camera.half_height);
    view.width = width;
    view.height = height;
    view.near_distance = 1e-4;
    return view;
}

double Viewpoint::eye_distance(const glm::dvec3& point) const { return glm::dot(eye - point, back); }

ImagePoint Viewpoint::project(const glm::dvec3& point) const {
    const glm::dvec3 offset = point - eye;
    const double distance = -glm::dot(offset, back);
    const bool perspective = projection == model::Projection::perspective;
    const double factor = perspective ? scale / distance : scale;
    return {{0.5 * width + factor * glm::dot(offset, right), 0.5 * height - factor * glm::dot(offset, up)},
            perspective ? 1.0 / distance : -distance};
}

glm::dvec3 Viewpoint::unproject(const ImagePoint& point) const {
    const double distance = distance_of(point.nearness);
    const double unit = (projection == model::Projection::perspective ? distance : 1.0) / scale;
    return eye + right * ((point.position.x - 0.5 * width) * unit) - up * ((point.position.y - 0.5 * height) * unit) -
           back * distance;
}

double Viewpoint::distance_of(double nearness) const {
    return projection == model::Projection::perspective ? 1.0 / nearness : -nearness;
}

double Viewpoint::nearness_of(double distance) const {
    return projection == model::Projection::perspective ? 1.0 / distance : -distance;
}

double Viewpoint::units_a_pixel(double nearness) const {
    return (projection == model::Projection::perspective ? 1.0 / nearness : 1.0) / scale;
}

glm::dvec3 Viewpoint::towards_eye(const glm::dvec3& point) const {
    return projection == model::Projection::perspective ? eye - point : back;
}

}  // namespace croquis::lines
