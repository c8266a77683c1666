#include "model/obj_meshes.h"

#include <algorithm>

namespace croquis::model {

/// Eight neighbouring corners fall into neighbouring slots, also where points, texture coordinates and normals are
/// numbered alike: most look-ups then stay in the cache. The eights themselves are scattered, or they would pile up.
std::size_t ObjMesh::first_slot(const ObjCorner& corner) const {
    const std::uint32_t texcoord = corner.texcoord == obj_none ? 0 : corner.texcoord - corner.point;
    const std::uint32_t normal = corner.normal == obj_none ? 0 : corner.normal - corner.point;
    const std::uint32_t mixed = corner.point + texcoord * 0x9e3779b1u + normal * 0x85ebca6bu;
    const std::uint64_t eights = (mixed >> 3) * 0x9e3779b97f4a7c15ull;
    return ((eights >> 32 << 3) | (mixed & 7u)) & (slots_.size() - 1);
}

void ObjMesh::grow() {
    slots_.assign(std::max<std::size_t>(64, slots_.size() * 2), obj_none);
    for (std::uint32_t v = 0; v < corners_.size(); ++v) {
        std::size_t slot = first_slot(corners_[v]);
        while (slots_[slot] != obj_none) slot = (slot + 1) & (slots_.size() - 1);
        slots_[slot] = v;
    }
}

std::uint32_t ObjMesh::vertex(const ObjCorner& corner) {
    if (corners_.size() * 3 >= slots_.size() * 2) grow();
    std::size_t slot = first_slot(corner);
    while (slots_[slot] != obj_none) {
        if (corners_[slots_[slot]] == corner) return slots_[slot];
        slot = (slot + 1) & (slots_.size() - 1);
    }
    slots_[slot] = static_cast<std::uint32_t>(corners_.size());
    corners_.push_back(corner);
    return slots_[slot];
}

void ObjMesh::disown_corners_without_point(std::size_t point_count) {
    const auto is_unknown = [&](const ObjCorner& corner) { return corner.point >= point_count; };
    if (std::none_of(corners_.begin(), corners_.end(), is_unknown)) return;
    for (std::uint32_t& v : triangles_) {
        if (is_unknown(corners_[v])) v = obj_none;
    }
}

RawMesh ObjMesh::build(const ObjLists& lists, const glm::dvec3& origin) {
    slots_ = {};
    disown_corners_without_point(lists.points.size());
    RawMesh raw;
    Mesh& mesh = raw.mesh;
    mesh.name = std::move(name_);
    mesh.material = material_;
    triangles_.shrink_to_fit();
    mesh.triangles = std::move(triangles_);
    raw.smoothing_groups = std::move(smoothing_);
    const auto any = [&](std::uint32_t ObjCorner::*index, std::size_t size) {
        return std::any_of(corners_.begin(), corners_.end(), [&](const ObjCorner& c) { return c.*index < size; });
    };
    mesh.positions.reserve(corners_.size());
    for (const ObjCorner& c : corners_) {
        const bool known = c.point < lists.points.size();
        mesh.positions.push_back(known ? glm::vec3(lists.points[c.point] - origin) : glm::vec3(0.0f));
    }
    const auto fill = [&](auto& target, const auto& source, std::uint32_t ObjCorner::*index) {
        if (source.empty() || !any(index, source.size())) return;
        target.reserve(corners_.size());
        for (const ObjCorner& c : corners_) {
            target.push_back(c.*index < source.size() ? source[c.*index] : decltype(source[0] + source[0]){});
        }
    };
    fill(mesh.texcoords, lists.texcoords, &ObjCorner::texcoord);
    fill(mesh.normals, lists.normals, &ObjCorner::normal);
    fill(mesh.colors, lists.colors, &ObjCorner::point);
    corners_ = {};
    return raw;
}

}  // namespace croquis::model
