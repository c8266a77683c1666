// What a pass sees of the frame that is being drawn.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>

#include "framework/resources.h"
#include "framework/scene.h"
#include "gpu/framebuffer.h"
#include "gpu/state.h"
#include "model/camera.h"

namespace croquis::framework {

/// The one light: where it is, bound to the viewer or to the world, and its colour (seed C, equation 4.1).
struct Light {
    enum class Bound { viewer, world };
    enum class Kind { direction, point };
    Bound bound = Bound::viewer;
    Kind kind = Kind::direction;
    /// Towards the light, or its position: along the camera's right, up and back from the target's distance for a
    /// light bound to the viewer, else in scene space.
    glm::dvec3 place{-0.5, 0.7, 1.0};
    glm::vec3 color{1.0f};
};

/// What stands behind the drawing in place of the technique's own clear colour.
struct Background {
    glm::vec4 color{1.0f};                      ///< alpha 0: transparent
    std::shared_ptr<const gpu::Texture> image;  ///< tiled, pixel by pixel; none for a plain colour
    std::shared_ptr<const gpu::Program> tiled;  ///< draws it: image:tiled
};

struct RenderContext {
    Resources& resources;
    Scene& scene;
    const model::Camera& camera;
    const Light& light;
    gpu::Framebuffer& frame;  ///< colour and depth: "the framebuffer" of the techniques
    std::optional<Background> background = std::nullopt;
    int pixel_scale = 1;  ///< pixels of `frame` along one pixel of the picture: above 1 when it is oversampled
    std::uint64_t seed = 0;
    int frame_number = 0;
    double time = 0;  ///< seconds

    /// The light in scene space: its position (w = 1), or the unit direction to it (w = 0).
    [[nodiscard]] glm::vec4 light_in_scene() const;

    [[nodiscard]] double aspect() const { return double(frame.width()) / double(frame.height()); }

    /// Clears the frame's colour to the asked background, or to the technique's own colour.
    void clear_frame(const glm::vec3& color) const;

    /// Fills the frame with an image, from the upper left, with the program of image:tiled.
    void tile_frame(const gpu::Program& program, const gpu::Texture& image, float scale) const;

    /// The part of a target that the model's vertices cover, and `margin` pixels around it: all that can hold anything
    /// of the model (seed A, 5.4.1).
    [[nodiscard]] gpu::Rectangle model_rectangle(int width, int height, int margin) const;

    /// True when the eye stands outside the model's box: then the backs of closed meshes cannot be seen.
    [[nodiscard]] bool eye_is_outside() const;

    /// Gives a program what it wants to know of camera, light and frame. It must be in use.
    void apply(const gpu::Program& program) const;
};

}  // namespace croquis::framework
