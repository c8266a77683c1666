// generate_texture: an image made by a fragment function, kept until a variable changes.
#include "components/shader_pair.h"
#include "framework/component.h"
#include "framework/render_context.h"

namespace croquis::components {
namespace {

using framework::Pass;
using framework::RenderContext;

class GenerateTexture final : public framework::Component {
public:
    explicit GenerateTexture(const Pass& pass)
        : Component(pass),
          width_(pass.variable<std::int32_t>("width")),
          height_(pass.variable<std::int32_t>("height")),
          shaders_(ShaderPair::full_screen(pass)),
          target_(pass.resources().gpu(),
                  pass.generated().declare(pass.variable<std::string>("texture").value(), gpu::TextureFormat::rgba8),
                  nullptr) {}

    void variable_changed(std::string_view name) override { shaders_.variable_changed(name); }

protected:
    void render(RenderContext& context) override {
        if (made_revision_ == pass_.revision() && made_seed_ == context.seed) return;
        target_.resize(width_.value(), height_.value());
        target_.bind();
        const gpu::Program& program = shaders_.program();
        program.use();
        gpu::apply({});
        context.apply(program);
        program.set("frame_size", glm::vec2(width_.value(), height_.value()));
        program.set("seed", unsigned(context.seed));
        pass_.apply_parameters(program, 0);
        context.resources.draw_full_screen();
        made_revision_ = pass_.revision();
        made_seed_ = context.seed;
    }

private:
    framework::Variable<std::int32_t> width_;
    framework::Variable<std::int32_t> height_;
    ShaderPair shaders_;
    gpu::Framebuffer target_;
    int made_revision_ = -1;
    std::uint64_t made_seed_ = 0;
};

}  // namespace

std::unique_ptr<framework::Component> make_generate_texture(const Pass& pass) {
    return std::make_unique<GenerateTexture>(pass);
}

}  // namespace croquis::components
