// render_attributes: normals, region ids and linear depth from one pass over the scene, packed into two words a pixel
// (seed C, 3.4; row E6).
#include <glm/common.hpp>

#include "components/shader_pair.h"
#include "framework/component.h"
#include "framework/render_target.h"
#include "framework/surface_words.h"

namespace croquis::components {
namespace {

using framework::Pass;
using framework::RenderContext;

class RenderAttributes final : public framework::Component {
public:
    explicit RenderAttributes(const Pass& pass)
        : Component(pass),
          target_(pass, gpu::TextureFormat::rg32ui),
          objects_(pass.variable<std::string>("objects")),
          keep_color_(pass.variable<bool>("keep_color")),
          keep_depth_(pass.variable<bool>("keep_depth")),
          shaders_(pass, gpu::Output::words) {
        if (target_.is_frame()) fail("component {} needs a render_target: the frame holds no words", pass.component().name);
    }

    void variable_changed(std::string_view name) override { shaders_.variable_changed(name); }

protected:
    void render(RenderContext& context) override {
        gpu::Framebuffer& target = target_.prepare(context);
        if (!keep_color_.value()) target.clear_words(background_words(context.camera));
        if (!keep_depth_.value()) target.clear_depth();
        target.bind();
        const gpu::Program& program = shaders_.program();
        program.use();
        context.apply(program);
        context.scene.draw_surfaces(framework::ObjectSelection(objects_.value()), program,
                                    {.depth_test = gpu::DepthTest::nearer, .write_depth = true},
                                    {context.eye_is_outside(), nullptr});
    }

private:
    // A normal into the screen, no region, and the far plane's distance.
    [[nodiscard]] static glm::uvec4 background_words(const model::Camera& camera) {
        const framework::SurfaceWords words =
            framework::pack({-glm::vec3(camera.back), 0, float(camera.far_plane)});
        return {words[0], words[1], 0, 0};
    }

    framework::RenderTarget target_;
    framework::Variable<std::string> objects_;
    framework::Variable<bool> keep_color_;
    framework::Variable<bool> keep_depth_;
    ShaderPair shaders_;
};

}  // namespace

std::unique_ptr<framework::Component> make_render_attributes(const Pass& pass) {
    return std::make_unique<RenderAttributes>(pass);
}

}  // namespace croquis::components
