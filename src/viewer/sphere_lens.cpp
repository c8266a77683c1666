#include "viewer/sphere_lens.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace croquis::viewer {
namespace {

constexpr double eye_distance = 5;  // in radii of the sphere: 1.5 / 0.3

}  // namespace

glm::dvec2 sphere_map(const glm::dvec3& normal, const glm::dvec3& sight) {
    const glm::dvec3 r = glm::reflect(sight, normal);
    const double m = 2 * std::sqrt(r.x * r.x + r.y * r.y + (r.z + 1) * (r.z + 1));
    return glm::dvec2(r) / m + 0.5;
}

LensPoint sphere_lens(double share) {
    // The rim is where the line of sight touches the sphere: cos θ = 1 / e.
    const double angle = share * std::acos(1 / eye_distance);
    const glm::dvec3 normal(std::sin(angle), 0, std::cos(angle));
    const glm::dvec3 from_eye = normal - glm::dvec3(0, 0, eye_distance);
    const double slope = normal.x / -from_eye.z;
    const double slope_of_rim = 1 / std::sqrt(eye_distance * eye_distance - 1);
    return {slope / slope_of_rim, 2 * sphere_map(normal, glm::normalize(from_eye)).x - 1};
}

double middle_reach() { return (eye_distance - 0.5) / std::sqrt(eye_distance * eye_distance - 1); }

}  // namespace croquis::viewer
