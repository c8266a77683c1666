#include "components/outline_edges.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <unordered_map>

#include "base/parallel.h"
#include "base/random.h"
#include "model/camera.h"
#include "model/welding.h"

namespace croquis::components {

OutlineEdges::OutlineEdges(std::shared_ptr<const lines::Surface> surface)
    : surface_(std::move(surface)), finder_(lines::make_finder("automatic", *surface_)) {}

std::uint32_t OutlineEdges::third_corner(std::uint32_t edge, std::uint32_t face) const {
    const auto& ends = surface_->topology().edges[edge].vertices;
    const auto& corners = surface_->topology().faces[face].vertices;
    return *std::find_if(corners.begin(), corners.end(),
                         [&](std::uint32_t corner) { return corner != ends[0] && corner != ends[1]; });
}

bool OutlineEdges::bounds_its_faces(std::uint32_t edge, const lines::Viewpoint& view,
                                    const std::vector<bool>& shown) const {
    const auto& [a, b] = surface_->topology().edges[edge].vertices;
    const glm::dvec3 start = surface_->point(a);
    const glm::dvec3 across = glm::cross(surface_->point(b) - start, view.towards_eye(start));
    bool left = false, right = false;
    for (const std::uint32_t index : surface_->faces_around(a)) {
        const model::Face& face = surface_->topology().faces[index];
        const bool holds_edge = std::find(face.vertices.begin(), face.vertices.end(), b) != face.vertices.end();
        if (!holds_edge || !shown[face.mesh]) continue;
        const double side = glm::dot(across, surface_->point(third_corner(edge, index)) - start);
        left = left || side > 0;
        right = right || side < 0;
    }
    return left != right;
}

// Edges that may be contours but are not for the finder to decide: with one face, three or more, or two that are wound
// against each other, and those between what is shown and what is not.
std::vector<std::uint32_t> OutlineEdges::contour_candidates(const lines::Viewpoint& view,
                                                            const std::vector<bool>& shown) {
    const auto irregular = surface_->irregular_edges();
    std::vector<std::uint32_t> candidates(irregular.begin(), irregular.end());
    if (std::find(shown.begin(), shown.end(), false) != shown.end()) {
        const std::vector<std::uint32_t> between = surface_->material_boundaries();
        candidates.insert(candidates.end(), between.begin(), between.end());
    }
    std::erase_if(candidates, [&](std::uint32_t edge) { return !bounds_its_faces(edge, view, shown); });
    const std::vector<std::uint32_t>& silhouettes = finder_->find(view);
    candidates.insert(candidates.end(), silhouettes.begin(), silhouettes.end());
    std::sort(candidates.begin(), candidates.end());
    candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
    return candidates;
}

std::vector<EdgeWithFace> OutlineEdges::contours(const lines::Viewpoint& view, const std::vector<bool>& shown) {
    const model::Topology& topology = surface_->topology();
    std::vector<EdgeWithFace> found;
    for (const std::uint32_t edge : contour_candidates(view, shown)) {
        for (const std::uint32_t face : topology.edges[edge].faces) {
            if (face == model::no_face || !shown[topology.faces[face].mesh]) continue;
            found.push_back({edge, third_corner(edge, face)});
            break;
        }
    }
    return found;
}

// Lines that share a vertex hang together: each vertex leads on to another of its heap, the heap's first to itself.
std::vector<EdgeWithFace> OutlineEdges::without_specks(std::vector<EdgeWithFace> lines, const lines::Viewpoint& view,
                                                       double shortest) const {
    if (shortest <= 0) return lines;
    const model::Topology& topology = surface_->topology();
    std::unordered_map<std::uint32_t, std::uint32_t> leads_to;
    const auto first_of = [&](std::uint32_t vertex) {
        while (leads_to.at(vertex) != vertex) vertex = leads_to[vertex] = leads_to.at(leads_to.at(vertex));
        return vertex;
    };
    for (const EdgeWithFace& line : lines) {
        const auto& [a, b] = topology.edges[line.edge].vertices;
        leads_to.try_emplace(a, a);
        leads_to.try_emplace(b, b);
        leads_to[first_of(a)] = first_of(b);
    }
    std::unordered_map<std::uint32_t, double> pixels;
    for (const EdgeWithFace& line : lines) {
        const auto& [a, b] = topology.edges[line.edge].vertices;
        const glm::dvec3 start = surface_->point(a), end = surface_->point(b);
        const bool before_eye = std::min(view.eye_distance(start), view.eye_distance(end)) > view.near_distance;
        pixels[first_of(a)] +=
            before_eye ? glm::distance(view.project(start).position, view.project(end).position) : shortest;
    }
    std::erase_if(lines, [&](const EdgeWithFace& line) {
        return pixels.at(first_of(topology.edges[line.edge].vertices[0])) < shortest;
    });
    return lines;
}

std::vector<EdgeWithFace> OutlineEdges::edges_of_faces(const lines::Viewpoint& view, Facing facing,
                                                       const std::vector<bool>& shown) const {
    const model::Topology& topology = surface_->topology();
    std::vector<std::uint8_t> drawn(topology.faces.size());
    parallel_for(drawn.size(), 8192, [&](std::size_t begin, std::size_t end) {
        for (std::size_t face = begin; face < end; ++face) {
            const bool front = surface_->front_facing(std::uint32_t(face), view);
            drawn[face] = shown[topology.faces[face].mesh] && front == (facing == Facing::front);
        }
    });
    std::vector<EdgeWithFace> found;
    for (std::uint32_t edge = 0; edge < topology.edges.size(); ++edge) {
        const auto& [first, second] = topology.edges[edge].faces;
        const bool first_drawn = drawn[first] != 0, second_drawn = second != model::no_face && drawn[second] != 0;
        if (first_drawn == second_drawn) continue;
        found.push_back({edge, third_corner(edge, first_drawn ? first : second)});
    }
    return found;
}

std::vector<EdgeWithFace> OutlineEdges::inner_edges(double crease_angle, const std::vector<bool>& shown) const {
    const model::Topology& topology = surface_->topology();
    std::vector<std::uint32_t> edges = surface_->creases(crease_angle);
    const std::vector<std::uint32_t> boundaries = surface_->material_boundaries();
    edges.insert(edges.end(), boundaries.begin(), boundaries.end());
    edges.insert(edges.end(), topology.tagged_edges.begin(), topology.tagged_edges.end());
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    std::vector<EdgeWithFace> found;
    for (const std::uint32_t edge : edges) {
        const std::uint32_t face = topology.edges[edge].faces[0];
        if (shown[topology.faces[face].mesh]) found.push_back({edge, third_corner(edge, face)});
    }
    return found;
}

namespace {

// The texel at a texture coordinate; (0, 0) is the image's lower left, and the image is repeated.
glm::vec3 texel(const image::Image& image, const glm::vec2& at) {
    const glm::vec2 place = glm::fract(at) * glm::vec2(image.width(), image.height());
    const int x = std::clamp(int(place.x), 0, image.width() - 1);
    const int y = std::clamp(image.height() - 1 - int(place.y), 0, image.height() - 1);
    return glm::vec3(image.at(x, y)) / 255.0f;
}

// What a vertex shows without light, as data/shaders/default.glsl has it in base().
glm::vec3 surface_color(const model::Mesh& mesh, const model::Material& material, std::size_t vertex) {
    glm::vec3 color = material.diffuse;
    if (!mesh.colors.empty()) color *= glm::vec3(mesh.colors[vertex]) / 255.0f;
    if (material.texture && !mesh.texcoords.empty()) color *= texel(*material.texture, mesh.texcoords[vertex]);
    return color;
}

model::WeldedPoints weld_meshes(const model::Model& model) {
    std::vector<std::span<const glm::vec3>> meshes;
    for (const model::Mesh& mesh : model.meshes) meshes.emplace_back(mesh.positions);
    return model::weld_points(meshes);
}

// A random vector of a lattice point, components between -1 and 1.
glm::vec3 lattice_vector(const Random& random, const glm::ivec3& at) {
    const auto bits = [](int i) { return std::uint64_t(std::uint32_t(i)); };
    const std::uint64_t column = random.bits((bits(at.x) << 32) | bits(at.y));
    const auto component = [&](std::uint64_t c) { return float(random.between(-1, 1, column + 3 * bits(at.z) + c)); };
    return {component(0), component(1), component(2)};
}

// Between the eight lattice points around a place, without a kink where cells meet.
glm::vec3 smooth_noise(const Random& random, const glm::vec3& at) {
    const glm::vec3 cell = glm::floor(at), inside = at - cell;
    const glm::vec3 share = inside * inside * (3.0f - 2.0f * inside);
    glm::vec3 sum(0.0f);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 step(corner & 1, (corner >> 1) & 1, corner >> 2);
        const glm::vec3 weight = glm::mix(1.0f - share, share, glm::vec3(step));
        sum += weight.x * weight.y * weight.z * lattice_vector(random, glm::ivec3(cell) + step);
    }
    return sum;
}

}  // namespace

