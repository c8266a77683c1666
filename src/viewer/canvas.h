// The picture that the viewer shows. A drawing that fails leaves the last good one.
#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <memory>
#include <vector>

#include "croquis/picture.h"
#include "gpu/framebuffer.h"
#include "viewer/arrangement.h"

namespace croquis::viewer {

class Canvas {
public:
    /// Drawn in the context that is current, which must stay so.
    Canvas();

    /// Begins a drawing of that size on white. What it returns is for Renderer::draw_into. The last picture stays until
    /// `keep`.
    [[nodiscard]] unsigned begin(FrameSize size);
    /// The drawing is done: it is the picture now.
    void keep() {
        std::swap(shown_, drawn_);
        has_picture_ = true;
    }
    [[nodiscard]] bool has_picture() const { return has_picture_; }
    /// Takes a picture that was drawn elsewhere, laid on white.
    void put(const Picture& picture);

    [[nodiscard]] FrameSize size() const { return {shown_->width(), shown_->height()}; }
    /// For the user interface: the OpenGL texture, its first row the lowest.
    [[nodiscard]] unsigned texture() const { return shown_->color()->id(); }

    /// Waits until all that was asked for is drawn: to measure, and not to fall behind the mouse.
    void finish() { context_->finish(); }

    /// Rows from top to bottom, 4 bytes a pixel.
    [[nodiscard]] std::vector<std::uint8_t> pixels() const { return shown_->read_pixels(); }
    [[nodiscard]] glm::u8vec4 pixel(int x, int y) const { return shown_->read_pixel(x, y); }

private:
    std::unique_ptr<gpu::Context> context_;
    std::unique_ptr<gpu::Framebuffer> shown_, drawn_;
    bool has_picture_ = false;
};

}  // namespace croquis::viewer
