#include "viewer/canvas.h"

#include "gpu/state.h"

namespace croquis::viewer {
namespace {

std::unique_ptr<gpu::Framebuffer> blank_picture(gpu::Context& context) {
    const auto color = std::make_shared<gpu::Texture>(context, gpu::TextureFormat::rgba8, 1, 1);
    auto framebuffer = std::make_unique<gpu::Framebuffer>(context, color, nullptr);
    framebuffer->clear_color(glm::vec4(1.0f));
    return framebuffer;
}

}  // namespace

Canvas::Canvas()
    : context_(gpu::Context::current()), shown_(blank_picture(*context_)), drawn_(blank_picture(*context_)) {}

unsigned Canvas::begin(FrameSize size) {
    const gpu::SavedState saved;
    gpu::apply({});
    drawn_->resize(size.width, size.height);
    drawn_->clear_color(glm::vec4(1.0f));
    return drawn_->id();
}

}  // namespace croquis::viewer
