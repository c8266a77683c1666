// The virtual trackball: a sphere around the object, turned by dragging a point of it (seed B, chapter 5).
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace croquis::viewer {

/// The sphere as it appears in the frame: pixels from the upper left corner, y down.
struct VirtualSphere {
    glm::dvec2 centre{0.0};
    double radius = 1.0;

    /// The point of the unit sphere under the mouse: x to the right, y up, z towards the eye. Beyond the rim it is the
    /// nearest point of the rim, so that dragging there rolls the object about the line of sight and no turn is larger
    /// than its sphere.
    [[nodiscard]] glm::dvec3 point_under(const glm::dvec2& mouse) const;
};

/// The rotation that carries one point of the unit sphere to another: about their cross product, by the angle θ with
/// cos θ = x₁ · x₂ / (|x₁| |x₂|) (seed B, the equation beside figure 5.2).
[[nodiscard]] glm::dquat rotation_between(const glm::dvec3& from, const glm::dvec3& to);

}  // namespace croquis::viewer
