#include "croquis/view.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "api/view_request.h"
#include "base/error.h"
#include "croquis/model.h"

namespace croquis {
namespace {

std::optional<glm::dvec3> finite_if_given(const std::optional<Vector3>& v, const char* expected) {
    return v ? std::optional(finite(*v, expected)) : std::nullopt;
}

}  // namespace

glm::dvec3 finite(const Vector3& v, const char* expected) {
    const glm::dvec3 vector = as_vector(v);
    if (!std::isfinite(glm::length(vector))) fail("expected {}, found {},{},{}", expected, v[0], v[1], v[2]);
    return vector;
}

model::ViewRequest view_request(const View& view) {
    return {.direction = finite(view.direction, "the view to have a direction"),
            .fit = view.fit,
            .eye = finite_if_given(view.eye, "the eye at a finite distance"),
            .target = finite_if_given(view.target, "the target at a finite distance"),
            .up = finite(view.up, "the up vector to have a length"),
            .field_of_view = view.field_of_view * radians_per_degree,
            .projection = view.parallel ? model::Projection::parallel : model::Projection::perspective};
}

View View::named(const std::string& name) {
    const glm::dvec3 direction = model::named_view(name);
    View view;
    view.direction = {direction.x, direction.y, direction.z};
    return view;
}

View View::placed(const Model& model, double aspect) const {
    const model::Camera camera = model::place_camera(*model.model_, nullptr, view_request(*this), aspect);
    const model::SceneSpace space = model::SceneSpace::of(*model.model_);
    const glm::dvec3 looked_at = target ? as_vector(*target) : space.centre;
    // A parallel frame is as high as a perspective one at the target; there the eye's distance says how high.
    const double distance = parallel ? camera.half_height / camera.tangent * space.radius
                                     : glm::length(space.centre + space.radius * camera.eye - looked_at);
    const glm::dvec3 stand = looked_at + distance * camera.back;
    View placed = *this;
    placed.eye = {stand.x, stand.y, stand.z};
    placed.target = {looked_at.x, looked_at.y, looked_at.z};
    placed.up = {camera.up.x, camera.up.y, camera.up.z};
    return placed;
}

}  // namespace croquis
