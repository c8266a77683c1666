// hatch: surfaces as strokes on what the target holds (seed A, 4.6.2; seed B, chapter 4).
#include <cmath>
#include <glm/trigonometric.hpp>

#include "base/error.h"
#include "components/occluder.h"
#include "framework/component.h"
#include "framework/render_target.h"

namespace croquis::components {
namespace {

using framework::Pass;
using framework::RenderContext;
using framework::SurfaceKind;

SurfaceKind kind_named(const std::string& word) {
    if (word == "facets") return SurfaceKind::facets;
    if (word == "anchored") return SurfaceKind::anchored;
    return SurfaceKind::smooth;
}

// Pixels of the picture along a scene unit at the distance of 1 from the eye; in a parallel projection, at any.
double pixels_per_unit(const RenderContext& context) {
    const model::Camera& camera = context.camera;
    const double reach = camera.projection == model::Projection::parallel ? camera.half_height : camera.tangent;
    return double(context.frame.height()) / context.pixel_scale / (2 * reach);
}

class Hatch final : public framework::Component {
public:
    explicit Hatch(const Pass& pass)
        : Component(pass),
          target_(pass),
          kind_(kind_named(pass.variable<std::string>("surfaces").value())),
          clear_color_(pass.variable<glm::vec3>("clear_color")),
          keep_color_(pass.variable<bool>("keep_color")),
          objects_(pass.variable<std::string>("objects")),
          strokes_(pass.variable<std::string>("strokes")),
          scale_(pass.variable<float>("scale")),
          angle_(pass.variable<float>("angle")),
          program_(pass.resources().program(pass.variable<std::string>("vertex_program").value(),
                                            pass.variable<std::string>("fragment_program").value())),
          occluder_(pass.resources()) {
        check_strokes();
    }

    void variable_changed(std::string_view name) override {
        if (name == "strokes") check_strokes();
    }

protected:
    void render(RenderContext& context) override {
        target_.clear(context, clear_color_.value());
        target_.prepare(context).bind();
        const bool paper_is_plain = !keep_color_.value() && !(target_.is_frame() && context.background);
        // Strokes are drawn on the nearest surfaces alone: ink of hidden ones would stay on the paper. Where the paper
        // is one known colour it is drawn with the strokes, and this pass is saved.
        if (!paper_is_plain) {
            occluder_.fill_depth(context, framework::ObjectSelection(objects_.value()), {.kind = kind_});
        }
        program_->use();
        context.apply(*program_);
        constexpr int first_free_unit = 1;  // the surface's own texture takes unit 0
        pass_.apply_parameters(*program_, first_free_unit);
        place_strokes(context);
        if (paper_is_plain) {
            program_->set("paper", glm::vec4(clear_color_.value(), 1.0f));
            draw(context,
                 {.depth_test = gpu::DepthTest::nearer, .write_depth = true, .stencil = gpu::Stencil::mark_surface});
        } else {
            program_->set("paper", glm::vec4(0.0f));
            draw(context, {.depth_test = gpu::DepthTest::nearer_or_equal, .blend = gpu::Blend::over_premultiplied});
        }
    }

private:
    void check_strokes() const {
        if (strokes_.value().empty()) fail("expected an image of strokes, found none");
    }

    // Seed A, listing 9: the image of strokes is turned and repeated in the picture's plane.
    void place_strokes(const RenderContext& context) const {
        const gpu::Texture& image = *pass_.texture("strokes");
        const float angle = glm::radians(angle_.value()), c = std::cos(angle), s = std::sin(angle);
        const glm::vec4 turn(c, -s, s, c);
        const glm::vec2 tile = scale_.value() * glm::vec2(image.width(), image.height());
        const float scale = float(context.pixel_scale);
        program_->set("strokes_turn", turn);
        program_->set("strokes_from_pixel", turn / (scale * glm::vec4(tile.x, tile.y, tile.x, tile.y)));
        program_->set("images_at_one", float(pixels_per_unit(context)) / tile.x);
    }

    void draw(RenderContext& context, const gpu::DrawState& state) const {
        context.scene.draw_surfaces(
            framework::ObjectSelection(objects_.value()), *program_, state,
            {.eye_is_outside = context.eye_is_outside(), .texture_for_all = nullptr, .kind = kind_});
    }

    framework::RenderTarget target_;
    SurfaceKind kind_;
    framework::Variable<glm::vec3> clear_color_;
    framework::Variable<bool> keep_color_;
    framework::Variable<std::string> objects_;
    framework::Variable<std::string> strokes_;
    framework::Variable<float> scale_;
    framework::Variable<float> angle_;
    std::shared_ptr<const gpu::Program> program_;
    Occluder occluder_;
};

}  // namespace

std::unique_ptr<framework::Component> make_hatch(const Pass& pass) { return std::make_unique<Hatch>(pass); }

}  // namespace croquis::components
