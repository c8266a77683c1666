// edge_detect: edges from normals, depth and region ids in one pass (seed C, 3.3.4), only where the model can be.
#include <algorithm>
#include <array>

#include "components/blend_modes.h"
#include "framework/component.h"
#include "framework/render_target.h"

namespace croquis::components {
namespace {

using framework::Pass;
using framework::RenderContext;
using framework::Variable;

class EdgeDetect final : public framework::Component {
public:
    explicit EdgeDetect(const Pass& pass)
        : Component(pass),
          target_(pass),
          blend_(pass.variable<std::string>("blend")),
          apply_threshold_(pass.variable<bool>("apply_threshold")),
          non_edge_color_(pass.variable<glm::vec4>("non_edge_color")),
          edge_colors_{pass.variable<glm::vec4>("edge_color"), pass.variable<glm::vec4>("normal_edge_color"),
                       pass.variable<glm::vec4>("depth_edge_color"), pass.variable<glm::vec4>("id_edge_color")},
          one_color_(pass.resources().program("image:full_screen", "edges_combined:one_color")),
          color_by_cause_(pass.resources().program("image:full_screen", "edges_combined:color_by_cause")),
          intensity_(pass.resources().program("image:full_screen", "edges_combined:intensity")) {}

protected:
    void render(RenderContext& context) override {
        gpu::Framebuffer& target = target_.prepare(context);
        gpu::Blend blend = blend_named(blend_.value());
        // Outside the model there is no edge: what the pass would draw there is one colour.
        if (blend == gpu::Blend::off) target.clear_color(outside_color());
        if (blend == gpu::Blend::off && target_.is_frame() && !is_opaque()) blend = gpu::Blend::multiplied;
        const bool adds_outside = blend_.value() != "none" && non_edge_color_.value().a > 0;
        const int reach = 1 + context.pixel_scale;
        target.bind();
        const gpu::Program& program = choose_program();
        program.use();
        gpu::DrawState state{.blend = blend};
        if (!adds_outside) state.within = context.model_rectangle(target.width(), target.height(), reach);
        gpu::apply(state);
        context.apply(program);
        pass_.apply_parameters(program, 0);
        context.resources.draw_full_screen();
        gpu::apply({});
    }

private:
    // The frame holds colours multiplied by alpha.
    [[nodiscard]] glm::vec4 outside_color() const {
        const glm::vec4& color = non_edge_color_.value();
        return target_.is_frame() ? glm::vec4(glm::vec3(color) * color.a, color.a) : color;
    }

    [[nodiscard]] bool is_opaque() const {
        const auto is_solid = [](const Variable<glm::vec4>& color) { return color.value().a >= 1.0f; };
        return is_solid(non_edge_color_) && std::all_of(edge_colors_.begin(), edge_colors_.end(), is_solid);
    }

    // All three are linked when the component is made: changing a variable compiles nothing.
    [[nodiscard]] const gpu::Program& choose_program() const {
        if (!apply_threshold_.value()) return *intensity_;
        for (const Variable<glm::vec4>& color : edge_colors_) {
            if (color.value() != edge_colors_.front().value()) return *color_by_cause_;
        }
        return *one_color_;
    }

    framework::RenderTarget target_;
    Variable<std::string> blend_;
    Variable<bool> apply_threshold_;
    Variable<glm::vec4> non_edge_color_;
    std::array<Variable<glm::vec4>, 4> edge_colors_;
    std::shared_ptr<const gpu::Program> one_color_;
    std::shared_ptr<const gpu::Program> color_by_cause_;
    std::shared_ptr<const gpu::Program> intensity_;
};

}  // namespace

std::unique_ptr<framework::Component> make_edge_detect(const Pass& pass) { return std::make_unique<EdgeDetect>(pass); }

}  // namespace croquis::components
