// lines: the model's lines as strokes. They are found, decided and made into strokes on other threads while earlier
// passes draw (seed E, 10.5), and uploaded only when view, model or a variable changed.
#include <tbb/task_group.h>

#include <map>
#include <optional>
#include <utility>

#include "components/blend_modes.h"
#include "components/line_settings.h"
#include "components/stroke_geometry.h"
#include "framework/component.h"
#include "framework/render_context.h"

namespace croquis::components {
namespace {

using framework::Pass;
using framework::RenderContext;
using framework::Variable;

// Work on another thread, at most one at a time. What goes wrong in it is thrown to whoever waits for it.
class WorkBeside {
public:
    WorkBeside() = default;
    WorkBeside(const WorkBeside&) = delete;
    WorkBeside& operator=(const WorkBeside&) = delete;
    ~WorkBeside() noexcept { forget(); }  // which leaves the group nothing to throw about

    template <typename Work>
    void start(Work work) {
        forget();
        runs_ = true;
        group_.run(std::move(work));
    }

    void wait() {
        if (std::exchange(runs_, false)) group_.wait();
    }

    // Waits for work that nobody wants any more.
    void forget() noexcept {
        try {
            wait();
        } catch (...) {  // a mistake in it is of no interest now
        }
    }

private:
    tbb::task_group group_;
    bool runs_ = false;
};

// All that the strokes of a frame depend on.
struct Subject {
    std::shared_ptr<const model::Model> model;
    std::shared_ptr<const model::Pose> pose;
    lines::Viewpoint view;
    glm::vec4 light{};
    int pixel_scale = 1;
    std::uint64_t seed = 0;
    std::shared_ptr<const LineSettings> settings;
    std::string objects;

    bool operator==(const Subject&) const = default;

    [[nodiscard]] static Subject of(const RenderContext& context, std::shared_ptr<const LineSettings> settings,
                                    const std::string& objects) {
        const double scale = context.pixel_scale;
        return {context.scene.shared_model(),
                context.scene.shared_pose(),
                lines::Viewpoint::of(context.camera, context.frame.width() / scale, context.frame.height() / scale),
                context.light_in_scene(),
                context.pixel_scale,
                context.seed,
                std::move(settings),
                objects};
    }
};

// From a subject to triangles; keeps what does not change from one to the next. Knows nothing of the GPU, so that any
// thread may run it.
class StrokeMaker {
public:
    [[nodiscard]] StrokeTriangles make(const Subject& subject, const lines::TextureAspect& aspect) {
        update_drafter(subject);
        lines::Drawing drawing = drafter_->draw(subject.view);
        leave_out(subject, drawing);
        line_count_ = drawing.lines.size();
        lines::StrokeOptions options = subject.settings->strokes;
        options.light = glm::vec3(subject.light);  // of a point light: as the model's centre sees it
        options.seed = subject.seed;
        return triangles_of(lines::make_strokes(drawing, options), float(subject.pixel_scale), aspect);
    }

    /// Of the last drawing.
    [[nodiscard]] std::size_t line_count() const { return line_count_; }

private:
    void update_drafter(const Subject& subject) {
        const bool same_surface = surface_ && subject.model.get() == &surface_->model() && subject.pose == pose_;
        if (!same_surface) {
            drafter_.reset();
            surface_ = std::make_shared<const lines::Surface>(subject.model, subject.pose.get());
            pose_ = subject.pose;
        }
        lines::Options options = subject.settings->find;
        options.seed = subject.seed;
        if (!drafter_ || drafter_->options() != options) drafter_.emplace(surface_, options);
    }

    // Lines of objects that the pass does not show; they still hide others.
    static void leave_out(const Subject& subject, lines::Drawing& drawing) {
        const framework::ObjectSelection selection(subject.objects);
        std::vector<bool> shown;
        for (const model::Mesh& mesh : subject.model->meshes) shown.push_back(selection.includes(*subject.model, mesh));
        std::erase_if(drawing.lines, [&](const lines::Line& line) { return !shown[line.mesh]; });
    }

    std::shared_ptr<const lines::Surface> surface_;
    std::shared_ptr<const model::Pose> pose_;
    std::optional<lines::Drafter> drafter_;
    std::size_t line_count_ = 0;
};

class Lines final : public framework::Component {
public:
    explicit Lines(const Pass& pass)
        : Component(pass),
          keep_color_(pass.variable<bool>("keep_color")),
          clear_color_(pass.variable<glm::vec3>("clear_color")),
          blend_(pass.variable<std::string>("blend")),
          objects_(pass.variable<std::string>("objects")),
          even_ink_(pass.resources().program("strokes:stroke_corner", "strokes:even_ink")) {
        read_settings();
    }

