#include "viewer/canvas.h"

#include <memory>

#include "gpu/state.h"

namespace croquis::viewer {

Canvas::Canvas()
    : context_(gpu::Context::current()),
      framebuffer_(*context_, std::make_shared<gpu::Texture>(*context_, gpu::TextureFormat::rgba8, 1, 1), nullptr) {}

void Canvas::resize(FrameSize wanted) {
    if (wanted.width == framebuffer_.width() && wanted.height == framebuffer_.height()) return;
    framebuffer_.resize(wanted.width, wanted.height);
    clear();
}

void Canvas::clear() {
    const gpu::SavedState saved;
    gpu::apply({});
    framebuffer_.clear_color(glm::vec4(1.0f));
}

}  // namespace croquis::viewer
