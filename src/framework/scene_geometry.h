// A mesh on the GPU, with what its vertices hold for different kinds of shading.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>

#include "gpu/geometry.h"
#include "model/facets.h"
#include "model/model.h"

namespace croquis::framework {

/// What the vertices of a surface hold besides position, normal, texture coordinate and colour.
enum class SurfaceKind {
    smooth,     ///< nothing
    facets,     ///< what is the same all over a triangle, for shading that has one value a triangle: facets.glsl
    anchored,   ///< where the vertex is at rest, for what stays on a surface that moves: anchored.glsl
    one_color,  ///< nothing, but the last vertex of each triangle has the triangle's one colour
};

class MeshGeometry {
public:
    /// The mesh with its vertices at these places.
    MeshGeometry(gpu::Context& context, const model::Mesh& mesh, SurfaceKind kind, std::span<const glm::vec3> positions,
                 std::span<const glm::vec3> normals);

    /// Moves the vertices. Nothing else is uploaded again.
    void move(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals);

    void draw() const { geometry_->draw(); }
    /// Draws these triangles of the mesh alone: slow, for what changes with each frame.
    void draw(std::span<const std::uint32_t> triangles);

private:
    [[nodiscard]] const std::vector<std::uint32_t>& corners() const;

    const model::Mesh* mesh_;
    SurfaceKind kind_;
    model::FacetLayout facets_;  ///< empty where no triangle needs a vertex of its own
    std::unique_ptr<gpu::Geometry> geometry_;
};

}  // namespace croquis::framework
