#include "framework/render_context.h"

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "gpu/state.h"

namespace croquis::framework {
namespace {

// A position has w = 1, a direction w = 0 and unit length.
glm::vec4 light_in_scene(const Light& light, const model::Camera& camera) {
    glm::dvec3 place = light.place;
    if (light.bound == Light::Bound::viewer) {
        place = camera.right * light.place.x + camera.up * light.place.y + camera.back * light.place.z;
    }
    if (light.kind == Light::Kind::direction) return {glm::vec3(glm::normalize(place)), 0.0f};
    return {glm::vec3(place), 1.0f};
}

glm::vec4 eye_in_scene(const model::Camera& camera) {
    if (camera.projection == model::Projection::parallel) return {glm::vec3(camera.back), 0.0f};
    return {glm::vec3(camera.eye), 1.0f};
}

// The direction from a pixel's surface to the eye is centre + x · right + y · top, for x and y from -1 to 1.
struct Rays {
    glm::vec3 centre, right, top;
};

Rays rays_to_eye(const model::Camera& camera, double aspect) {
    if (camera.projection == model::Projection::parallel) return {glm::vec3(camera.back), {}, {}};
    return {glm::vec3(camera.back), glm::vec3(-camera.right * camera.tangent * aspect),
            glm::vec3(-camera.up * camera.tangent)};
}

}  // namespace

void RenderContext::clear_frame(const glm::vec3& color) const {
    if (!background) return frame.clear_color({color, 1.0f});
    const glm::vec4& plain = background->color;
    frame.clear_color({glm::vec3(plain) * plain.a, plain.a});
    if (background->image) tile_frame(*background->tiled, *background->image, 1.0f);
}

void RenderContext::tile_frame(const gpu::Program& program, const gpu::Texture& image, float scale) const {
    frame.bind();
    gpu::apply({});
    program.use();
    apply(program);
    image.bind(0);
    program.set("texture_sampler", 0);
    program.set("tile_size", scale * glm::vec2(image.width(), image.height()));
    resources.draw_full_screen();
}

bool RenderContext::eye_is_outside() const {
    if (camera.projection == model::Projection::parallel) return true;
    const model::Bounds& bounds = scene.model().bounds;
    const glm::dvec3 half_box = 0.5 * glm::dvec3(bounds.high - bounds.low) / model::SceneSpace::of(scene.model()).radius;
    return glm::any(glm::greaterThan(glm::abs(camera.eye), half_box));
}

void RenderContext::apply(const gpu::Program& program) const {
    const glm::mat4 eye_from_scene = camera.eye_from_scene();
    const glm::mat4 clip_from_eye = camera.clip_from_eye(aspect());
    program.set("eye_from_scene", eye_from_scene);
    program.set("clip_from_scene", clip_from_eye * eye_from_scene);
    program.set("scene_from_model", scene.scene_from_model());
    program.set("eye_scene", eye_in_scene(camera));
    const Rays rays = rays_to_eye(camera, aspect());
    program.set("ray_centre", rays.centre);
    program.set("ray_right", rays.right);
    program.set("ray_top", rays.top);
    program.set("light_scene", light_in_scene(light, camera));
    program.set("light_color", light.color);
    program.set("near_plane", float(camera.near_plane));
    program.set("far_plane", float(camera.far_plane));
    program.set("is_parallel", camera.projection == model::Projection::parallel);
    program.set("pixel_scale", pixel_scale);
    program.set("frame_size", glm::vec2(frame.width(), frame.height()));
}

}  // namespace croquis::framework
