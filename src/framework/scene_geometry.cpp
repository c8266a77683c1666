#include "framework/scene_geometry.h"

#include <cstddef>
#include <vector>

namespace croquis::framework {
namespace {

// Locations of the attributes, as data/shaders/scene.glsl, facets.glsl and anchored.glsl declare them.
constexpr unsigned position_location = 0, normal_location = 1, texcoord_location = 2, color_location = 3;
constexpr unsigned facet_normal_location = 4, facet_place_location = 5, facet_texcoord_location = 6,
                   facet_color_location = 7;
constexpr unsigned rest_position_location = 8, rest_normal_location = 9;

using Kind = gpu::Attribute::Kind;

struct PositionAndNormal {
    glm::vec3 position;
    glm::vec3 normal;
};

// Those of the vertices that `of` names, or of all where it names none.
std::vector<PositionAndNormal> interleave(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                                          std::span<const std::uint32_t> of) {
    std::vector<PositionAndNormal> vertices(of.empty() ? positions.size() : of.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const std::size_t vertex = of.empty() ? i : of[i];
        vertices[i] = {positions[vertex], normals[vertex]};
    }
    return vertices;
}

template <typename Value>
std::vector<Value> picked(const std::vector<Value>& values, std::span<const std::uint32_t> of) {
    if (of.empty() || values.empty()) return values;
    std::vector<Value> result;
    result.reserve(of.size());
    for (const std::uint32_t vertex : of) result.push_back(values[vertex]);
    return result;
}

// The facets in the order of the vertices that speak for them.
std::vector<model::Facet> facets_of(const model::Mesh& mesh, const model::FacetLayout& layout,
                                    std::span<const glm::vec3> positions, std::span<const glm::vec3> normals) {
    std::vector<model::Facet> facets(layout.vertices.size());
    for (std::size_t i = 0; i < facets.size(); ++i) {
        const std::uint32_t triangle = layout.spoken_for[i];
        if (triangle != model::FacetLayout::no_triangle) {
            facets[i] = model::facet_of(mesh, positions, normals, triangle);
        }
    }
    return facets;
}

// The vertices' own, and its triangle's for each that speaks for one.
std::vector<glm::u8vec4> one_color_a_triangle(const model::Mesh& mesh, const model::FacetLayout& layout) {
    std::vector<glm::u8vec4> colors = picked(mesh.colors, layout.vertices);
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const std::uint32_t triangle = layout.spoken_for[i];
        if (triangle == model::FacetLayout::no_triangle) continue;
        colors[i] = glm::u8vec4(255.0f * model::facet_color(mesh, triangle) + 0.5f);
    }
    return colors;
}

gpu::VertexBuffer position_buffer(std::span<const PositionAndNormal> vertices, unsigned position, unsigned normal) {
    return {std::as_bytes(vertices),
            sizeof(PositionAndNormal),
            {{position, 3, Kind::floats, 0}, {normal, 3, Kind::floats, sizeof(glm::vec3)}}};
}

gpu::VertexBuffer facet_buffer(std::span<const model::Facet> facets) {
    using model::Facet;
    static_assert(offsetof(Facet, size) == offsetof(Facet, barycentre) + sizeof(glm::vec3));
    return {std::as_bytes(facets),
            sizeof(Facet),
            {{facet_normal_location, 3, Kind::floats, offsetof(Facet, normal)},
             {facet_place_location, 4, Kind::floats, offsetof(Facet, barycentre)},
             {facet_texcoord_location, 2, Kind::floats, offsetof(Facet, texcoord)},
             {facet_color_location, 4, Kind::floats, offsetof(Facet, color)}}};
}

constexpr std::size_t moving_buffer = 0, moving_facet_buffer = 1;

}  // namespace

MeshGeometry::MeshGeometry(gpu::Context& context, const model::Mesh& mesh, SurfaceKind kind,
                           std::span<const glm::vec3> positions, std::span<const glm::vec3> normals)
    : mesh_(&mesh), kind_(kind) {
    const bool has_one_color = kind == SurfaceKind::one_color && !mesh.colors.empty();
    if (kind == SurfaceKind::facets || has_one_color) facets_ = model::facet_layout(mesh);
    const auto vertices = interleave(positions, normals, facets_.vertices);
    std::vector<gpu::VertexBuffer> buffers{position_buffer(vertices, position_location, normal_location)};
    std::vector<model::Facet> facets;
    if (kind == SurfaceKind::facets) {
        facets = facets_of(mesh, facets_, positions, normals);
        buffers.push_back(facet_buffer(facets));
    }
    const auto texcoords = picked(mesh.texcoords, facets_.vertices);
    if (!texcoords.empty()) {
        buffers.push_back({std::as_bytes(std::span(texcoords)), sizeof(glm::vec2), {{texcoord_location, 2}}});
    }
    const auto colors = has_one_color ? one_color_a_triangle(mesh, facets_) : picked(mesh.colors, facets_.vertices);
    if (!colors.empty()) {
        buffers.push_back(
            {std::as_bytes(std::span(colors)), sizeof(glm::u8vec4), {{color_location, 4, Kind::bytes_to_unit}}});
    }
    std::vector<PositionAndNormal> rest;
    if (kind == SurfaceKind::anchored) {
        rest = interleave(mesh.positions, mesh.normals, {});
        buffers.push_back(position_buffer(rest, rest_position_location, rest_normal_location));
    }
    geometry_ = std::make_unique<gpu::Geometry>(context, buffers, corners());
}

const std::vector<std::uint32_t>& MeshGeometry::corners() const {
    return facets_.vertices.empty() ? mesh_->triangles : facets_.triangles;
}

void MeshGeometry::draw(std::span<const std::uint32_t> triangles) {
    std::vector<std::uint32_t> chosen;
    chosen.reserve(3 * triangles.size());
    for (const std::uint32_t triangle : triangles) {
        const auto first = corners().begin() + std::ptrdiff_t{3} * triangle;
        chosen.insert(chosen.end(), first, first + 3);
    }
    geometry_->draw(chosen);
}

void MeshGeometry::move(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals) {
    const auto vertices = interleave(positions, normals, facets_.vertices);
    geometry_->update(moving_buffer, std::as_bytes(std::span(vertices)));
    if (kind_ != SurfaceKind::facets) return;
    const auto facets = facets_of(*mesh_, facets_, positions, normals);
    geometry_->update(moving_facet_buffer, std::as_bytes(std::span(facets)));
}

}  // namespace croquis::framework
