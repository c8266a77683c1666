#include "framework/scene.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "base/names.h"
#include "image/palette.h"
#include "model/posed_shape.h"
#include "model/texcoord_scale.h"

namespace croquis::framework {
namespace {

// Locations of the attributes, as data/shaders/wireframe.glsl declares them.
constexpr unsigned edge_start_location = 0, edge_end_location = 1, edge_normal_a_location = 2,
                   edge_normal_b_location = 3;

constexpr int surface_texture_unit = 0;

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
        parts_.push_back({{}, image ? resources.image(image) : nullptr, cull_of(topology, i), {}, {}, {}});
        (void)surface(i, SurfaceKind::smooth);
    }
    find_bounds();
}

void Scene::find_bounds() {
    model::Bounds box;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        model::Bounds own;
        for (const glm::vec3& position : positions(i)) own.add(position);
        parts_[i].middle = own.centre();
        box.add(own.low);
        box.add(own.high);
    }
    bounds_ = {glm::vec3(scene_from_model_ * glm::vec4(box.low, 1.0f)),
               glm::vec3(scene_from_model_ * glm::vec4(box.high, 1.0f))};
}

void Scene::set_pose(model::Pose pose) {
    pose_ = std::make_shared<const model::Pose>(std::move(pose));
    move_vertices();
}

void Scene::clear_pose() {
    if (!pose_) return;
    pose_.reset();
    move_vertices();
}

void Scene::move_vertices() {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        for (const auto& surface : parts_[i].surfaces) {
            if (surface) surface->move(positions(i), normals(i));
        }
        parts_[i].edges = {};
    }
    find_bounds();
}

glm::mat4 Scene::scaled(const Part& part, float scale) const {
    glm::mat4 about_middle = glm::translate(glm::mat4(1.0f), part.middle);
    about_middle = glm::scale(about_middle, glm::vec3(scale));
    return scene_from_model_ * glm::translate(about_middle, -part.middle);
}

std::span<const glm::vec3> Scene::positions(std::size_t mesh) const {
    return pose_ ? (*pose_)[mesh].positions : model_->meshes[mesh].positions;
}

std::span<const glm::vec3> Scene::normals(std::size_t mesh) const {
    return pose_ ? (*pose_)[mesh].normals : model_->meshes[mesh].normals;
}

MeshGeometry& Scene::surface(std::size_t mesh, SurfaceKind kind) {
    std::unique_ptr<MeshGeometry>& surface = parts_[mesh].surfaces[std::size_t(kind)];
    if (!surface) {
        surface = std::make_unique<MeshGeometry>(resources_->gpu(), model_->meshes[mesh], kind, positions(mesh),
                                                 normals(mesh));
    }
    return *surface;
}

// In images a scene unit.
float Scene::texcoord_scale(std::size_t mesh) {
    std::optional<float>& scale = parts_[mesh].texcoord_scale;
    if (!scale) scale = float(model::texcoord_scale(model_->meshes[mesh])) / scene_from_model_[0][0];
    return *scale;
}

void Scene::draw_surfaces(const ObjectSelection& selection, const gpu::Program& program, gpu::DrawState state,
                          const SurfaceOptions& options) {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        const model::Mesh& mesh = model_->meshes[i];
        if (!selection.includes(*model_, mesh)) continue;
        const model::Material& material = model_->materials[mesh.material];
        state.cull = options.eye_is_outside && options.triangles == nullptr ? parts_[i].cull : gpu::Cull::none;
        gpu::apply(state);
        if (options.scale != 1) program.set("scene_from_model", scaled(parts_[i], options.scale));
        program.set("material_ambient", material.ambient);
        program.set("material_diffuse", material.diffuse);
        program.set("material_specular", material.specular);
        program.set("material_shininess", material.shininess);
        program.set("region", mesh.region);
        program.set("vertex_color_share", mesh.colors.empty() ? 0.0f : 1.0f);
        surface_texture(i, options).bind(surface_texture_unit);
        program.set("surface_sampler", surface_texture_unit);
        if (program.uses("texcoord_scale")) program.set("texcoord_scale", texcoord_scale(i));
        if (options.triangles != nullptr) {
            surface(i, options.kind).draw((*options.triangles)[i]);
        } else {
            surface(i, options.kind).draw();
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
