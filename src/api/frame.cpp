#include "api/frame.h"

#include <algorithm>
#include <glm/vec2.hpp>

#include "gpu/state.h"

namespace croquis {
namespace {

std::shared_ptr<gpu::Texture> texture(gpu::Context& context, gpu::TextureFormat format) {
    return std::make_shared<gpu::Texture>(context, format, 1, 1);
}

void divide_by_alpha(std::vector<std::uint8_t>& pixels) {
    for (std::size_t i = 0; i < pixels.size(); i += 4) {
        const unsigned alpha = pixels[i + 3];
        if (alpha == 255 || alpha == 0) continue;
        for (std::size_t c = i; c < i + 3; ++c) {
            pixels[c] = std::uint8_t(std::min(255u, (pixels[c] * 255u + alpha / 2) / alpha));
        }
    }
}

}  // namespace

Frame::Frame(framework::Resources& resources)
    : resources_(&resources),
      samples_(resources.gpu(), texture(resources.gpu(), gpu::TextureFormat::rgba8),
               texture(resources.gpu(), gpu::TextureFormat::depth)),
      picture_(resources.gpu(), texture(resources.gpu(), gpu::TextureFormat::rgba8), nullptr) {}

void Frame::resize(int width, int height, int pixel_scale) {
    width_ = width;
    height_ = height;
    pixel_scale_ = pixel_scale;
    samples_.resize(width * pixel_scale, height * pixel_scale);
}

void Frame::draw_mean() const {
    mean_->use();
    samples_.color()->bind(0);
    mean_->set("texture_sampler", 0);
    mean_->set("pixel_scale", pixel_scale_);
    resources_->draw_full_screen();
}

gpu::Framebuffer& Frame::resolve() {
    if (pixel_scale_ == 1) return samples_;
    if (!mean_) mean_ = resources_->program("image:full_screen", "image:mean_of_samples");
    picture_.resize(width_, height_);
    picture_.bind();
    gpu::apply({});
    draw_mean();
    return picture_;
}

std::vector<std::uint8_t> Frame::read() {
    std::vector<std::uint8_t> pixels = resolve().read_pixels();
    divide_by_alpha(pixels);
    return pixels;
}

void Frame::present(unsigned framebuffer) {
    if (!mean_) mean_ = resources_->program("image:full_screen", "image:mean_of_samples");
    gpu::bind_foreign_framebuffer(framebuffer, width_, height_);
    gpu::apply({.blend = gpu::Blend::over_premultiplied});
    draw_mean();
}

}  // namespace croquis
