// process_texture: any fragment function over the whole target; the edge detectors are derived from it by descriptor.
#include "components/blend_modes.h"
#include "components/shader_pair.h"
#include "framework/component.h"
#include "framework/render_target.h"

namespace croquis::components {
namespace {

using framework::Pass;
using framework::RenderContext;

class ProcessTexture final : public framework::Component {
public:
    explicit ProcessTexture(const Pass& pass)
        : Component(pass),
          target_(pass),
          blend_(pass.variable<std::string>("blend")),
          shaders_(ShaderPair::full_screen(pass)) {}

    void variable_changed(std::string_view name) override { shaders_.variable_changed(name); }

protected:
    void render(RenderContext& context) override {
        target_.prepare(context).bind();
        const gpu::Program& program = shaders_.program();
        program.use();
        gpu::Blend blend = blend_named(blend_.value());
        if (blend == gpu::Blend::off && target_.is_frame()) blend = gpu::Blend::multiplied;
        gpu::apply({.blend = blend});
        context.apply(program);
        pass_.apply_parameters(program, 0);
        context.resources.draw_full_screen();
    }

private:
    framework::RenderTarget target_;
    framework::Variable<std::string> blend_;
    ShaderPair shaders_;
};

}  // namespace

std::unique_ptr<framework::Component> make_process_texture(const Pass& pass) {
    return std::make_unique<ProcessTexture>(pass);
}

}  // namespace croquis::components
