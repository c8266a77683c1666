#include "model/simplification.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "base/error.h"
#include "model/load.h"
#include "model/welding.h"

namespace croquis::model {
namespace {

constexpr double tolerance = 0.03;  // of the asked count
constexpr std::uint32_t none = 0xffffffffu;

/// A vertex of one of the model's meshes, and the vertex of its topology that it is part of.
struct RenderVertex {
    std::uint32_t mesh = 0;
    std::uint32_t vertex = 0;  ///< of the mesh
    std::uint32_t welded = none;
};

/// The model's surface as meshoptimizer takes it. Render vertices that differ in their normals alone are one wedge: a
/// crease is kept by its quadrics and not as a seam, which would hold every corner of it in place.
struct Wedges {
    std::vector<glm::vec3> positions;           ///< one a wedge; equal where wedges meet at a seam
    std::vector<std::uint32_t> triangles;       ///< three wedges a face
    std::vector<RenderVertex> render_vertices;  ///< wedge after wedge
    std::vector<std::size_t> starts;            ///< where each wedge starts in render_vertices, and the end of the last

    [[nodiscard]] std::span<const RenderVertex> of(std::uint32_t wedge) const {
        return std::span(render_vertices).subspan(starts[wedge], starts[wedge + 1] - starts[wedge]);
    }
};

/// All render vertices, mesh after mesh. The corners of the topology's faces are listed as indices into them.
std::vector<RenderVertex> list_render_vertices(const Model& model, std::vector<std::uint32_t>& corners) {
    const Topology& topology = model.topology();
    std::vector<RenderVertex> listed;
    for (std::uint32_t m = 0; m < model.meshes.size(); ++m) {
        const Mesh& mesh = model.meshes[m];
        const auto first = static_cast<std::uint32_t>(listed.size());
        for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) listed.push_back({m, v, none});
        for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
            const std::uint32_t* const corner = &mesh.triangles[3 * t];
            const auto& p = mesh.positions;
            if (!has_area(p[corner[0]], p[corner[1]], p[corner[2]])) continue;  // no face of the topology
            for (std::size_t k = 0; k < 3; ++k) {
                listed[first + corner[k]].welded = topology.faces[corners.size() / 3].vertices[k];
                corners.push_back(first + corner[k]);
            }
        }
    }
    return listed;
}

/// What tells wedges apart.
auto look_of(const Model& model, const RenderVertex& v) {
    const Mesh& mesh = model.meshes[v.mesh];
    const glm::vec2 texcoord = mesh.texcoords.empty() ? glm::vec2(0.0f) : mesh.texcoords[v.vertex];
    const glm::u8vec4 color = mesh.colors.empty() ? glm::u8vec4(0) : mesh.colors[v.vertex];
    return std::make_tuple(v.welded, v.mesh, texcoord.x, texcoord.y, color.r, color.g, color.b, color.a);
}

Wedges wedges_of(const Model& model) {
    std::vector<std::uint32_t> corners;
    const std::vector<RenderVertex> listed = list_render_vertices(model, corners);
    std::vector<std::uint32_t> order(listed.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return look_of(model, listed[a]) < look_of(model, listed[b]);
    });
    Wedges wedges;
    std::vector<std::uint32_t> wedge_of(listed.size(), none);
    for (const std::uint32_t i : order) {
        const RenderVertex& v = listed[i];
        if (v.welded == none) break;  // these stand last
        if (wedges.positions.empty() || look_of(model, v) != look_of(model, wedges.render_vertices.back())) {
            wedges.starts.push_back(wedges.render_vertices.size());
            wedges.positions.push_back(model.topology().positions[v.welded]);
        }
        wedge_of[i] = static_cast<std::uint32_t>(wedges.positions.size() - 1);
        wedges.render_vertices.push_back(v);
    }
    wedges.starts.push_back(wedges.render_vertices.size());
    for (const std::uint32_t corner : corners) wedges.triangles.push_back(wedge_of[corner]);
    return wedges;
}

/// Three wedges a face, of about so many faces. However far the surface moves for it: who asks for few faces gets them.
std::vector<std::uint32_t> collapse(const Wedges& wedges, std::size_t triangles) {
    if (wedges.triangles.empty()) return {};  // all faces are folded to nothing at rest
    std::vector<std::uint32_t> left(wedges.triangles.size());
    const std::size_t count = meshopt_simplify(left.data(), wedges.triangles.data(), wedges.triangles.size(),
                                               &wedges.positions.front().x, wedges.positions.size(), sizeof(glm::vec3),
                                               3 * triangles, std::numeric_limits<float>::max(), 0, nullptr);
    left.resize(count);
    return left;
}

