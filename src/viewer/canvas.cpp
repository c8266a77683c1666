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

void Canvas::put(const Picture& picture) {
    std::vector<std::uint8_t> pixels = picture.pixels();
    for (std::size_t i = 0; i < pixels.size(); i += 4) {
        const unsigned alpha = pixels[i + 3];
        if (alpha == 255) continue;
        for (std::size_t c = i; c < i + 3; ++c) {
            pixels[c] = std::uint8_t((pixels[c] * alpha + 255u * (255u - alpha) + 127u) / 255u);
        }
        pixels[i + 3] = 255;
    }
    const gpu::SavedState saved;
    const auto color = std::make_shared<gpu::Texture>(*context_, pixels.data(), picture.width(), picture.height(),
                                                      gpu::Filter::nearest, gpu::Wrap::clamp);
    drawn_ = std::make_unique<gpu::Framebuffer>(*context_, color, nullptr);
    keep();
}

}  // namespace croquis::viewer