std::vector<glm::u8vec4> own_line_colors(const model::Model& model, float darkening) {
    const model::Topology& topology = model.topology();
    const model::WeldedPoints welded = weld_meshes(model);
    std::vector<glm::u8vec4> colors(topology.positions.size());
    for (std::size_t m = 0; m < model.meshes.size(); ++m) {
        const model::Mesh& mesh = model.meshes[m];
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            const std::uint32_t id = welded.ids[welded.first_of_list[m] + v];
            const glm::vec3 color = surface_color(mesh, model.materials[mesh.material], v) * (1.0f - darkening);
            colors[topology.sewn.empty() ? id : topology.sewn[id]] =
                glm::u8vec4(glm::clamp(color, 0.0f, 1.0f) * 255.0f + 0.5f, 255);
        }
    }
    return colors;
}

std::vector<glm::vec3> ink_offsets(const model::Model& model, float amount, float grain, std::uint64_t seed) {
    const Random random(seed, "ink offsets");
    const model::SceneSpace space = model::SceneSpace::of(model);
    const std::vector<glm::vec3>& positions = model.topology().positions;
    std::vector<glm::vec3> offsets(positions.size());
    parallel_for(offsets.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            if (grain > 0) {
                const glm::vec3 place(space.from_file(glm::dvec3(positions[v]) + model.origin));
                offsets[v] = amount * smooth_noise(random, place / grain);
            } else {
                for (int c = 0; c < 3; ++c)
                    offsets[v][c] = amount * float(random.between(-1, 1, 3 * v + std::size_t(c)));
            }
        }
    });
    return offsets;
}

}  // namespace croquis::components
