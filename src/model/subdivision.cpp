// OpenSubdiv refines the topology and weighs the points; this file makes control meshes of models and models of the
// finest level.
#include "model/subdivision.h"

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "base/error.h"
#include "base/names.h"
#include "model/control_mesh.h"
#include "model/load.h"

namespace croquis::model {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;
using Far::Index;
using RefinerPointer = std::unique_ptr<Far::TopologyRefiner>;

constexpr std::size_t most_triangles = 20'000'000;
constexpr std::uint32_t none = 0xffffffffu;

struct NamedScheme {
    const char* name;
    SubdivisionScheme scheme;
};
constexpr NamedScheme named_schemes[] = {{"loop", SubdivisionScheme::loop},
                                         {"catmull-clark", SubdivisionScheme::catmull_clark}};

void check_request(const Model& model, SubdivisionScheme scheme, int levels) {
    if (levels < 0 || levels > most_subdivision_levels) {
        fail("expected 0 to {} levels of subdivision, found {}", most_subdivision_levels, levels);
    }
    const std::size_t wanted = subdivided_triangle_count(model.triangle_count(), scheme, levels);
    if (wanted > most_triangles) {
        fail("{}: {} levels of subdivision make {} triangles; at most {} are made", model.name, levels, wanted,
             most_triangles);
    }
}

void check_valences(const Model& model) {
    const Topology& topology = model.topology();
    for (std::uint32_t v = 0; v < topology.positions.size(); ++v) {
        const std::size_t count = topology.faces_around(v).size();
        if (count > Far::VALENCE_LIMIT / 2) {
            fail("{}: expected at most {} faces at a vertex to subdivide, found {}", model.name, Far::VALENCE_LIMIT / 2,
                 count);
        }
    }
}

RefinerPointer refine(const ControlMesh& control, SubdivisionScheme scheme, int levels, const std::string& name) {
    const std::vector<int> sizes(control.corners.size() / 3, 3);
    const std::vector<float> sharpness(control.sharp.size() / 2, Sdc::Crease::SHARPNESS_INFINITE);
    Far::TopologyDescriptor::FVarChannel looks;
    looks.numValues = static_cast<int>(control.looks.size());
    looks.valueIndices = control.look_of_corner.data();
    Far::TopologyDescriptor descriptor;
    descriptor.numVertices = static_cast<int>(control.points.size());
    descriptor.numFaces = static_cast<int>(sizes.size());
    descriptor.numVertsPerFace = sizes.data();
    descriptor.vertIndicesPerFace = control.corners.data();
    descriptor.numCreases = static_cast<int>(sharpness.size());
    descriptor.creaseVertexIndexPairs = control.sharp.data();
    descriptor.creaseWeights = sharpness.data();
    descriptor.numFVarChannels = control.looks.empty() ? 0 : 1;
    descriptor.fvarChannels = &looks;
    Sdc::Options options;
    options.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
    options.SetFVarLinearInterpolation(Sdc::Options::FVAR_LINEAR_ALL);
    const Sdc::SchemeType type = scheme == SubdivisionScheme::loop ? Sdc::SCHEME_LOOP : Sdc::SCHEME_CATMARK;
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    RefinerPointer refiner(Factory::Create(descriptor, Factory::Options(type, options)));
    if (!refiner) fail("{}: expected a surface to subdivide, found one that OpenSubdiv does not take", name);
    Far::TopologyRefiner::UniformOptions uniform(levels);
    uniform.fullTopologyInLastLevel = true;  // limit points need the neighbours of each vertex
    refiner->RefineUniform(uniform);
    return refiner;
}

/// The finest level's points on the limit surface, and its normals there: zero where sheets meet at an angle.
struct LimitSurface {
    std::vector<glm::vec3> points, normals;
};

LimitSurface limit_surface(const Far::TopologyRefiner& refiner, std::vector<MixedPoint> points) {
    const Far::PrimvarRefinerReal<double> primvars(refiner);
    for (int level = 1; level <= refiner.GetMaxLevel(); ++level) {
        std::vector<MixedPoint> finer(static_cast<std::size_t>(refiner.GetLevel(level).GetNumVertices()));
        primvars.Interpolate(level, points, finer);
        points = std::move(finer);
    }
    std::vector<MixedPoint> limits(points.size()), along(points.size()), across(points.size());
    primvars.Limit(points, limits, along, across);
    LimitSurface surface;
    surface.points.resize(points.size());
    surface.normals.resize(points.size());
    for (std::size_t v = 0; v < points.size(); ++v) {
        surface.points[v] = glm::vec3(limits[v].value);
        const glm::dvec3 normal = glm::cross(along[v].value, across[v].value);
        const double length = glm::length(normal);
        if (length > 0) surface.normals[v] = glm::vec3(normal / length);
    }
    const Far::TopologyLevel& finest = refiner.GetLevel(refiner.GetMaxLevel());
    for (Index e = 0; e < finest.GetNumEdges(); ++e) {
        if (!finest.IsEdgeInfSharp(e) || (finest.IsEdgeBoundary(e) && !finest.IsEdgeNonManifold(e))) continue;
        for (const Index v : finest.GetEdgeVertices(e)) surface.normals[std::size_t(v)] = glm::vec3(0.0f);
    }
    for (Index v = 0; v < finest.GetNumVertices(); ++v) {
        if (finest.IsVertexNonManifold(v)) surface.normals[std::size_t(v)] = glm::vec3(0.0f);
    }
    return surface;
}

/// The mesh of each of the finest level's faces.
std::vector<std::uint32_t> carry_meshes(const Far::TopologyRefiner& refiner, std::vector<std::uint32_t> mesh_of) {
    for (int level = 1; level <= refiner.GetMaxLevel(); ++level) {
        const Far::TopologyLevel& finer = refiner.GetLevel(level);
        std::vector<std::uint32_t> next(static_cast<std::size_t>(finer.GetNumFaces()));
        for (Index f = 0; f < finer.GetNumFaces(); ++f)
            next[std::size_t(f)] = mesh_of[std::size_t(finer.GetFaceParentFace(f))];
        mesh_of = std::move(next);
    }
    return mesh_of;
}

/// The finest level's edges that tagged edges were cut into.
std::vector<TaggedEdge> carry_tagged(const Far::TopologyRefiner& refiner, const ControlMesh& control,
                                     const std::vector<glm::vec3>& points) {
    std::vector<Index> edges;
    for (std::size_t i = 0; i + 1 < control.tagged.size(); i += 2) {
        edges.push_back(refiner.GetLevel(0).FindEdge(control.tagged[i], control.tagged[i + 1]));
    }
    for (int level = 0; level < refiner.GetMaxLevel(); ++level) {
        std::vector<Index> children;
        for (const Index e : edges) {
            for (const Index child : refiner.GetLevel(level).GetEdgeChildEdges(e)) children.push_back(child);
        }
        edges = std::move(children);
    }
    std::vector<TaggedEdge> tagged;
    for (const Index e : edges) {
        const auto ends = refiner.GetLevel(refiner.GetMaxLevel()).GetEdgeVertices(e);
        tagged.push_back({points[std::size_t(ends[0])], points[std::size_t(ends[1])]});
    }
    return tagged;
}

std::vector<MixedLook> finest_looks(const Far::TopologyRefiner& refiner, std::vector<MixedLook> looks) {
    if (looks.empty()) return looks;
    const Far::PrimvarRefinerReal<double> primvars(refiner);
    for (int level = 1; level <= refiner.GetMaxLevel(); ++level) {
        std::vector<MixedLook> finer(static_cast<std::size_t>(refiner.GetLevel(level).GetNumFVarValues()));
        primvars.InterpolateFaceVarying(level, looks, finer);
        looks = std::move(finer);
    }
    return looks;
}

/// Makes meshes of the finest level's faces.
class MeshBuilder {
public:
    MeshBuilder(const Far::TopologyRefiner& refiner, const LimitSurface& surface, const std::vector<MixedLook>& looks)
        : finest_(refiner.GetLevel(refiner.GetMaxLevel())), surface_(surface), looks_(looks) {
        number_of_.assign(looks.empty() ? surface.points.size() : looks.size(), none);
    }

