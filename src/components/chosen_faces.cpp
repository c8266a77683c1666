#include "components/chosen_faces.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace croquis::components {
namespace {

// Scene space is the model's, moved and scaled: directions are the same.
model::Eye eye_in_model(const framework::RenderContext& context) {
    const model::Camera& camera = context.camera;
    if (camera.projection == model::Projection::parallel) return {glm::vec3(camera.back), true};
    const glm::mat4 model_from_scene = glm::inverse(context.scene.scene_from_model());
    return {glm::vec3(model_from_scene * glm::vec4(glm::vec3(camera.eye), 1.0f)), false};
}

}  // namespace

const std::vector<std::vector<std::uint32_t>>* ChosenFaces::find(const framework::RenderContext& context) {
    if (orientation_.value() == "exact" || !context.eye_is_outside()) return nullptr;
    prepare_for(context.scene);
    faces_->find(model::orientation_method(orientation_.value()), eye_in_model(context), context.seed, is_front_);
    collect(context.scene.model());
    return &triangles_;
}

void ChosenFaces::prepare_for(const framework::Scene& scene) {
    if (faces_ && model_ == scene.shared_model() && pose_ == scene.shared_pose()) return;
    model_ = scene.shared_model();
    pose_ = scene.shared_pose();
    faces_.emplace(*model_, pose_.get());
}

void ChosenFaces::collect(const model::Model& model) {
    triangles_.resize(model.meshes.size());
    std::size_t first = 0;
    for (std::size_t i = 0; i < model.meshes.size(); ++i) {
        const auto count = std::uint32_t(model.meshes[i].triangle_count());
        const bool is_solid = model.topology().mesh_is_solid[i];
        triangles_[i].clear();
        for (std::uint32_t face = 0; face < count; ++face) {
            if (!is_solid || is_front_[first + face] != 0) triangles_[i].push_back(face);
        }
        first += count;
    }
}

}  // namespace croquis::components
