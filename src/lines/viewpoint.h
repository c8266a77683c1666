// Where the eye is, and the frame it looks through, as the lines need it: in double precision, in scene space and
// pixels.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "model/camera.h"

namespace croquis::lines {

/// A point of the picture.
struct ImagePoint {
    glm::dvec2 position{0.0};  ///< pixels, from the frame's upper left corner; y points down
    /// Larger is nearer, and linear along every straight line of the picture: the reciprocal of the eye distance in
    /// perspective, its negative in a parallel projection.
    double nearness = 0;
};

/// A camera and its frame.
struct Viewpoint {
    model::Projection projection = model::Projection::perspective;
    glm::dvec3 eye{0.0, 0.0, 3.0};  ///< scene space
    glm::dvec3 right{1.0, 0.0, 0.0};
    glm::dvec3 up{0.0, 1.0, 0.0};
    glm::dvec3 back{0.0, 0.0, 1.0};
    double scale = 1000.0;  ///< pixels a scene unit: at eye distance 1 in perspective, everywhere in a parallel one
    double width = 1024;    ///< of the frame, pixels
    double height = 768;
    double near_distance = 1e-3;  ///< scene units; nothing nearer is drawn

    bool operator==(const Viewpoint&) const = default;

    /// The view of a camera in a frame of some pixels.
    [[nodiscard]] static Viewpoint of(const model::Camera& camera, double width, double height);

    /// How far a point of scene space lies in front of the eye, along the direction of looking.
    [[nodiscard]] double eye_distance(const glm::dvec3& point) const;

    /// A point of scene space in the picture. In perspective it must lie in front of the eye.
    [[nodiscard]] ImagePoint project(const glm::dvec3& point) const;

    /// The point of scene space that a point of the picture shows.
    [[nodiscard]] glm::dvec3 unproject(const ImagePoint& point) const;

    /// The eye distance that a nearness stands for.
    [[nodiscard]] double distance_of(double nearness) const;

    /// The nearness of an eye distance.
    [[nodiscard]] double nearness_of(double distance) const;

    /// Scene units along one pixel of the picture, at a nearness.
    [[nodiscard]] double units_a_pixel(double nearness) const;

    /// From a point of scene space towards the eye; not of unit length in perspective.
    [[nodiscard]] glm::dvec3 towards_eye(const glm::dvec3& point) const;
};

}  // namespace croquis::lines
