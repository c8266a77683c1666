// What the vertices of a model give the outlines that are drawn between them: colours, and offsets of lines in ink.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "model/model.h"

namespace croquis::components {

/// A colour for each vertex of the model's topology: what material, texture and vertex colours make of it, darkened by
/// a share of its brightness (seed A, 3.6.3).
[[nodiscard]] std::vector<glm::u8vec4> own_line_colors(const model::Model& model, float darkening);

/// An offset for each vertex of the model's topology, each component between plus and minus `amount` scene units:
/// random vertex by vertex (seed B, algorithm 3) where `grain` is 0, else smooth over `grain` scene units, so that
/// dense meshes keep calm lines. Depends on the vertex at rest alone: it stays when the model moves.
[[nodiscard]] std::vector<glm::vec3> ink_offsets(const model::Model& model, float amount, float grain,
                                                 std::uint64_t seed);

}  // namespace croquis::components
