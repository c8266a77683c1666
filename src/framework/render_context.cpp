#include "framework/render_context.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

namespace croquis::framework {
namespace {

// A position has w = 1, a direction w = 0.
glm::vec4 eye_in_scene(const model::Camera& camera) {
    if (camera.projection == model::Projection::parallel) return {glm::vec3(camera.back), 0.0f};
    return {glm::vec3(camera.eye), 1.0f};
}

}  // namespace

glm::vec4 RenderContext::light_in_scene() const {
    glm::dvec3 place = light.place;
    if (light.bound == Light::Bound::viewer) {
        place = camera.right * light.place.x + camera.up * light.place.y + camera.back * light.place.z;
    }
    if (light.kind == Light::Kind::direction) return {glm::vec3(glm::normalize(place)), 0.0f};
    return {glm::vec3(place), 1.0f};
}

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

gpu::Rectangle RenderContext::model_rectangle(int width, int height, int margin) const {
    const glm::dvec2 size(width, height);
    const glm::ivec2 low = glm::floor((camera.covered_low * 0.5 + 0.5) * size);
    const glm::ivec2 high = glm::ceil((camera.covered_high * 0.5 + 0.5) * size);
    const glm::ivec2 from = glm::max(low - margin, glm::ivec2(0));
    const glm::ivec2 to = glm::min(high + margin, glm::ivec2(width, height));
    return {from.x, from.y, std::max(to.x - from.x, 0), std::max(to.y - from.y, 0)};
}

bool RenderContext::eye_is_outside() const {
    if (camera.projection == model::Projection::parallel) return true;
    const model::Bounds& box = scene.bounds();
    return glm::any(glm::lessThan(camera.eye, glm::dvec3(box.low))) ||
           glm::any(glm::greaterThan(camera.eye, glm::dvec3(box.high)));
}

void RenderContext::apply(const gpu::Program& program) const {
    const glm::mat4 eye_from_scene = camera.eye_from_scene();
    const glm::mat4 clip_from_eye = camera.clip_from_eye(aspect());
    program.set("eye_from_scene", eye_from_scene);
    program.set("clip_from_scene", clip_from_eye * eye_from_scene);
    program.set("scene_from_model", scene.scene_from_model());
    program.set("eye_scene", eye_in_scene(camera));
    program.set("light_scene", light_in_scene());
    program.set("light_color", light.color);
    program.set("near_plane", float(camera.near_plane));
    program.set("far_plane", float(camera.far_plane));
    program.set("frame_reach", glm::vec2(1.0f / clip_from_eye[0][0], 1.0f / clip_from_eye[1][1]));
    program.set("is_parallel", camera.projection == model::Projection::parallel);
    program.set("pixel_scale", pixel_scale);
    program.set("frame_size", glm::vec2(frame.width(), frame.height()));
}

}  // namespace croquis::framework
