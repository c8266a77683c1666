#include "croquis/view.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "api/view_request.h"
#include "base/error.h"

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

}  // namespace croquis