    /// A mesh as `original` was, of some faces.
    [[nodiscard]] RawMesh build(const Mesh& original, std::span<const Index> faces) {
        RawMesh raw;
        raw.mesh.name = original.name;
        raw.mesh.material = original.material;
        has_texcoords_ = !original.texcoords.empty();
        has_colors_ = !original.colors.empty();
        const int corners = finest_.GetFaceVertices(0).size();
        raw.mesh.triangles.reserve(faces.size() * static_cast<std::size_t>(corners == 4 ? 6 : 3));
        used_.clear();
        for (const Index f : faces) add_face(raw.mesh, f);
        for (const std::size_t id : used_) number_of_[id] = none;
        return raw;
    }

private:
    void add_face(Mesh& mesh, Index face) {
        const auto corners = finest_.GetFaceVertices(face);
        std::array<std::uint32_t, 4> v{};
        for (int k = 0; k < corners.size(); ++k) {
            const Index look = looks_.empty() ? corners[k] : finest_.GetFaceFVarValues(face)[k];
            v[std::size_t(k)] = vertex(mesh, std::size_t(corners[k]), std::size_t(look));
        }
        if (corners.size() == 3) {
            mesh.triangles.insert(mesh.triangles.end(), {v[0], v[1], v[2]});
            return;
        }
        const auto diagonal = [&](std::size_t a, std::size_t b) {
            return glm::distance(mesh.positions[v[a]], mesh.positions[v[b]]);
        };
        if (diagonal(0, 2) <= diagonal(1, 3)) {
            mesh.triangles.insert(mesh.triangles.end(), {v[0], v[1], v[2], v[0], v[2], v[3]});
        } else {
            mesh.triangles.insert(mesh.triangles.end(), {v[0], v[1], v[3], v[1], v[2], v[3]});
        }
    }

