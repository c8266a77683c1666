#include "viewer/trackball.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace croquis::viewer {

glm::dvec3 VirtualSphere::point_under(const glm::dvec2& mouse) const {
    const glm::dvec2 place = glm::dvec2(mouse.x - centre.x, centre.y - mouse.y) / radius;
    const double distance = glm::length(place);
    if (distance >= 1.0) return {place / distance, 0.0};
    return {place, std::sqrt(1.0 - distance * distance)};
}

glm::dquat rotation_between(const glm::dvec3& from, const glm::dvec3& to) {
    const glm::dvec3 axis = glm::cross(from, to);
    const double sine = glm::length(axis), cosine = glm::dot(from, to);
    if (sine > 0) return glm::angleAxis(std::atan2(sine, cosine), axis / sine);
    // Opposite points lie on the rim: half a turn along it. Equal ones: none.
    return cosine < 0 ? glm::dquat(0, 0, 0, 1) : glm::dquat(1, 0, 0, 0);
}

}  // namespace croquis::viewer
