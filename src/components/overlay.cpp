// overlay: a texture laid over the frame, everywhere or only where nothing in the frame is nearer.
#include "components/blend_modes.h"
#include "framework/component.h"
#include "framework/render_context.h"

namespace croquis::components {
namespace {

using framework::Pass;
using framework::RenderContext;

class Overlay final : public framework::Component {
public:
    explicit Overlay(const Pass& pass) : Component(pass), mode_(pass.variable<std::string>("mode")) { link(); }

    void variable_changed(std::string_view name) override {
        if (name == "mode") link();
    }

protected:
    void render(RenderContext& context) override {
        const bool has_depth = pass_.texture("depth") != nullptr;
        context.frame.bind();
        program_->use();
        gpu::apply({.depth_test = has_depth ? gpu::DepthTest::nearer_or_equal : gpu::DepthTest::off,
                    .blend = blend_named(mode_.value())});
        context.apply(*program_);
        program_->set("has_depth", has_depth);
        pass_.apply_parameters(*program_, 0);
        context.resources.draw_full_screen();
    }

private:
    void link() {
        const char* function = mode_.value() == "over" ? "overlay:overlay" : "overlay:overlay_multiplied";
        program_ = pass_.resources().program("image:full_screen", function);
    }

    framework::Variable<std::string> mode_;
    std::shared_ptr<const gpu::Program> program_;
};

}  // namespace

std::unique_ptr<framework::Component> make_overlay(const Pass& pass) { return std::make_unique<Overlay>(pass); }

}  // namespace croquis::components