/// Of a wedge's vertices the one whose normal is nearest to a face's.
RenderVertex nearest_in_normal(const Model& model, std::span<const RenderVertex> vertices, const glm::dvec3& normal) {
    const auto agreement = [&](const RenderVertex& v) {
        return glm::dot(glm::dvec3(model.meshes[v.mesh].normals[v.vertex]), normal);
    };
    return *std::max_element(vertices.begin(), vertices.end(),
                             [&](const RenderVertex& a, const RenderVertex& b) { return agreement(a) < agreement(b); });
}

/// The model's own vertices without a face; those that get none go when the model is finished.
RawModel without_faces(const Model& model) {
    RawModel raw;
    for (const Mesh& mesh : model.meshes) {
        raw.meshes.push_back({{.name = mesh.name,
                               .material = mesh.material,
                               .region = mesh.region,
                               .positions = mesh.positions,
                               .normals = mesh.normals,
                               .texcoords = mesh.texcoords,
                               .colors = mesh.colors,
                               .triangles = {}},
                              {}});
    }
    raw.materials = model.materials;
    raw.clips = model.clips;
    raw.rig = model.rig;
    raw.tagged_edges = model.tagged_edges;
    raw.origin = model.origin;
    return raw;
}

/// The model's own vertices under other faces.
RawModel with_faces(const Model& model, const Wedges& wedges, std::span<const std::uint32_t> faces) {
    RawModel raw = without_faces(model);
    for (std::size_t i = 0; i < faces.size(); i += 3) {
        const auto& p = wedges.positions;
        const glm::dvec3 normal = area_vector(p[faces[i]], p[faces[i + 1]], p[faces[i + 2]]);
        for (std::size_t k = i; k < i + 3; ++k) {
            const RenderVertex v = nearest_in_normal(model, wedges.of(faces[k]), normal);
            raw.meshes[v.mesh].mesh.triangles.push_back(v.vertex);
        }
    }
    return raw;
}

/// A mesh's triangles after its vertices were clustered; all of them where it has few.
std::vector<std::uint32_t> cluster(const Mesh& mesh, double share) {
    constexpr std::size_t few = 64;
    if (mesh.triangle_count() <= few) return mesh.triangles;
    const auto wanted = std::max(few, static_cast<std::size_t>(share * double(mesh.triangle_count())));
    std::vector<std::uint32_t> left(mesh.triangles.size());
    const std::size_t count = meshopt_simplifySloppy(
        left.data(), mesh.triangles.data(), mesh.triangles.size(), &mesh.positions.front().x, mesh.positions.size(),
        sizeof(glm::vec3), 3 * wanted, std::numeric_limits<float>::max(), nullptr);
    left.resize(count);
    return left;
}

}  // namespace

std::shared_ptr<const Model> simplified(const std::shared_ptr<const Model>& model, std::size_t triangles) {
    if (triangles == 0) fail("expected at least 1 triangle to simplify to, found 0");
    if (triangles >= model->triangle_count()) return model;
    const Wedges wedges = wedges_of(*model);
    const std::vector<std::uint32_t> faces = collapse(wedges, std::min(triangles, wedges.triangles.size() / 3));
    const std::size_t left = faces.size() / 3;
    if (left == 0)
        fail("{}: expected more triangles to simplify to, found {}: nothing would be left", model->name, triangles);
    if (double(left) > (1.0 + tolerance) * double(triangles) + 1.0) {
        fail(
            "{}: expected a model that can be simplified to {} triangles, found that its shape, borders and seams need "
            "{}",
            model->name, triangles, left);
    }
    return finish(with_faces(*model, wedges, faces), model->name);
}

std::shared_ptr<const Model> clustered(const std::shared_ptr<const Model>& model, std::size_t triangles) {
    if (triangles == 0) fail("expected at least 1 triangle to simplify to, found 0");
    const std::size_t all = model->triangle_count();
    if (triangles >= all) return model;
    RawModel raw = without_faces(*model);
    for (std::size_t m = 0; m < model->meshes.size(); ++m) {
        raw.meshes[m].mesh.triangles = cluster(model->meshes[m], double(triangles) / double(all));
    }
    return finish(std::move(raw), model->name);
}

}  // namespace croquis::model
