#include "framework/scene.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "base/names.h"
#include "image/palette.h"
#include "model/posed_shape.h"

namespace croquis::framework {
namespace {

// Locations of the attributes, as data/shaders/scene.glsl and wireframe.glsl declare them.
constexpr unsigned position_location = 0, normal_location = 1, texcoord_location = 2, color_location = 3;
constexpr unsigned edge_start_location = 0, edge_end_location = 1, edge_normal_a_location = 2,
                   edge_normal_b_location = 3;

constexpr int surface_texture_unit = 0;

struct PositionAndNormal {
    glm::vec3 position;
    glm::vec3 normal;
};

std::vector<PositionAndNormal> interleave(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals) {
    std::vector<PositionAndNormal> vertices(positions.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) vertices[i] = {positions[i], normals[i]};
    return vertices;
}

std::unique_ptr<gpu::Geometry> upload(gpu::Context& context, const model::Mesh& mesh) {
    const std::vector<PositionAndNormal> vertices = interleave(mesh.positions, mesh.normals);
    using Kind = gpu::Attribute::Kind;
    std::vector<gpu::VertexBuffer> buffers;
    buffers.push_back(
        {std::as_bytes(std::span(vertices)),
         sizeof(PositionAndNormal),
         {{position_location, 3, Kind::floats, 0}, {normal_location, 3, Kind::floats, sizeof(glm::vec3)}}});
    if (!mesh.texcoords.empty()) {
        buffers.push_back({std::as_bytes(std::span(mesh.texcoords)), sizeof(glm::vec2), {{texcoord_location, 2}}});
    }
    if (!mesh.colors.empty()) {
        buffers.push_back(
            {std::as_bytes(std::span(mesh.colors)), sizeof(glm::u8vec4), {{color_location, 4, Kind::bytes_to_unit}}});
    }
    return std::make_unique<gpu::Geometry>(context, buffers, mesh.triangles);
}

glm::mat4 scene_from(const model::Model& model) {
    const model::SceneSpace space = model::SceneSpace::of(model);
    glm::dmat4 matrix = glm::scale(glm::dmat4(1.0), glm::dvec3(1.0 / space.radius));
    matrix = glm::translate(matrix, model.origin - space.centre);
    return glm::mat4(matrix);
}

gpu::Cull cull_of(const model::Topology& topology, std::size_t mesh) {
    if (!topology.mesh_is_solid[mesh]) return gpu::Cull::none;
    return topology.mesh_is_inverted[mesh] ? gpu::Cull::front : gpu::Cull::back;
}

// An edge as the wireframe's vertex shader reads it; the second normal repeats the first on a border.
struct EdgeInstance {
    glm::vec3 a, b;
    glm::vec3 normal_a, normal_b;
};

}  // namespace

ObjectSelection::ObjectSelection(const std::string& words) {
    for (std::string& word : split(words, " \t\n,")) {
        const bool excludes = word.front() == '-';
        words_.push_back({excludes ? word.substr(1) : word, excludes});
    }
}

bool ObjectSelection::includes(const model::Model& model, const model::Mesh& mesh) const {
    bool chosen = words_.empty() || words_.front().excludes;
    for (const Word& word : words_) {
        const bool matches = matches_pattern(mesh.name, word.pattern) ||
                             matches_pattern(model.materials[mesh.material].name, word.pattern) ||
                             word.pattern == fmt::format("#{}", mesh.region);
        if (matches) chosen = !word.excludes;
    }
    return chosen;
}

Scene::Scene(Resources& resources, std::shared_ptr<const model::Model> model)
    : resources_(&resources), model_(std::move(model)), scene_from_model_(scene_from(*model_)) {
    const model::Topology& topology = model_->topology();
    parts_.reserve(model_->meshes.size());
    for (std::size_t i = 0; i < model_->meshes.size(); ++i) {
        const model::Mesh& mesh = model_->meshes[i];
        const auto& image = model_->materials[mesh.material].texture;
        parts_.push_back(
            {upload(resources.gpu(), mesh), image ? resources.image(image) : nullptr, cull_of(topology, i), {}});
    }
    find_bounds();
}

void Scene::find_bounds() {
    model::Bounds box = model_->bounds;
    if (pose_) {
        box = {};
        for (const model::MeshPose& mesh : *pose_) {
            for (const glm::vec3& position : mesh.positions) box.add(position);
        }
    }
    bounds_ = {glm::vec3(scene_from_model_ * glm::vec4(box.low, 1.0f)),
               glm::vec3(scene_from_model_ * glm::vec4(box.high, 1.0f))};
}

void Scene::set_pose(model::Pose pose) {
    pose_ = std::make_shared<const model::Pose>(std::move(pose));
    upload_positions(pose_.get());
}

void Scene::clear_pose() {
    if (!pose_) return;
    pose_.reset();
    upload_positions(nullptr);
}

void Scene::upload_positions(const model::Pose* pose) {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        const model::Mesh& mesh = model_->meshes[i];
        const auto vertices =
            pose ? interleave((*pose)[i].positions, (*pose)[i].normals) : interleave(mesh.positions, mesh.normals);
        parts_[i].surface->update(0, std::as_bytes(std::span(vertices)));
        parts_[i].edges = {};
    }
    find_bounds();
}

