#include "model/texcoord_scale.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <vector>

namespace croquis::model {
namespace {

constexpr double largest_stretch = 3.0;
constexpr double largest_bad_share = 0.1;  // of the surface

/// How a triangle's texture coordinates lie on it.
struct Fit {
    double area = 0;  ///< on the surface
    double texture_area = 0;
    double stretch = HUGE_VAL;  ///< the ratio of the two scales, the larger over the smaller
};

// The singular values of the map from the triangle's plane to texture coordinates.
Fit fit_of(const Mesh& mesh, std::size_t triangle) {
    glm::dvec3 corner[3];
    glm::dvec2 coordinate[3];
    for (std::size_t i = 0; i < 3; ++i) {
        corner[i] = mesh.positions[mesh.triangles[3 * triangle + i]];
        coordinate[i] = mesh.texcoords[mesh.triangles[3 * triangle + i]];
    }
    const glm::dvec3 a = corner[1] - corner[0], b = corner[2] - corner[0];
    const glm::dvec2 u = coordinate[1] - coordinate[0], v = coordinate[2] - coordinate[0];
    const double along = glm::length(a), twice_area = glm::length(glm::cross(a, b));
    Fit fit{0.5 * twice_area, 0.5 * std::abs(u.x * v.y - u.y * v.x)};
    if (twice_area <= 0 || !(fit.texture_area > 0)) return fit;
    const glm::dvec2 by_x = u / along;
    const glm::dvec2 by_y = (v - by_x * (glm::dot(a, b) / along)) / (twice_area / along);
    const double sum = glm::dot(by_x, by_x) + glm::dot(by_y, by_y);
    const double product = std::abs(by_x.x * by_y.y - by_x.y * by_y.x);
    const double difference = std::sqrt(std::max(sum * sum - 4 * product * product, 0.0));
    fit.stretch = (sum + difference) / (2 * product);
    return fit;
}

}  // namespace

double texcoord_scale(const Mesh& mesh) {
    if (mesh.texcoords.empty()) return 0;
    std::vector<Fit> fits;
    double area = 0, texture_area = 0;
    for (std::size_t triangle = 0; triangle < mesh.triangle_count(); ++triangle) {
        fits.push_back(fit_of(mesh, triangle));
        area += fits.back().area;
        texture_area += fits.back().texture_area;
    }
    if (!(area > 0) || !(texture_area > 0) || !std::isfinite(texture_area)) return 0;
    const double squared_scale = texture_area / area;
    double bad_area = 0;
    for (const Fit& fit : fits) {
        const double relative = fit.area > 0 ? std::sqrt(fit.texture_area / fit.area / squared_scale) : 1;
        const bool is_good =
            fit.stretch <= largest_stretch && relative <= largest_stretch && relative * largest_stretch >= 1;
        if (!is_good) bad_area += fit.area;
    }
    return bad_area < largest_bad_share * area ? std::sqrt(squared_scale) : 0;
}

}  // namespace croquis::model