    /// The mesh's vertex at a point; `id` tells vertices of different looks apart.
    std::uint32_t vertex(Mesh& mesh, std::size_t point, std::size_t id) {
        std::uint32_t& number = number_of_[id];
        if (number != none) return number;
        number = static_cast<std::uint32_t>(mesh.positions.size());
        used_.push_back(id);
        mesh.positions.push_back(surface_.points[point]);
        mesh.normals.push_back(surface_.normals[point]);
        if (has_texcoords_) mesh.texcoords.emplace_back(looks_[id].texcoord);
        if (has_colors_) {
            mesh.colors.emplace_back(glm::clamp(looks_[id].color + 0.5, 0.0, 255.0));
        }
        return number;
    }

    const Far::TopologyLevel& finest_;
    const LimitSurface& surface_;
    const std::vector<MixedLook>& looks_;
    std::vector<std::uint32_t> number_of_;  // one a point, or one a look where there are any
    std::vector<std::size_t> used_;
    bool has_texcoords_ = false, has_colors_ = false;
};

std::vector<RawMesh> build_meshes(const Model& model, const Far::TopologyRefiner& refiner, const LimitSurface& surface,
                                  ControlMesh& control) {
    std::vector<std::vector<Index>> faces_of(model.meshes.size());
    const std::vector<std::uint32_t> mesh_of = carry_meshes(refiner, std::move(control.mesh_of));
    for (std::size_t f = 0; f < mesh_of.size(); ++f) faces_of[mesh_of[f]].push_back(static_cast<Index>(f));
    const std::vector<MixedLook> looks = finest_looks(refiner, std::move(control.looks));
    MeshBuilder builder(refiner, surface, looks);
    std::vector<RawMesh> meshes;
    for (std::size_t m = 0; m < model.meshes.size(); ++m) meshes.push_back(builder.build(model.meshes[m], faces_of[m]));
    return meshes;
}

std::shared_ptr<const Model> copy_of(const Model& model) {
    RawModel raw;
    for (const Mesh& mesh : model.meshes) raw.meshes.push_back({mesh, {}});
    raw.materials = model.materials;
    raw.clips = model.clips;
    raw.rig = model.rig;
    raw.tagged_edges = model.tagged_edges;
    raw.origin = model.origin;
    return finish(std::move(raw), model.name);
}

}  // namespace

std::vector<std::string> subdivision_scheme_names() {
    std::vector<std::string> names;
    for (const NamedScheme& named : named_schemes) names.emplace_back(named.name);
    return names;
}

SubdivisionScheme subdivision_scheme(std::string_view name) {
    for (const NamedScheme& named : named_schemes) {
        if (name == named.name) return named.scheme;
    }
    fail("unknown subdivision scheme \"{}\"{}", name, suggestion(name, subdivision_scheme_names()));
}

std::size_t subdivided_triangle_count(std::size_t triangles, SubdivisionScheme scheme, int levels) {
    if (levels == 0) return triangles;
    const std::size_t first = scheme == SubdivisionScheme::loop ? 4 : 6;
    return triangles * first << 2 * (levels - 1);
}

std::shared_ptr<const Model> subdivide(const Model& model, SubdivisionScheme scheme, int levels,
                                       std::optional<double> crease_angle) {
    check_request(model, scheme, levels);
    if (levels == 0) return copy_of(model);
    check_valences(model);
    ControlMesh control = control_mesh(model, crease_angle);
    const RefinerPointer refiner = refine(control, scheme, levels, model.name);
    const LimitSurface surface = limit_surface(*refiner, std::move(control.points));
    RawModel raw;
    raw.meshes = build_meshes(model, *refiner, surface, control);
    raw.materials = model.materials;
    raw.tagged_edges = carry_tagged(*refiner, control, surface.points);
    raw.origin = model.origin;
    LoadOptions options;
    if (crease_angle) options.crease_angle = std::min(options.crease_angle, static_cast<float>(*crease_angle));
    return finish(std::move(raw), model.name, options);
}

}  // namespace croquis::model
