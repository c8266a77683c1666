// Collecting the faces of an OBJ file into meshes of render vertices.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <string>
#include <vector>

#include "model/load.h"

namespace croquis::model {

constexpr std::uint32_t obj_none = 0xffffffffu;

/// A corner of a face: indices of a point, a texture coordinate and a normal, from 0.
struct ObjCorner {
    std::uint32_t point = obj_none;
    std::uint32_t texcoord = obj_none;
    std::uint32_t normal = obj_none;

    bool operator==(const ObjCorner&) const = default;
};

/// What the lines v, vt and vn give.
struct ObjLists {
    std::vector<glm::dvec3> points;
    std::vector<glm::u8vec4> colors;  ///< one a point, or none
    std::vector<glm::vec2> texcoords;
    std::vector<glm::vec3> normals;
};

/// One (name, material) pair while its faces come in: equal corners are one vertex at once.
class ObjMesh {
public:
    ObjMesh(std::string name, std::uint32_t material) : name_(std::move(name)), material_(material) {}

    /// The vertex of that corner, new or not.
    [[nodiscard]] std::uint32_t vertex(const ObjCorner& corner);

    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        triangles_.insert(triangles_.end(), {a, b, c});
    }

    /// Gives the triangles added since the last call a smoothing group.
    void set_smoothing(std::uint32_t group) { smoothing_.resize(triangles_.size() / 3, group); }

    /// Hands the mesh over, its positions relative to `origin`. Triangles with corners out of range name vertices out
    /// of range, and `finish` drops them.
    [[nodiscard]] RawMesh build(const ObjLists& lists, const glm::dvec3& origin);

private:
    void grow();
    void disown_corners_without_point(std::size_t point_count);
    [[nodiscard]] std::size_t first_slot(const ObjCorner& corner) const;

    std::string name_;
    std::uint32_t material_;
    std::vector<ObjCorner> corners_;    // one a vertex
    std::vector<std::uint32_t> slots_;  // hash table of vertices
    std::vector<std::uint32_t> triangles_;
    std::vector<std::uint32_t> smoothing_;
};

}  // namespace croquis::model
