// Surfaces of triangle lists, and views of them.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>

#include "lines/drafter.h"
#include "lines/surface.h"
#include "lines/viewpoint.h"
#include "support/models.h"
#include "truth/solids.h"

namespace croquis::lines::truth {

using SurfacePointer = std::shared_ptr<const Surface>;

[[nodiscard]] SurfacePointer surface_of(const test_support::ModelPointer& model);
/// One mesh a list.
[[nodiscard]] SurfacePointer surface_of(const std::vector<Corners>& meshes);

struct ViewOptions {
    model::Projection projection = model::Projection::perspective;
    double width = 800, height = 600;  ///< pixels
    double fit = 0.9;
    double field_of_view = 0.7;  ///< radians
    double zoom = 1;             ///< above 1, the frame cuts off part of the model
};

/// The whole model from a direction.
[[nodiscard]] Viewpoint view_from(const Surface& surface, const glm::dvec3& direction, const ViewOptions& options = {});

/// A view of the whole model or of a part of it, from anywhere, perspective or parallel: a function of seed and index.
[[nodiscard]] Viewpoint random_view(const Surface& surface, std::uint64_t seed, std::uint64_t index);

/// Looks from a point of scene space, which may lie inside the model, along a direction.
[[nodiscard]] Viewpoint view_at(const glm::dvec3& eye, const glm::dvec3& looking, double field_of_view = 1.4);

/// A point of the model's file in scene space.
[[nodiscard]] glm::dvec3 in_scene(const Surface& surface, const glm::dvec3& point);

/// Lines as they are, hidden ones too, nothing cleaned.
[[nodiscard]] Options exact_options(Visibility visibility = Visibility::automatic);
[[nodiscard]] Drawing draw(const SurfacePointer& surface, const Viewpoint& view, const Options& options);

/// Under sanitizers tests look at fewer views.
[[nodiscard]] int fewer_if_slow(int count);

}  // namespace croquis::lines::truth
