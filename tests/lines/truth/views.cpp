#include "truth/views.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "base/random.h"

namespace croquis::lines::truth {

SurfacePointer surface_of(const test_support::ModelPointer& model) { return std::make_shared<const Surface>(model); }

SurfacePointer surface_of(const std::vector<Corners>& meshes) {
    std::vector<test_support::Piece> pieces;
    for (const Corners& corners : meshes) pieces.push_back({"mesh " + std::to_string(pieces.size()), corners});
    return surface_of(test_support::model_of(pieces));
}

Viewpoint view_from(const Surface& surface, const glm::dvec3& direction, const ViewOptions& options) {
    model::ViewRequest request;
    request.direction = direction;
    request.projection = options.projection;
    request.fit = options.fit;
    request.field_of_view = options.field_of_view;
    const double aspect = options.width / options.height;
    const model::Camera camera = model::place_camera(surface.model(), nullptr, request, aspect);
    Viewpoint view = Viewpoint::of(camera, options.width, options.height);
    view.scale *= options.zoom;
    return view;
}

Viewpoint random_view(const Surface& surface, std::uint64_t seed, std::uint64_t index) {
    const Random random(seed, "views");
    const auto number = [&](std::uint64_t which) { return random.unit(16 * index + which); };
    const double height = 2 * number(0) - 1, turn = 6.283185307179586 * number(1);
    const double radius = std::sqrt(1 - height * height);
    ViewOptions options;
    if (index % 3 == 2) options.projection = model::Projection::parallel;
    options.width = 400 + std::floor(600 * number(2));
    options.height = 400 + std::floor(400 * number(3));
    options.field_of_view = index % 5 == 0 ? 1.7 : 0.3 + 0.6 * number(4);
    if (index % 4 == 3) options.zoom = 1.2 + 2 * number(5);
    return view_from(surface, {radius * std::cos(turn), radius * std::sin(turn), height}, options);
}

Viewpoint view_at(const glm::dvec3& eye, const glm::dvec3& looking, double field_of_view) {
    Viewpoint view;
    view.eye = eye;
    view.back = -glm::normalize(looking);
    const glm::dvec3 up = std::abs(view.back.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    view.right = glm::normalize(glm::cross(up, view.back));
    view.up = glm::cross(view.back, view.right);
    view.width = 640;
    view.height = 480;
    view.scale = 0.5 * view.height / std::tan(0.5 * field_of_view);
    view.near_distance = 1e-4;
    return view;
}

glm::dvec3 in_scene(const Surface& surface, const glm::dvec3& point) {
    return model::SceneSpace::of(surface.model()).from_file(point);
}

Options exact_options(Visibility visibility) {
    Options options;
    options.clean = false;
    options.hidden = true;
    options.visibility = visibility;
    return options;
}

Drawing draw(const SurfacePointer& surface, const Viewpoint& view, const Options& options) {
    return Drafter(surface, options).draw(view);
}

namespace {

#if defined(__SANITIZE_ADDRESS__)  // as GCC says it
constexpr bool is_sanitized = true;
#elif defined(__has_feature)  // as clang does
constexpr bool is_sanitized = __has_feature(address_sanitizer);
#else
constexpr bool is_sanitized = false;
#endif

}  // namespace

int fewer_if_slow(int count) { return is_sanitized ? std::max(1, count / 25) : count; }

}  // namespace croquis::lines::truth
