#include "croquis/model.h"

#include "model/load.h"
#include "model/simplification.h"
#include "model/subdivision.h"

namespace croquis {

Model Model::load(const std::string& path, const std::string& texture, const LoadProgress& progress) {
    model::LoadOptions options;
    options.texture = texture;
    options.progress = model::Progress(path, progress);
    return Model(model::load(path, options));
}

std::vector<std::string> Model::readable_endings() { return model::readable_endings(); }

std::size_t Model::triangle_count() const { return model_->triangle_count(); }

std::size_t Model::mesh_count() const { return model_->meshes.size(); }

std::vector<Animation> Model::animations() const {
    std::vector<Animation> animations;
    for (const model::AnimationClip& clip : model_->clips) animations.push_back({clip.name, clip.seconds});
    return animations;
}

Model Model::subdivided(const std::string& scheme, int levels) const {
    return Model(model::subdivide(*model_, model::subdivision_scheme(scheme), levels));
}

Model Model::simplified(std::size_t triangles) const { return Model(model::simplified(model_, triangles)); }

Model Model::clustered(std::size_t triangles) const { return Model(model::clustered(model_, triangles)); }

std::array<double, 3> Model::low_corner() const {
    const glm::dvec3 corner = model_->origin + glm::dvec3(model_->bounds.low);
    return {corner.x, corner.y, corner.z};
}

std::array<double, 3> Model::high_corner() const {
    const glm::dvec3 corner = model_->origin + glm::dvec3(model_->bounds.high);
    return {corner.x, corner.y, corner.z};
}

}  // namespace croquis
