// hatch: surfaces as strokes on what the target holds (seed A, 4.6.2; seed B, chapter 4).
#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "base/error.h"
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

// Pixels of the picture along a scene unit at the middle of the model.
double pixels_per_unit(const RenderContext& context) {
    const model::Camera& camera = context.camera;
    const double height = double(context.frame.height()) / context.pixel_scale;
    if (camera.projection == model::Projection::parallel) return height / (2 * camera.half_height);
    const glm::dvec3 middle(context.scene.bounds().centre());
    const double distance = std::max(glm::dot(camera.eye - middle, camera.back), camera.near_plane);
    return height / (2 * camera.tangent * distance);
}

// How many images of strokes lie along a scene unit: a power of two, so that one size of strokes goes over into the
// next without a third between them; and how far it has gone over, in the last third of the way.
glm::vec2 tiles_for(double tiles_per_unit) {
    const double octave = std::log2(tiles_per_unit) + 0.5;
    const double whole = std::floor(octave);
    return {float(std::exp2(whole)), float(std::clamp(3 * (octave - whole) - 2, 0.0, 1.0))};
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
          program_(program(pass, pass.variable<std::string>("fragment_program").value())),
          depth_only_(program(pass, "hatching:nothing")) {
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
        if (!paper_is_plain) fill_depth(context);
        program_->use();
        context.apply(*program_);
        constexpr int first_free_unit = 1;  // the surface's own texture takes unit 0
        pass_.apply_parameters(*program_, first_free_unit);
        place_strokes(context);
        if (paper_is_plain) {
            program_->set("paper", glm::vec4(clear_color_.value(), 1.0f));
            draw(context, *program_, {.depth_test = gpu::DepthTest::nearer, .write_depth = true});
        } else {
            program_->set("paper", glm::vec4(0.0f));
            draw(context, *program_,
                 {.depth_test = gpu::DepthTest::nearer_or_equal, .blend = gpu::Blend::over_premultiplied});
        }
    }

private:
    static std::shared_ptr<const gpu::Program> program(const Pass& pass, const std::string& fragment) {
        return pass.resources().program(pass.variable<std::string>("vertex_program").value(), fragment);
    }

    void check_strokes() const {
        if (strokes_.value().empty()) fail("expected an image of strokes, found none");
    }

    // Strokes are then drawn on the nearest surfaces alone: ink of hidden ones would stay on the paper. Where the paper
    // is one known colour it is drawn with the strokes, and this pass is saved.
    void fill_depth(RenderContext& context) const {
        depth_only_->use();
        context.apply(*depth_only_);
        draw(context, *depth_only_, {.depth_test = gpu::DepthTest::nearer, .write_depth = true, .write_color = false});
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
        program_->set("tiles", tiles_for(pixels_per_unit(context) / double(tile.x)));
    }

    void draw(RenderContext& context, const gpu::Program& program, const gpu::DrawState& state) const {
        context.scene.draw_surfaces(
            framework::ObjectSelection(objects_.value()), program, state,
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
    std::shared_ptr<const gpu::Program> depth_only_;
};

}  // namespace

std::unique_ptr<framework::Component> make_hatch(const Pass& pass) { return std::make_unique<Hatch>(pass); }

}  // namespace croquis::components
