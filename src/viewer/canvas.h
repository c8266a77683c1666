// The picture that the viewer shows: drawn anew only when something of it changed, kept when a drawing fails.
#pragma once

#include <cstdint>
#include <glm/gtc/type_precision.hpp>
#include <vector>

#include "gpu/framebuffer.h"
#include "viewer/arrangement.h"

namespace croquis::viewer {

class Canvas {
public:
    /// Drawn in the context that is current, which must stay so.
    Canvas();

    /// Takes another size, blank. Nothing happens when the size is the same.
    void resize(FrameSize size);
    /// Makes all of it white: what a drawing with a transparent background is shown on.
    void clear();

    [[nodiscard]] FrameSize size() const { return {framebuffer_.width(), framebuffer_.height()}; }
    /// What Renderer::draw_into takes.
    [[nodiscard]] unsigned framebuffer() const { return framebuffer_.id(); }
    /// For the user interface: the OpenGL texture, its first row the lowest.
    [[nodiscard]] unsigned texture() const { return framebuffer_.color()->id(); }

    /// Rows from top to bottom, 4 bytes a pixel.
    [[nodiscard]] std::vector<std::uint8_t> pixels() const { return framebuffer_.read_pixels(); }
    [[nodiscard]] glm::u8vec4 pixel(int x, int y) const { return framebuffer_.read_pixel(x, y); }

private:
    std::unique_ptr<gpu::Context> context_;
    gpu::Framebuffer framebuffer_;
};

}  // namespace croquis::viewer
