// Models whose pictures are known beforehand, built in memory.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

#include "model/load.h"

namespace croquis::test_support {

using ModelPointer = std::shared_ptr<const model::Model>;

/// One mesh to be: triangles by their corners, in one material.
struct Piece {
    std::string name;
    std::vector<glm::vec3> corners;  ///< three a triangle, counter-clockwise from outside
    std::uint32_t material = 0;
};

/// A material of one diffuse colour, without highlight.
[[nodiscard]] model::Material plain(const std::string& name, const glm::vec3& diffuse);

/// A material with all of the Phong model's colours apart from each other.
[[nodiscard]] model::Material glossy();

[[nodiscard]] ModelPointer model_of(const std::vector<Piece>& pieces, std::vector<model::Material> materials = {});

/// The corners of a box's 12 triangles.
[[nodiscard]] std::vector<glm::vec3> box_corners(const glm::vec3& low, const glm::vec3& high);

/// The corners of a quadrangle's two triangles.
[[nodiscard]] std::vector<glm::vec3> quad_corners(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
                                                  const glm::vec3& d);

/// From -1 to 1 on all axes.
[[nodiscard]] ModelPointer cube();

/// A sphere of radius 1 about the origin whose vertices have the sphere's own normals: 20 · 4^subdivisions triangles.
[[nodiscard]] ModelPointer icosphere(int subdivisions, model::Material material = glossy());

/// Figure 3.9 of seed C: two parallel squares of the same facing, the nearer one before the middle of the other.
[[nodiscard]] ModelPointer parallel_squares();

/// Two boards through each other, "red" and "blue", each nearer in half of the picture.
[[nodiscard]] ModelPointer crossing_boards();

/// One flat rectangle of two materials that meet at x = 0.
[[nodiscard]] ModelPointer two_material_board();

}  // namespace croquis::test_support