void Scene::draw_surfaces(const ObjectSelection& selection, const gpu::Program& program, gpu::DrawState state,
                          const SurfaceOptions& options) {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        const model::Mesh& mesh = model_->meshes[i];
        if (!selection.includes(*model_, mesh)) continue;
        const model::Material& material = model_->materials[mesh.material];
        state.cull = options.eye_is_outside && options.triangles == nullptr ? parts_[i].cull : gpu::Cull::none;
        gpu::apply(state);
        program.set("material_ambient", material.ambient);
        program.set("material_diffuse", material.diffuse);
        program.set("material_specular", material.specular);
        program.set("material_shininess", material.shininess);
        program.set("region", mesh.region);
        program.set("vertex_color_share", mesh.colors.empty() ? 0.0f : 1.0f);
        surface_texture(i, options).bind(surface_texture_unit);
        program.set("surface_sampler", surface_texture_unit);
        if (options.triangles != nullptr) {
            parts_[i].surface->draw((*options.triangles)[i]);
        } else {
            parts_[i].surface->draw();
        }
    }
}

const gpu::Texture& Scene::surface_texture(std::size_t mesh, const SurfaceOptions& options) {
    if (options.texture_for_all != nullptr) return *options.texture_for_all;
    if (!parts_[mesh].texture) return resources_->white();
    if (options.texture_colors == 0) return *parts_[mesh].texture;
    return reduced_texture(model_->materials[model_->meshes[mesh].material].texture, options.texture_colors);
}

const gpu::Texture& Scene::reduced_texture(const std::shared_ptr<const image::Image>& image, int colors) {
    constexpr std::size_t most_kept = 4;
    std::vector<ReducedTexture>& known = reduced_textures_[image.get()];
    for (const ReducedTexture& reduced : known) {
        if (reduced.colors == colors) return *reduced.texture;
    }
    if (known.size() == most_kept) known.erase(known.begin());
    const auto pixels = std::make_shared<const image::Image>(image::with_fewer_colors(*image, colors));
    known.push_back({colors, resources_->image(pixels)});
    return *known.back().texture;
}

void Scene::draw_edges(const ObjectSelection& selection, Edges which) {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        if (!selection.includes(*model_, model_->meshes[i])) continue;
        std::unique_ptr<gpu::Geometry>& edges = parts_[i].edges[which == Edges::all ? 0 : 1];
        if (!edges) edges = make_edges(i, which);
        edges->draw();
    }
}

// The edges of a mesh are those whose first face is its own, so that an edge between two meshes is drawn once.
std::unique_ptr<gpu::Geometry> Scene::make_edges(std::size_t mesh, Edges which) const {
    const model::Topology& topology = model_->topology();
    const model::PosedShape shape = model::posed_shape(*model_, pose());
    std::vector<EdgeInstance> edges;
    const auto add = [&](const model::Edge& edge) {
        if (topology.faces[edge.faces[0]].mesh != mesh) return;
        const std::uint32_t second = edge.faces[1] == model::no_face ? edge.faces[0] : edge.faces[1];
        edges.push_back({shape.positions[edge.vertices[0]], shape.positions[edge.vertices[1]],
                         shape.face_normals[edge.faces[0]], shape.face_normals[second]});
    };
    if (which == Edges::all) {
        for (const model::Edge& edge : topology.edges) add(edge);
    } else {
        for (const std::uint32_t index : topology.tagged_edges) add(topology.edges[index]);
    }
    using Kind = gpu::Attribute::Kind;
    const gpu::VertexBuffer buffer{std::as_bytes(std::span(edges)),
                                   sizeof(EdgeInstance),
                                   {{edge_start_location, 3, Kind::floats, offsetof(EdgeInstance, a)},
                                    {edge_end_location, 3, Kind::floats, offsetof(EdgeInstance, b)},
                                    {edge_normal_a_location, 3, Kind::floats, offsetof(EdgeInstance, normal_a)},
                                    {edge_normal_b_location, 3, Kind::floats, offsetof(EdgeInstance, normal_b)}},
                                   gpu::VertexBuffer::Step::instance};
    constexpr int strip_vertices = 4;
    return std::make_unique<gpu::Geometry>(resources_->gpu(), std::span(&buffer, 1), strip_vertices, int(edges.size()));
}

}  // namespace croquis::framework