    void variable_changed(std::string_view) override { read_settings(); }

protected:
    void prepare(RenderContext& context) override {
        Subject now = Subject::of(context, settings_, objects_.value());
        if (subject_ == now) return;
        work_.forget();
        subject_ = std::move(now);
        is_uploaded_ = false;
        work_.start([this, aspect = aspects()] { triangles_ = maker_.make(*subject_, aspect); });
    }

    void render(RenderContext& context) override {
        if (!is_uploaded_) take_strokes(context);
        if (!keep_color_.value()) context.clear_frame(clear_color_.value());
        context.frame.bind();
        const gpu::Blend blend = blend_named(blend_.value());
        gpu::apply({.blend = blend == gpu::Blend::over ? gpu::Blend::over_premultiplied : blend});
        for (const StrokePart& part : triangles_.parts) draw(context, part);
    }

    [[nodiscard]] std::size_t lines_drawn() const override { return line_count_; }

private:
    // A set of settings is never changed, for another thread may be reading it.
    void read_settings() {
        auto settings = std::make_shared<const LineSettings>(LineSettings::of(pass_));
        find_textures(settings->strokes.styles);
        settings_ = std::move(settings);
    }

    void find_textures(const lines::StyleSet& styles) {
        std::map<std::string, std::shared_ptr<const gpu::Texture>, std::less<>> found;
        const auto add = [&](const lines::StrokeStyle& style) {
            if (style.texture.empty()) return;
            framework::TextureName name;
            name.directory = "strokes";
            name.image = style.texture;
            found[style.texture] = pass_.resources().image(name);
        };
        for (const lines::StrokeStyle& style : styles.visible) add(style);
        for (const lines::StrokeStyle& style : styles.hidden) add(style);
        textures_ = std::move(found);
        if (!textures_.empty() && !textured_ink_) {
            textured_ink_ = pass_.resources().program("strokes:stroke_corner", "strokes:textured_ink");
        }
    }

    // Width over height of the images, without the images.
    [[nodiscard]] lines::TextureAspect aspects() const {
        std::map<std::string, double, std::less<>> known;
        for (const auto& [name, texture] : textures_) known[name] = double(texture->width()) / texture->height();
        return [known](const std::string& name) { return known.at(name); };
    }

    void take_strokes(RenderContext& context) {
        try {
            work_.wait();
        } catch (...) {
            subject_.reset();  // the next frame tries again
            throw;
        }
        line_count_ = maker_.line_count();
        geometry_ = components::upload(context.resources.gpu(), triangles_);
        triangles_.corners = {};
        triangles_.indices = {};
        is_uploaded_ = true;
    }

    void draw(const RenderContext& context, const StrokePart& part) const {
        const bool is_textured = !part.texture.empty();
        const gpu::Program& program = is_textured ? *textured_ink_ : *even_ink_;
        program.use();
        program.set("frame_size", glm::vec2(context.frame.width(), context.frame.height()));
        if (is_textured) {
            textures_.at(part.texture)->bind(0);
            program.set("stroke_sampler", 0);
        }
        geometry_->draw(part.first_index, part.index_count);
    }

    Variable<bool> keep_color_;
    Variable<glm::vec3> clear_color_;
    Variable<std::string> blend_;
    Variable<std::string> objects_;
    std::shared_ptr<const gpu::Program> even_ink_;
    std::shared_ptr<const gpu::Program> textured_ink_;  // where a style has a texture
    std::map<std::string, std::shared_ptr<const gpu::Texture>, std::less<>> textures_;
    std::shared_ptr<const LineSettings> settings_;
    std::optional<Subject> subject_;  // what the triangles show
    bool is_uploaded_ = false;
    std::unique_ptr<gpu::Geometry> geometry_;
    std::size_t line_count_ = 0;

    // The other thread's, until it was waited for. The work goes first when all this goes: it uses the others.
    StrokeMaker maker_;
    StrokeTriangles triangles_;
    WorkBeside work_;
};

}  // namespace

std::unique_ptr<framework::Component> make_lines(const Pass& pass) { return std::make_unique<Lines>(pass); }

}  // namespace croquis::components
