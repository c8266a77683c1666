#include "framework/render_target.h"

#include <algorithm>

namespace croquis::framework {
namespace {

int side(std::int32_t asked, int frame, int pixel_scale, int longest) {
    if (asked == 0) return frame;
    const int wanted = asked > 0 ? asked * pixel_scale : (frame + (-asked) - 1) / -asked;
    return std::clamp(wanted, 1, longest);
}

}  // namespace

RenderTarget::RenderTarget(const Pass& pass)
    : width_(pass.variable<std::int32_t>("render_target_width")),
      height_(pass.variable<std::int32_t>("render_target_height")),
      keep_color_(pass.variable<bool>("keep_color")),
      keep_depth_(pass.variable<bool>("keep_depth")) {
    const std::string& name = pass.variable<std::string>("render_target").value();
    if (name.empty()) return;
    framebuffer_ = std::make_unique<gpu::Framebuffer>(
        pass.resources().gpu(), pass.generated().declare(name + "_color", gpu::TextureFormat::rgba8),
        pass.generated().declare(name + "_depth", gpu::TextureFormat::depth));
}

gpu::Framebuffer& RenderTarget::prepare(RenderContext& context) {
    if (!framebuffer_) return context.frame;
    const int longest = context.resources.gpu().longest_side();
    framebuffer_->resize(side(width_.value(), context.frame.width(), context.pixel_scale, longest),
                         side(height_.value(), context.frame.height(), context.pixel_scale, longest));
    return *framebuffer_;
}

void RenderTarget::clear(RenderContext& context, const glm::vec3& color) {
    gpu::Framebuffer& target = prepare(context);
    if (!keep_depth_.value()) target.clear_depth();
    if (keep_color_.value()) return;
    if (is_frame()) {
        context.clear_frame(color);
    } else {
        target.clear_color({color, 1.0f});
    }
}

}  // namespace croquis::framework
