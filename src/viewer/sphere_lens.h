// The magnifying glass of seed B (chapter 5, algorithm 7): a sphere before the picture that OpenGL's GL_SPHERE_MAP
// textures with the square of pixels around the mouse.
//
// The seed's sphere has radius 0.3 and stands 1.5 before the eye, so that the eye is e = 5 radii from its centre. Let θ
// be the angle at the centre between a point of the sphere and the eye, and α the angle at the eye between that point
// and the centre: tan α = sin θ / (e - cos θ). The point's normal is n = (sin θ, cos θ), the line of sight to it u =
// (sin α, -cos α), both with the axis last. The reflection r = u - 2 n (n·u) = (sin φ, cos φ) with φ = 2 θ + α gives m
// = 2 √(r_x² + (r_z + 1)²) = 4 cos(φ / 2) and so
//
//     s = r_x / m + 1/2 = sin(θ + α / 2) / 2 + 1/2.
//
// Seen from far away (α = 0) this is linear in the place on the disc, a flat lens. So near it is not: towards its rim
// the sphere shows more and more of the square in the same width.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace croquis::viewer {

/// What GL_SPHERE_MAP finds at a point of that normal that is seen along `sight`, both of length 1, in eye space:
/// texture coordinates from 0 to 1.
[[nodiscard]] glm::dvec2 sphere_map(const glm::dvec3& normal, const glm::dvec3& sight);

/// A point of the sphere as the eye sees it.
struct LensPoint {
    double radius;  ///< on the lens, its rim being 1
    double reach;   ///< how far from the middle of the square its texel lies, the square's half side being 1
};

/// The sphere's point at a share of the way from its middle (0) to its rim (1), in equal angles θ.
[[nodiscard]] LensPoint sphere_lens(double share);

/// How much reach grows with radius in the middle of the lens: (e - 1/2) / √(e² - 1), since there θ = (e - 1) α, and
/// the rim is where sin α = 1 / e.
[[nodiscard]] double middle_reach();

}  // namespace croquis::viewer
