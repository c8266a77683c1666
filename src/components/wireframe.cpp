// wireframe: all edges as instanced quads of any width; hidden ones left out by a depth that surfaces filled first, so
// that whatever the frame holds stays behind the lines (seed A, 2.3.2).
#include "components/occluder.h"
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
          occluder_scale_(pass.variable<float>("occluder_scale")),
          keep_color_(pass.variable<bool>("keep_color")),
          keep_depth_(pass.variable<bool>("keep_depth")),
          clear_color_(pass.variable<glm::vec3>("clear_color")),
          objects_(pass.variable<std::string>("objects")),
          edges_(pass.variable<std::string>("edges")),
          lines_(pass.resources().program("wireframe:edge_quad", "wireframe:line")),
          occluder_(pass.resources()) {}

protected:
    void render(RenderContext& context) override {
        const bool only_tagged = edges_.value() == "tagged";
        if (only_tagged && !context.scene.has_tagged_edges()) return;
        if (!keep_depth_.value()) context.frame.clear_depth();
        if (!keep_color_.value()) context.clear_frame(clear_color_.value());
        context.frame.bind();
        const framework::ObjectSelection selection(objects_.value());
        if (hide_.value()) occluder_.fill_depth(context, selection, {push_back(context), occluder_scale_.value()});
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
    [[nodiscard]] float push_back(const RenderContext& context) const {
        return 1.0f + 0.5f * width_.value() * float(context.pixel_scale);
    }

    framework::Variable<float> width_;
    framework::Variable<bool> hide_;
    framework::Variable<float> occluder_scale_;
    framework::Variable<bool> keep_color_;
    framework::Variable<bool> keep_depth_;
    framework::Variable<glm::vec3> clear_color_;
    framework::Variable<std::string> objects_;
    framework::Variable<std::string> edges_;
    std::shared_ptr<const gpu::Program> lines_;
    Occluder occluder_;
};

}  // namespace

std::unique_ptr<framework::Component> make_wireframe(const Pass& pass) { return std::make_unique<Wireframe>(pass); }

}  // namespace croquis::components
