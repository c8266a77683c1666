// From what a reader found to a model that everything else may trust.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/error.h"
#include "base/log.h"
#include "model/load.h"
#include "model/normals.h"
#include "model/readers.h"
#include "model/textures.h"
#include "model/vertices.h"
#include "model/welding.h"
#include "model/winding.h"

namespace croquis::model {
namespace {

bool is_finite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// How many triangles were dropped, and why.
struct Dropped {
    std::size_t out_of_range = 0;
    std::size_t not_finite = 0;
    std::size_t flat = 0;
};

/// Keeps the triangles for which `keep(a, b, c)` holds, and their smoothing groups.
template <typename Keep>
void keep_triangles(RawMesh& raw, const Keep& keep) {
    auto& triangles = raw.mesh.triangles;
    if (raw.smoothing_groups.size() != triangles.size() / 3) raw.smoothing_groups.clear();
    std::size_t kept = 0;
    for (std::size_t t = 0; t < triangles.size() / 3; ++t) {
        const std::uint32_t a = triangles[3 * t], b = triangles[3 * t + 1], c = triangles[3 * t + 2];
        if (!keep(a, b, c)) continue;
        triangles[3 * kept] = a;
        triangles[3 * kept + 1] = b;
        triangles[3 * kept + 2] = c;
        if (!raw.smoothing_groups.empty()) raw.smoothing_groups[kept] = raw.smoothing_groups[t];
        ++kept;
    }
    triangles.resize(3 * kept);
    if (!raw.smoothing_groups.empty()) raw.smoothing_groups.resize(kept);
}

/// Squares stay finite in 32 bits below this: what is larger could not be drawn.
constexpr float largest_coordinate = 1e18f;

void drop_impossible(RawMesh& raw, Dropped& dropped) {
    const auto& positions = raw.mesh.positions;
    const auto is_usable = [&](std::uint32_t v) {
        const glm::vec3 p = glm::abs(positions[v]);
        return is_finite(p) && std::max({p.x, p.y, p.z}) < largest_coordinate;
    };
    keep_triangles(raw, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        if (std::max({a, b, c}) >= positions.size()) return ++dropped.out_of_range, false;
        if (!is_usable(a) || !is_usable(b) || !is_usable(c)) return ++dropped.not_finite, false;
        return true;
    });
}

/// A face of no area at rest may open up as a shape: only faces that name a vertex twice can be dropped there.
void drop_degenerate(RawMesh& raw, const MeshRig* rig, Dropped& dropped) {
    const auto& p = raw.mesh.positions;
    const bool changes_shape = rig != nullptr && !rig->shapes.empty();
    const std::size_t before = raw.mesh.triangle_count();
    keep_triangles(raw, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        if (changes_shape) return a != b && b != c && c != a;
        return glm::length(area_vector(p[a], p[b], p[c])) > 0;
    });
    dropped.flat += before - raw.mesh.triangle_count();
}

/// Lists that do not fit the vertices are dropped; missing normals become zero vectors.
void fit_lists(Mesh& mesh) {
    const std::size_t count = mesh.positions.size();
    if (mesh.texcoords.size() != count) mesh.texcoords.clear();
    if (mesh.colors.size() != count) mesh.colors.clear();
    for (glm::vec2& t : mesh.texcoords) {
        if (!std::isfinite(t.x) || !std::isfinite(t.y)) t = glm::vec2(0.0f);
    }
}

/// Unit normals, or zero vectors where there are none.
void fit_normals(std::vector<glm::vec3>& normals, std::size_t count) {
    if (normals.size() != count) normals.assign(count, glm::vec3(0.0f));
    for (glm::vec3& normal : normals) {
        const double length = glm::length(glm::dvec3(normal));
        normal = std::isfinite(length) && length > 0 ? glm::vec3(glm::dvec3(normal) / length) : glm::vec3(0.0f);
    }
}

/// Drops meshes without triangles, and what the rig and the clips say of them.
void drop_empty_meshes(RawModel& raw) {
    std::vector<std::uint32_t> number_of(raw.meshes.size());
    std::size_t kept = 0;
    constexpr std::uint32_t gone = 0xffffffffu;
    for (std::size_t m = 0; m < raw.meshes.size(); ++m) {
        number_of[m] = gone;
        if (raw.meshes[m].mesh.triangles.empty()) continue;
        number_of[m] = static_cast<std::uint32_t>(kept);
        if (kept != m) {
            raw.meshes[kept] = std::move(raw.meshes[m]);
            if (!raw.rig.meshes.empty()) raw.rig.meshes[kept] = std::move(raw.rig.meshes[m]);
        }
        ++kept;
    }
    raw.meshes.resize(kept);
    if (!raw.rig.meshes.empty()) raw.rig.meshes.resize(kept);
    for (AnimationClip& clip : raw.clips) {
        std::erase_if(clip.shapes, [&](const ShapeTrack& track) {
            return track.mesh >= number_of.size() || number_of[track.mesh] == gone;
        });
        for (ShapeTrack& track : clip.shapes) track.mesh = number_of[track.mesh];
    }
}

