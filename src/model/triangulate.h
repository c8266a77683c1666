// Cutting polygons into triangles.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace croquis::model {

/// Cuts a simple polygon, convex or not and nearly flat, into triangles wound as it is; appends three indices into
/// `polygon` each. Convex polygons become fans, others lose ear after ear.
void triangulate(std::span<const glm::dvec3> polygon, std::vector<std::uint32_t>& triangles);

}  // namespace croquis::model
