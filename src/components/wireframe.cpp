// wireframe: all edges as instanced quads of any width; hidden ones left out by a depth that surfaces filled first, so
// that whatever the frame holds stays behind the lines (seed A, 2.3.2).
#include "framework/component.h"
#include "framework/render_context.h"
#include "gpu/state.h"

namespace croquis::components {
namespace {

using framework::Pass;
using framework::RenderContext;

class Wireframe final : public framework::Component {
public:
    explicit Wireframe(const Pass& pass)
        : Component(pass),
          width_(pass.variable<float>("width")),
          hide_(pass.variable<bool>("hide")),
          keep_color_(pass.variable<bool>("keep_color")),
          keep_depth_(pass.variable<bool>("keep_depth")),
          clear_color_(pass.variable<glm::vec3>("clear_color")),
          objects_(pass.variable<std::string>("objects")),
          edges_(pass.variable<std::string>("edges")),
          lines_(pass.resources().program("wireframe:edge_quad", "wireframe:line")),
          depth_only_(pass.resources().program("default:default_transform", "attributes:nothing")) {}

protected:
    void render(RenderContext& context) override {
        const bool only_tagged = edges_.value() == "tagged";
        if (only_tagged && !context.scene.has_tagged_edges()) return;
        if (!keep_depth_.value()) context.frame.clear_depth();
        if (!keep_color_.value()) context.clear_frame(clear_color_.value());
        context.frame.bind();
        const framework::ObjectSelection selection(objects_.value());
        if (hide_.value()) fill_depth(context, selection);
        lines_->use();
        context.apply(*lines_);
        pass_.apply_parameters(*lines_, 0);
        gpu::apply({.depth_test = hide_.value() ? gpu::DepthTest::nearer_or_equal : gpu::DepthTest::off,
                    .blend = gpu::Blend::over});
        using Edges = framework::Scene::Edges;
        context.scene.draw_edges(selection, only_tagged ? Edges::tagged : Edges::all);
    }

private:
    // Pushed back by the slope over half a line's width: a line's inner half lies on the surface beside it.
    void fill_depth(RenderContext& context, const framework::ObjectSelection& selection) const {
        depth_only_->use();
        context.apply(*depth_only_);
        context.scene.draw_surfaces(selection, *depth_only_,
                                    {.depth_test = gpu::DepthTest::nearer,
                                     .write_depth = true,
                                     .write_color = false,
                                     .push_back = 1.0f + 0.5f * width_.value() * float(context.pixel_scale)},
                                    {context.eye_is_outside(), nullptr});
    }

    framework::Variable<float> width_;
    framework::Variable<bool> hide_;
    framework::Variable<bool> keep_color_;
    framework::Variable<bool> keep_depth_;
    framework::Variable<glm::vec3> clear_color_;
    framework::Variable<std::string> objects_;
    framework::Variable<std::string> edges_;
    std::shared_ptr<const gpu::Program> lines_;
    std::shared_ptr<const gpu::Program> depth_only_;
};

}  // namespace

std::unique_ptr<framework::Component> make_wireframe(const Pass& pass) { return std::make_unique<Wireframe>(pass); }

}  // namespace croquis::components