/// A rig serves only with clips to move it and one entry a mesh.
void fit_rig(RawModel& raw) {
    if (raw.clips.empty() || raw.rig.meshes.size() != raw.meshes.size()) {
        raw.rig = {};
        raw.clips.clear();
    }
    for (std::size_t m = 0; m < raw.rig.meshes.size(); ++m) {
        MeshRig& rig = raw.rig.meshes[m];
        const std::size_t count = raw.meshes[m].mesh.positions.size();
        if (rig.positions.size() != count) rig.positions = raw.meshes[m].mesh.positions;
        std::erase_if(rig.shapes, [&](const Shape& shape) { return shape.positions.size() != count; });
        fit_normals(rig.normals, count);
        for (Shape& shape : rig.shapes) fit_normals(shape.normals, count);
        if (rig.bones.size() != count || rig.weights.size() != count) {
            rig.bones.clear();
            rig.weights.clear();
        }
    }
}

Bounds bounds_of(const RawModel& raw) {
    Bounds bounds;
    for (const RawMesh& one : raw.meshes) {
        for (const std::uint32_t corner : one.mesh.triangles) bounds.add(one.mesh.positions[corner]);
    }
    return bounds;
}

void move_near_origin(RawModel& raw) {
    const Bounds bounds = bounds_of(raw);
    if (bounds.empty()) return;
    const glm::dvec3 origin = suitable_origin(bounds.low, bounds.high);
    if (origin == glm::dvec3(0.0)) return;
    raw.origin += origin;
    for (TaggedEdge& edge : raw.tagged_edges) {
        for (glm::vec3& p : edge) p = glm::vec3(glm::dvec3(p) - origin);
    }
    for (RawMesh& one : raw.meshes) {
        for (glm::vec3& p : one.mesh.positions) p = glm::vec3(glm::dvec3(p) - origin);
    }
}

std::string triangles(std::size_t count) { return count == 1 ? "1 triangle" : fmt::format("{} triangles", count); }

void warn_of_dropped(const Dropped& dropped, const std::string& name) {
    if (dropped.out_of_range > 0) {
        warn("{}: left out {} with vertices that the file does not have", name, triangles(dropped.out_of_range));
    }
    if (dropped.not_finite > 0) {
        warn("{}: left out {} with points that are no finite numbers below 1e18", name, triangles(dropped.not_finite));
    }
}

[[noreturn]] void fail_all_dropped(const Dropped& dropped, const std::string& name) {
    std::vector<std::string> found;
    const auto add = [&](std::size_t count, std::string_view fault) {
        if (count > 0) found.push_back(fmt::format("{} {}", count, fault));
    };
    add(dropped.out_of_range, "with vertices that the file does not have");
    add(dropped.not_finite, "with points that are no finite numbers below 1e18");
    add(dropped.flat, "of no area");
    if (found.empty()) fail_without_triangles(name, false);
    fail("{}: expected triangles, found {}", name, fmt::join(found, " and "));
}

void number_regions(std::vector<RawMesh>& meshes) {
    std::map<std::pair<std::string, std::uint32_t>, std::uint32_t> regions;
    for (RawMesh& raw : meshes) {
        const auto next = static_cast<std::uint32_t>(regions.size() + 1);
        raw.mesh.region = regions.try_emplace({raw.mesh.name, raw.mesh.material}, next).first->second;
    }
}

void fit_materials(RawModel& raw, const LoadOptions& options) {
    const auto count = static_cast<std::uint32_t>(raw.materials.size());
    bool any_plain = false;
    for (RawMesh& one : raw.meshes) {
        if (one.mesh.material < count) continue;
        one.mesh.material = count;
        any_plain = true;
    }
    if (any_plain) raw.materials.push_back(plain_material());
    if (options.texture.empty()) return;
    const auto texture = std::make_shared<const image::Image>(read_texture(options.texture));
    for (Material& material : raw.materials) {
        material.texture = texture;
        material.texture_name = options.texture.string();
        material.diffuse = glm::vec3(1.0f);
    }
}

}  // namespace

std::shared_ptr<const Model> finish(RawModel raw, const std::string& name, const LoadOptions& options) {
    const Progress& progress = options.progress;
    const Progress dropping = progress.part(0, 0.25);
    Dropped dropped;
    for (RawMesh& one : raw.meshes) drop_impossible(one, dropped);
    dropping.reach(0);
    if (raw.origin == glm::dvec3(0.0)) move_near_origin(raw);
    fit_rig(raw);
    for (std::size_t m = 0; m < raw.meshes.size(); ++m) {
        dropping.reach(double(m) / double(raw.meshes.size()));
        RawMesh& one = raw.meshes[m];
        MeshRig* const rig = raw.rig.meshes.empty() ? nullptr : &raw.rig.meshes[m];
        drop_degenerate(one, rig, dropped);
        fit_lists(one.mesh);
        drop_unused_vertices(one.mesh, rig);
        fit_normals(one.mesh.normals, one.mesh.positions.size());
        turn_to_normals(one.mesh);
    }
    drop_empty_meshes(raw);
    if (raw.meshes.empty()) fail_all_dropped(dropped, name);
    warn_of_dropped(dropped, name);
    complete_normals(raw.meshes, raw.rig, options.crease_angle, progress.part(0.25, 0.95));
    progress.reach(0.95);
    fit_materials(raw, options);
    number_regions(raw.meshes);
    auto model = std::make_shared<Model>();
    model->name = name;
    model->bounds = bounds_of(raw);
    model->origin = raw.origin;
    model->tagged_edges = std::move(raw.tagged_edges);
    model->materials = std::move(raw.materials);
    model->clips = std::move(raw.clips);
    model->rig = std::move(raw.rig);
    for (RawMesh& one : raw.meshes) model->meshes.push_back(std::move(one.mesh));
    return model;
}

}  // namespace croquis::model
