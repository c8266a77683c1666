// simple_render: the scene's surfaces through any pair of shader functions (seed C, program 2.2).
#include "components/chosen_faces.h"
#include "components/shader_pair.h"
#include "framework/component.h"
#include "framework/render_target.h"

namespace croquis::components {
namespace {

using framework::Pass;
using framework::RenderContext;
using framework::SurfaceKind;

// Of a variable that only some of the derived components declare.
bool is_on(const Pass& pass, const char* name) { return pass.has(name) && pass.variable<bool>(name).value(); }

class SimpleRender final : public framework::Component {
public:
    explicit SimpleRender(const Pass& pass)
        : Component(pass),
          target_(pass),
          clear_color_(pass.variable<glm::vec3>("clear_color")),
          objects_(pass.variable<std::string>("objects")),
          kind_(is_on(pass, "one_color") ? SurfaceKind::one_color : SurfaceKind::smooth),
          shaders_(pass) {
        if (pass.has("texture_colors")) texture_colors_ = pass.variable<std::int32_t>("texture_colors");
        if (pass.has("orientation")) chosen_faces_.emplace(pass);
    }

    void variable_changed(std::string_view name) override { shaders_.variable_changed(name); }

protected:
    void render(RenderContext& context) override {
        target_.clear(context, background_color(context));
        target_.prepare(context).bind();
        const gpu::Program& program = shaders_.program();
        program.use();
        context.apply(program);
        constexpr int first_free_unit = 1;  // the surface's own texture takes unit 0
        pass_.apply_parameters(program, first_free_unit);
        context.scene.draw_surfaces(
            framework::ObjectSelection(objects_.value()), program,
            {.depth_test = gpu::DepthTest::nearer, .write_depth = true, .stencil = gpu::Stencil::mark_surface},
            {.eye_is_outside = context.eye_is_outside(),
             .texture_for_all = pass_.texture("texture"),
             .kind = kind_,
             .texture_colors = texture_colors_ ? texture_colors_->value() : 0,
             .triangles = chosen_faces_ ? chosen_faces_->find(context) : nullptr});
    }

private:
    // The normal of the background points into the screen (seed C, 3.3.1).
    [[nodiscard]] glm::vec3 background_color(const RenderContext& context) const {
        return is_on(pass_, "clear_into_screen") ? 0.5f - 0.5f * glm::vec3(context.camera.back) : clear_color_.value();
    }

    framework::RenderTarget target_;
    framework::Variable<glm::vec3> clear_color_;
    framework::Variable<std::string> objects_;
    SurfaceKind kind_;
    ShaderPair shaders_;
    // What only some of the derived components declare.
    std::optional<framework::Variable<std::int32_t>> texture_colors_;
    std::optional<ChosenFaces> chosen_faces_;
};

}  // namespace

std::unique_ptr<framework::Component> make_simple_render(const Pass& pass) {
    return std::make_unique<SimpleRender>(pass);
}

}  // namespace croquis::components
