// copy_to_texture: the frame's colour or depth into a generated texture (seed C, 2.3).
#include "framework/component.h"
#include "framework/render_context.h"

namespace croquis::components {
namespace {

using framework::Pass;
using framework::RenderContext;
using Part = gpu::Framebuffer::Part;

class CopyToTexture final : public framework::Component {
public:
    explicit CopyToTexture(const Pass& pass)
        : Component(pass), part_(pass.variable<bool>("depth").value() ? Part::depth : Part::color) {
        // Declared now, so that other passes find it.
        const std::string& name = pass.variable<std::string>("texture").value();
        const bool is_depth = part_ == Part::depth;
        auto texture = pass.generated().declare(name, is_depth ? gpu::TextureFormat::depth : gpu::TextureFormat::rgba8);
        copy_ = std::make_unique<gpu::Framebuffer>(pass.resources().gpu(), is_depth ? nullptr : texture,
                                                   is_depth ? texture : nullptr);
    }

protected:
    void render(RenderContext& context) override {
        copy_->resize(context.frame.width(), context.frame.height());
        context.frame.copy_to(*copy_, part_);
    }

private:
    Part part_;
    std::unique_ptr<gpu::Framebuffer> copy_;
};

}  // namespace

std::unique_ptr<framework::Component> make_copy_to_texture(const Pass& pass) {
    return std::make_unique<CopyToTexture>(pass);
}

}  // namespace croquis::components
