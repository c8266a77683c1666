// What users ask of a view, checked and in the terms of src/model.
#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "croquis/view.h"
#include "model/camera.h"

namespace croquis {

constexpr double radians_per_degree = 3.14159265358979323846 / 180.0;

[[nodiscard]] inline glm::dvec3 as_vector(const Vector3& v) { return {v[0], v[1], v[2]}; }

/// The vector; throws Error, "expected …, found …", for one that is not finite.
[[nodiscard]] glm::dvec3 finite(const Vector3& v, const char* expected);

/// Throws Error for numbers that are not finite.
[[nodiscard]] model::ViewRequest view_request(const View& view);

}  // namespace croquis
