// background: a colour or a tiled image behind the drawing, in place of the clear colour (seed A, 2.3.1).
#include "framework/component.h"
#include "framework/render_context.h"
#include "gpu/state.h"

namespace croquis::components {
namespace {

using framework::Pass;
using framework::RenderContext;

class Background final : public framework::Component {
public:
    explicit Background(const Pass& pass)
        : Component(pass),
          color_(pass.variable<glm::vec3>("color")),
          scale_(pass.variable<float>("scale")),
          keep_depth_(pass.variable<bool>("keep_depth")),
          tiled_(pass.resources().program("image:full_screen", "image:tiled")) {}

protected:
    void render(RenderContext& context) override {
        if (!keep_depth_.value()) context.frame.clear_depth();
        const gpu::Texture* image = pass_.texture("texture");
        if (image == nullptr || context.background) {
            context.clear_frame(color_.value());
        } else {
            context.tile_frame(*tiled_, *image, scale_.value());
        }
    }

private:
    framework::Variable<glm::vec3> color_;
    framework::Variable<float> scale_;
    framework::Variable<bool> keep_depth_;
    std::shared_ptr<const gpu::Program> tiled_;
};

}  // namespace

std::unique_ptr<framework::Component> make_background(const Pass& pass) { return std::make_unique<Background>(pass); }

}  // namespace croquis::components
