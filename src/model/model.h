// A model as it was read: immutable, shared, and the same for every technique.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "image/image.h"
#include "model/animation.h"
#include "model/topology.h"

namespace croquis::model {

/// An axis-aligned box; empty until a point was added.
struct Bounds {
    glm::vec3 low{std::numeric_limits<float>::max()};
    glm::vec3 high{std::numeric_limits<float>::lowest()};

    void add(const glm::vec3& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    [[nodiscard]] bool empty() const { return low.x > high.x; }
    [[nodiscard]] glm::vec3 centre() const { return 0.5f * (low + high); }
    /// Half the diagonal.
    [[nodiscard]] float radius() const { return 0.5f * glm::length(high - low); }
};

/// A surface's colours, in the terms of the Phong model (seed C, equation 4.1). The defaults are those of a model that
/// names no material.
struct Material {
    std::string name;
    glm::vec3 ambient{0.12f};
    glm::vec3 diffuse{0.8f};
    glm::vec3 specular{0.5f};
    float shininess = 32.0f;  ///< the exponent s of equation 4.3
    float opacity = 1.0f;
    std::shared_ptr<const image::Image> texture;  ///< multiplies the diffuse colour; null where there is none
    std::string texture_name;                     ///< where the image came from, for messages and sharing
};

/// One surface with one material. Vertices are render vertices: split where normals or texture coordinates differ.
struct Mesh {
    std::string name;
    std::uint32_t material = 0;  ///< index into Model::materials
    std::uint32_t region = 0;    ///< identity for region ids: from 1, one for each (mesh name, material)
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;        ///< one a vertex, of unit length
    std::vector<glm::vec2> texcoords;      ///< one a vertex, or none; (0, 0) is the image's lower left
    std::vector<glm::u8vec4> colors;       ///< one a vertex, or none
    std::vector<std::uint32_t> triangles;  ///< three vertices each, counter-clockwise seen from outside

    [[nodiscard]] std::size_t triangle_count() const { return triangles.size() / 3; }
};

/// A whole model: all meshes in one space. Positions are relative to `origin`, which is not zero only for a model
/// far from its file's origin, where 32-bit numbers would lose its detail.
///
/// Build one with `model::load` or `model::finish`; from then on it does not change.
struct Model {
    std::string name;
    std::vector<Mesh> meshes;  ///< never without triangles
    std::vector<Material> materials;
    std::vector<AnimationClip> clips;
    Rig rig;                               ///< what the clips move; empty without clips
    std::vector<TaggedEdge> tagged_edges;  ///< relative to origin
    glm::dvec3 origin{0.0};
    Bounds bounds;  ///< at rest, relative to origin

    [[nodiscard]] std::size_t triangle_count() const;
    [[nodiscard]] std::size_t vertex_count() const;

    /// The welded topology of the model at rest: computed at the first call, by whichever thread comes first.
    [[nodiscard]] const Topology& topology() const;

private:
    mutable std::once_flag topology_once_;
    mutable std::unique_ptr<const Topology> topology_;
};

}  // namespace croquis::model
