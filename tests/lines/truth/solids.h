// Models of many kinds for the tests of lines: smooth, bumpy, open, knotted, passing through each other.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "support/models.h"

namespace croquis::lines::truth {

/// Three a triangle, counter-clockwise from outside; equal corners weld.
using Corners = std::vector<glm::vec3>;
using Shape = std::function<glm::dvec3(const glm::dvec3&)>;

/// A grid over (u, v) in 0 to 1, closed along u or v where asked.
struct Grid {
    int u_cells = 16, v_cells = 16;
    bool u_closed = false, v_closed = false;
};
[[nodiscard]] Corners grid_of(const Grid& grid, const std::function<glm::dvec3(double u, double v)>& at);

[[nodiscard]] Corners sphere_corners(int subdivisions);
/// A sphere with waves and, a vertex at a time, noise: `roughness` shares of the radius.
[[nodiscard]] Corners bumpy_sphere(int subdivisions, double waves, double roughness, std::uint64_t seed);
[[nodiscard]] Corners torus(double radius, double thickness, int around, int across);
/// A tube along the curve that winds `p` times around a torus and `q` times through it.
[[nodiscard]] Corners torus_knot(int p, int q, double thickness, int along, int across);
[[nodiscard]] Corners wavy_sheet(int cells, double height, std::uint64_t seed);
/// A star-shaped prism: `teeth` teeth, flat above and below.
[[nodiscard]] Corners gear(int teeth, double height);
/// Triangles at random in the unit ball.
[[nodiscard]] Corners soup(std::size_t triangles, double size, std::uint64_t seed);

/// The triangles whose middle `keep` accepts.
[[nodiscard]] Corners cut(const Corners& corners, const std::function<bool(const glm::dvec3& middle)>& keep);
[[nodiscard]] Corners shaped(const Corners& corners, const Shape& shape);
[[nodiscard]] Corners moved(const Corners& corners, const glm::dvec3& offset, double scale = 1);
/// Turned by `angle` about an axis.
[[nodiscard]] Corners turned(const Corners& corners, const glm::dvec3& axis, double angle);
[[nodiscard]] Corners inside_out(const Corners& corners);
[[nodiscard]] Corners joined(const std::vector<Corners>& parts);

[[nodiscard]] glm::dmat3 rotation(const glm::dvec3& axis, double angle);

}  // namespace croquis::lines::truth
