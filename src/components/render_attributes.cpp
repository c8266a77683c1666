// render_attributes: normals, region ids and linear depth from one pass over the scene into two textures (seed C, 3.4;
// row E6).
#include "base/error.h"
#include "components/shader_pair.h"
#include "framework/component.h"
#include "framework/render_context.h"
#include "framework/surface_attributes.h"

namespace croquis::components {
namespace {

using framework::Pass;
using framework::RenderContext;

class RenderAttributes final : public framework::Component {
public:
    explicit RenderAttributes(const Pass& pass)
        : Component(pass),
          target_(make_target(pass)),
          objects_(pass.variable<std::string>("objects")),
          keep_color_(pass.variable<bool>("keep_color")),
          keep_depth_(pass.variable<bool>("keep_depth")),
          shaders_(pass, gpu::Output::two) {}

    void variable_changed(std::string_view name) override { shaders_.variable_changed(name); }

protected:
    void render(RenderContext& context) override {
        target_.resize(context.frame.width(), context.frame.height());
        if (!keep_color_.value()) clear_to_background(context.camera);
        if (!keep_depth_.value()) target_.clear_depth();
        target_.bind();
        const gpu::Program& program = shaders_.program();
        program.use();
        context.apply(program);
        context.scene.draw_surfaces(framework::ObjectSelection(objects_.value()), program,
                                    {.depth_test = gpu::DepthTest::nearer, .write_depth = true},
                                    {.eye_is_outside = context.eye_is_outside()});
    }

private:
    static gpu::Framebuffer make_target(const Pass& pass) {
        const std::string& name = pass.variable<std::string>("render_target").value();
        if (name.empty()) fail("component {} needs a name in render_target", pass.component().name);
        framework::GeneratedTextures& generated = pass.generated();
        return gpu::Framebuffer(pass.resources().gpu(), generated.declare(name + "_normals", gpu::TextureFormat::rgba8),
                                generated.declare(name + "_depth", gpu::TextureFormat::depth),
                                generated.declare(name + "_distances", gpu::TextureFormat::rgba8));
    }

    // A normal into the screen (seed C, 3.3.1), no region, the far plane's depth.
    void clear_to_background(const model::Camera& camera) const {
        const framework::PackedAttributes background =
            framework::pack({.normal = -glm::vec3(camera.back), .region = 0, .depth = 1.0f, .facing = 1.0f});
        const auto color = [](const std::array<std::uint8_t, 4>& bytes) {
            return glm::vec4(bytes[0], bytes[1], bytes[2], bytes[3]) / 255.0f;
        };
        target_.clear_color(color(background.normals));
        target_.clear_second_color(color(background.distances));
    }

    gpu::Framebuffer target_;
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
