// The faces that a pass draws by its variable `orientation`: those that one of seed A's methods (3.5.2) takes for
// facing the eye. The GPU's own way is faster by far; these are here to be compared.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "framework/pass.h"
#include "framework/render_context.h"
#include "model/face_orientation.h"

namespace croquis::components {

class ChosenFaces {
public:
    explicit ChosenFaces(const framework::Pass& pass) : orientation_(pass.variable<std::string>("orientation")) {}

    /// One list a mesh of the triangles to draw: all of a mesh that is not closed, for there backs are seen too. Null
    /// where the choice is left to the GPU, and where the eye stands inside the model.
    [[nodiscard]] const std::vector<std::vector<std::uint32_t>>* find(const framework::RenderContext& context);

private:
    void prepare_for(const framework::Scene& scene);
    void collect(const model::Model& model);

    framework::Variable<std::string> orientation_;
    std::shared_ptr<const model::Model> model_;  // that faces_ is of
    std::shared_ptr<const model::Pose> pose_;
    std::optional<model::FaceOrientation> faces_;
    std::vector<std::uint8_t> is_front_;
    std::vector<std::vector<std::uint32_t>> triangles_;
};

}  // namespace croquis::components
