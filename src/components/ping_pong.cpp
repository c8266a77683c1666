// ping_pong: a fragment function run n times, each time on what the last run made.
#include <array>
#include <utility>

#include "base/error.h"
#include "components/shader_pair.h"
#include "framework/component.h"
#include "framework/render_context.h"

namespace croquis::components {
namespace {

using framework::Pass;
using framework::RenderContext;

class PingPong final : public framework::Component {
public:
    explicit PingPong(const Pass& pass)
        : Component(pass),
          iterations_(pass.variable<std::int32_t>("iterations")),
          shaders_(ShaderPair::full_screen(pass)),
          copy_(pass.resources().program("image:full_screen", "image:stretch")),
          result_(pass.resources().gpu(),
                  pass.generated().declare(pass.variable<std::string>("result").value(), gpu::TextureFormat::rgba8),
                  nullptr),
          other_(pass.resources().gpu(),
                 std::make_shared<gpu::Texture>(pass.resources().gpu(), gpu::TextureFormat::rgba8, 1, 1), nullptr) {
        check_texture();
    }

    void variable_changed(std::string_view name) override {
        if (name == "texture") check_texture();
        shaders_.variable_changed(name);
    }

protected:
    void render(RenderContext& context) override {
        result_.resize(context.frame.width(), context.frame.height());
        other_.resize(context.frame.width(), context.frame.height());
        gpu::apply({});
        const gpu::Texture* source = pass_.texture("texture");
        const int runs = iterations_.value();
        if (runs == 0) run(context, *copy_, *source, result_);
        for (int i = 0; i < runs; ++i) {
            // The last run ends in the result, whether runs are odd or even.
            const bool to_result = (runs - i) % 2 == 1;
            gpu::Framebuffer& destination = to_result ? result_ : other_;
            run(context, shaders_.program(), *source, destination);
            source = destination.color().get();
        }
    }

private:
    void check_texture() const {
        if (pass_.variable<std::string>("texture").value().empty())
            fail("expected a texture to start from, found none");
    }

    void run(RenderContext& context, const gpu::Program& program, const gpu::Texture& source,
             const gpu::Framebuffer& destination) const {
        constexpr int source_unit = 0, first_parameter_unit = 1;
        destination.bind();
        program.use();
        context.apply(program);
        pass_.apply_parameters(program, first_parameter_unit);
        source.bind(source_unit);
        program.set("texture_sampler", source_unit);
        context.resources.draw_full_screen();
    }

    framework::Variable<std::int32_t> iterations_;
    ShaderPair shaders_;
    std::shared_ptr<const gpu::Program> copy_;
    gpu::Framebuffer result_;
    gpu::Framebuffer other_;
};

}  // namespace

std::unique_ptr<framework::Component> make_ping_pong(const Pass& pass) { return std::make_unique<PingPong>(pass); }

}  // namespace croquis::components
