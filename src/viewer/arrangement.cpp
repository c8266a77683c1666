#include "viewer/arrangement.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace croquis::viewer {
namespace {

constexpr double radians_per_degree = 3.14159265358979323846 / 180.0;

glm::dvec3 vector(const Vector3& v) { return {v[0], v[1], v[2]}; }
Vector3 vector(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

// The rotation that turns the axes x, y, z to the camera's right, up and back.
glm::dquat orientation_of(const glm::dvec3& back, const glm::dvec3& up) {
    const glm::dvec3 right = glm::normalize(glm::cross(up, back));
    return glm::normalize(glm::quat_cast(glm::dmat3(right, glm::cross(back, right), back)));
}

double tangent_of_half(double degrees) { return std::tan(0.5 * degrees * radians_per_degree); }

}  // namespace

void Arrangement::take(const Model& model, const View& view, FrameSize frame) {
    const View placed = view.placed(model, frame.aspect());
    const glm::dvec3 low = vector(model.low_corner()), high = vector(model.high_corner());
    centre_ = 0.5 * (low + high);
    radius_ = std::max(0.5 * glm::length(high - low), 1e-300);
    place(placed);
}

void Arrangement::place(const View& view) {
    object_turn_ = glm::dquat(1, 0, 0, 0);
    object_offset_ = glm::dvec3(0.0);
    target_ = vector(*view.target);
    const glm::dvec3 back = vector(*view.eye) - target_;
    distance_ = glm::length(back);
    orientation_ = orientation_of(back / distance_, vector(view.up));
    field_of_view_ = view.field_of_view;
    is_parallel_ = view.parallel;
}

glm::dvec3 Arrangement::to_object(const glm::dvec3& point_of_world) const {
    return centre_ + glm::conjugate(object_turn_) * (point_of_world - centre_ - object_offset_);
}

View Arrangement::view() const {
    View view;
    view.eye = vector(to_object(target_ + distance_ * (orientation_ * glm::dvec3(0, 0, 1))));
    view.target = vector(to_object(target_));
    view.up = vector(glm::conjugate(object_turn_) * (orientation_ * glm::dvec3(0, 1, 0)));
    view.field_of_view = field_of_view_;
    view.parallel = is_parallel_;
    return view;
}

Light Arrangement::light() const {
    Light light;
    light.color = light_color_;
    if (light_stays_with_ == LightStaysWith::viewer) {
        light.bound = Light::Bound::viewer;
        light.place = vector(to_light_);
        return light;
    }
    // To the drawing functions the model at rest is the world.
    light.bound = Light::Bound::world;
    const bool stays_with_world = light_stays_with_ == LightStaysWith::world;
    light.place = vector(stays_with_world ? glm::conjugate(object_turn_) * to_light_ : to_light_);
    return light;
}

double Arrangement::length_of_pixel(FrameSize frame) const {
    return 2.0 * tangent_of_half(field_of_view_) * distance_ / double(frame.height);
}

VirtualSphere Arrangement::sphere(FrameSize frame) const {
    const glm::dvec3 eye = target_ + distance_ * (orientation_ * glm::dvec3(0, 0, 1));
    const glm::dvec3 centre = glm::conjugate(orientation_) * (centre_ + object_offset_ - eye);
    // Of a parallel picture a pixel is worth the same everywhere; else it grows with depth.
    const double depth = is_parallel_ ? distance_ : std::max(-centre.z, 1e-3 * distance_);
    const double pixel = length_of_pixel(frame) * depth / distance_;
    const double shorter = std::min(frame.width, frame.height), longer = std::max(frame.width, frame.height);
    return {.centre = {0.5 * frame.width + centre.x / pixel, 0.5 * frame.height - centre.y / pixel},
            .radius = std::clamp(radius_ / pixel, 0.2 * shorter, 2.0 * longer)};
}

glm::dquat Arrangement::camera_from_light() const {
    switch (light_stays_with_) {
        case LightStaysWith::viewer:
            return {1, 0, 0, 0};
        case LightStaysWith::object:
            return glm::conjugate(orientation_) * object_turn_;
        case LightStaysWith::world:
            break;
    }
    return glm::conjugate(orientation_);
}

void Arrangement::turn(Moves moves, const glm::dquat& rotation) {
    const glm::dquat in_world = orientation_ * rotation * glm::conjugate(orientation_);
    switch (moves) {
        case Moves::object:
            object_turn_ = glm::normalize(in_world * object_turn_);
            break;
        case Moves::camera:
            orientation_ = glm::normalize(in_world * orientation_);
            break;
        case Moves::light: {
            const glm::dquat to_camera = camera_from_light();
            to_light_ = glm::conjugate(to_camera) * (rotation * (to_camera * to_light_));
            break;
        }
    }
}

void Arrangement::pan(Moves moves, const glm::dvec2& pixels, FrameSize frame) {
    const glm::dvec3 step = orientation_ * (length_of_pixel(frame) * glm::dvec3(pixels.x, -pixels.y, 0.0));
    (moves == Moves::camera ? target_ : object_offset_) += step;
}

void Arrangement::zoom(double factor, const glm::dvec2& mouse, FrameSize frame) {
    // Near the object's surface and far from it numbers stay sound.
    const double distance = std::clamp(distance_ / factor, 1e-4 * radius_, 1e4 * radius_);
    const double kept = distance / distance_;
    const glm::dvec2 from_middle(mouse.x - 0.5 * frame.width, 0.5 * frame.height - mouse.y);
    target_ += (1.0 - kept) * length_of_pixel(frame) * (orientation_ * glm::dvec3(from_middle, 0.0));
    distance_ = distance;
}

void Arrangement::bind_light(LightStaysWith what) {
    const glm::dvec3 in_camera = camera_from_light() * to_light_;
    light_stays_with_ = what;
    to_light_ = glm::conjugate(camera_from_light()) * in_camera;
}

void Arrangement::set_light(const Light& light) {
    light_stays_with_ = light.bound == Light::Bound::viewer ? LightStaysWith::viewer : LightStaysWith::object;
    const glm::dvec3 place = vector(light.place);
    const glm::dvec3 to_light = light.bound == Light::Bound::point ? place - centre_ : place;
    if (glm::length(to_light) > 0) to_light_ = to_light;  // one in the object's middle shines from nowhere
    light_color_ = light.color;
}

void Arrangement::set_field_of_view(double degrees) {
    distance_ *= tangent_of_half(field_of_view_) / tangent_of_half(degrees);
    field_of_view_ = degrees;
}

}  // namespace croquis::viewer
