// outline: silhouettes as quads along the surface's edges, over the surfaces that the frame holds. Seed A, 3.4 and
// 3.6.3; seed B, chapter 4, algorithms 1-3; seed E, 10.3.1 and 10.4.
#include <bit>
#include <glm/trigonometric.hpp>
#include <optional>

#include "components/occluder.h"
#include "components/outline_edges.h"
#include "components/outline_vertices.h"
#include "framework/component.h"
#include "framework/render_context.h"

namespace croquis::components {
namespace {

using framework::Pass;
using framework::RenderContext;
using framework::Variable;

enum class Method { front_face, stencil, halo, stencil_lines, ink };

Method method_named(const std::string& name) {
    if (name == "stencil") return Method::stencil;
    if (name == "halo") return Method::halo;
    if (name == "stencil_lines") return Method::stencil_lines;
    if (name == "ink") return Method::ink;
    return Method::front_face;
}

// All that the lines of a frame depend on.
struct Subject {
    std::shared_ptr<const model::Model> model;
    std::shared_ptr<const model::Pose> pose;
    lines::Viewpoint view;
    std::uint64_t seed = 0;
    int revision = 0;  // of the pass's variables

    bool operator==(const Subject&) const = default;
};

// Lines on the GPU: the four corners of each hold all of it, for the software renderer takes as long to begin an
// instance as to draw it.
class LineBuffer {
public:
    void upload(gpu::Context& context, const std::vector<OutlineEdge>& edges) {
        std::vector<OutlineEdge> corners;
        corners.reserve(4 * edges.size());
        for (const OutlineEdge& edge : edges) corners.insert(corners.end(), 4, edge);
        lines_ = edges.size();
        if (geometry_ && lines_ <= capacity_) return geometry_->update(0, std::as_bytes(std::span(corners)));
        capacity_ = std::bit_ceil(lines_);
        make_geometry(context, corners);
    }

    void draw() const {
        if (lines_ > 0) geometry_->draw(0, 6 * lines_);
    }

private:
    void make_geometry(gpu::Context& context, const std::vector<OutlineEdge>& corners) {
        std::vector<std::uint32_t> triangles;
        for (std::uint32_t first = 0; first < 4 * capacity_; first += 4) {
            for (const std::uint32_t corner : {0u, 1u, 2u, 2u, 1u, 3u}) triangles.push_back(first + corner);
        }
        using Kind = gpu::Attribute::Kind;
        const gpu::VertexBuffer buffer{std::as_bytes(std::span(corners)),
                                       sizeof(OutlineEdge),
                                       {{0, 3, Kind::floats, offsetof(OutlineEdge, start)},
                                        {1, 3, Kind::floats, offsetof(OutlineEdge, end)},
                                        {2, 3, Kind::floats, offsetof(OutlineEdge, inside)},
                                        {3, 4, Kind::bytes_to_unit, offsetof(OutlineEdge, start_color)},
                                        {4, 4, Kind::bytes_to_unit, offsetof(OutlineEdge, end_color)}}};
        geometry_ = std::make_unique<gpu::Geometry>(context, std::span(&buffer, 1), triangles);
    }

    std::unique_ptr<gpu::Geometry> geometry_;
    std::size_t lines_ = 0;
    std::size_t capacity_ = 0;  // lines that the indices reach
};

// What a draw of the lines asks of the shader besides the frame.
struct Stroke {
    float width = 1;
    bool only_outside = true;
    float towards_eye = 0;         // scene units
    float widths_towards_eye = 0;  // the line's own widths
};

class Outline final : public framework::Component {
public:
    explicit Outline(const Pass& pass)
        : Component(pass),
          method_(pass.variable<std::string>("method")),
          width_(pass.variable<float>("width")),
          boundary_width_(pass.variable<float>("boundary_width")),
          inner_width_(pass.variable<float>("inner_width")),
          crease_angle_(pass.variable<float>("crease_angle")),
          shortest_(pass.variable<float>("shortest")),
          width_unit_(pass.variable<std::string>("width_unit")),
          colors_(pass.variable<std::string>("colors")),
          color_(pass.variable<glm::vec3>("color")),
          darkening_(pass.variable<float>("darkening")),
          halo_depth_(pass.variable<float>("halo_depth")),
          offset_(pass.variable<float>("offset")),
          grain_(pass.variable<float>("grain")),
          occlude_(pass.variable<bool>("occlude")),
          occluder_scale_(pass.variable<float>("occluder_scale")),
          keep_color_(pass.variable<bool>("keep_color")),
          keep_depth_(pass.variable<bool>("keep_depth")),
          clear_color_(pass.variable<glm::vec3>("clear_color")),
          objects_(pass.variable<std::string>("objects")),
          lines_(pass.resources().program("outline:outline_corner", "outline:outline")),
          whole_pixels_(pass.resources().program("outline:outline_corner", "outline:whole_pixels")),
          occluder_(pass.resources()) {}

protected:
    void render(RenderContext& context) override {
        update_lines(context);
        if (!keep_depth_.value()) context.frame.clear_depth();
        if (!keep_color_.value()) context.clear_frame(clear_color_.value());
        context.frame.bind();
        if (occlude_.value()) {
            occluder_.fill_depth(context, framework::ObjectSelection(objects_.value()),
                                 {.scale = occluder_scale_.value(), .inset = ink_reach()});
        }
        draw_lines(context);
    }

private:
    // Lines lie a hair behind where they are, so that the surface covers what of them reaches over it.
    static constexpr float behind_surface = -2e-4f;
    // And those that are to show on it, so many of their widths before it: surfaces may slope as much beside them.
    static constexpr float widths_before_surface = 1.5f;

    // How far lines in ink are off the surface, which must not swallow them: where it is round it is drawn in by as
    // much, where it is flat the lines are drawn before it.
    [[nodiscard]] float ink_reach() const {
        return method_named(method_.value()) == Method::ink ? offset_.value() : 0.0f;
    }

    void draw_lines(RenderContext& context) {
        constexpr gpu::DrawState ink{.depth_test = gpu::DepthTest::nearer_or_equal, .blend = gpu::Blend::over};
        gpu::DrawState outside = ink;
        outside.stencil = gpu::Stencil::outside_surfaces;
        const float width = width_.value();
        switch (method_named(method_.value())) {
            case Method::front_face:
                draw(context, *lines_, found_, ink, {width, true, behind_surface});
                break;
            case Method::stencil:
                draw(context, *lines_, found_, outside, {width, true, 0});
                break;
            case Method::halo:
                draw(context, *lines_, found_, ink, {width, true, -halo_depth_.value()});
                break;
            case Method::ink:
                draw(context, *lines_, found_, ink, {width, false, 2 * ink_reach()});
                break;
            case Method::stencil_lines:
                draw_through_stencil(context, ink);
                break;
        }
        if (inner_width_.value() > 0) {
            draw(context, *lines_, inner_, ink, {inner_width_.value(), false, 0, widths_before_surface});
        }
        if (boundary_width_.value() > 0) {
            draw(context, *lines_, found_, outside, {boundary_width_.value(), true, 0});
        }
    }

    // Seed E, 10.3.1: front faces in line mode only mark the stencil; back faces in line mode are drawn where it is
    // marked, and take the mark away.
    void draw_through_stencil(RenderContext& context, gpu::DrawState state) {
        const Stroke stroke{width_.value(), false, 0, widths_before_surface};
        context.frame.clear_line_marks();
        gpu::DrawState mark = state;
        mark.write_color = false;
        mark.blend = gpu::Blend::off;
        mark.stencil = gpu::Stencil::mark_line;
        draw(context, *whole_pixels_, of_front_faces_, mark, stroke);
        state.stencil = gpu::Stencil::take_line_mark;
        draw(context, *whole_pixels_, of_back_faces_, state, stroke);
    }

    void draw(const RenderContext& context, const gpu::Program& program, const LineBuffer& lines,
              const gpu::DrawState& state, const Stroke& stroke) const {
        const glm::mat4 projection = context.camera.clip_from_eye(context.aspect());
        const bool in_model_units = width_unit_.value() == "model";
        constexpr float hundredth = 0.01f;  // of the model's radius, the unit of scene space
        program.use();
        context.apply(program);
        program.set("line_width", in_model_units ? hundredth * stroke.width : stroke.width);
        program.set("in_model_units", in_model_units);
        program.set("only_outside", stroke.only_outside);
        program.set("towards_eye", stroke.towards_eye);
        program.set("widths_towards_eye", stroke.widths_towards_eye);
        program.set("depth_terms", glm::vec2(projection[2][2], projection[3][2]));
        gpu::apply(state);
        lines.draw();
    }

    void update_lines(RenderContext& context) {
        const double scale = context.pixel_scale;
        Subject now{context.scene.shared_model(), context.scene.shared_pose(),
                    lines::Viewpoint::of(context.camera, context.frame.width() / scale, context.frame.height() / scale),
                    context.seed, pass_.revision()};
        if (subject_ == now) return;
        if (!edges_ || subject_->model != now.model || subject_->pose != now.pose) {
            edges_.reset();
            edges_.emplace(std::make_shared<const lines::Surface>(now.model, now.pose.get()));
        }
        if (!subject_ || subject_->model != now.model || subject_->revision != now.revision ||
            subject_->seed != now.seed) {
            update_choices(*now.model, now.seed);
        }
        if (inner_width_.value() > 0 && (!subject_ || subject_->pose != now.pose || subject_->model != now.model ||
                                         subject_->revision != now.revision)) {
            inner_edges_ = edges_->inner_edges(glm::radians(double(crease_angle_.value())), shown_);
        }
        subject_ = std::move(now);
        find_lines(context);
    }

    // What depends on neither view nor pose.
    void update_choices(const model::Model& model, std::uint64_t seed) {
        const framework::ObjectSelection selection(objects_.value());
        shown_.clear();
        for (const model::Mesh& mesh : model.meshes) shown_.push_back(selection.includes(model, mesh));
        own_colors_.clear();
        offsets_.clear();
        if (colors_.value() == "own") own_colors_ = own_line_colors(model, darkening_.value());
        if (method_named(method_.value()) == Method::ink) {
            offsets_ = ink_offsets(model, offset_.value(), grain_.value(), seed);
        }
    }

    [[nodiscard]] bool finds_contours() const {
        return method_named(method_.value()) != Method::stencil_lines || boundary_width_.value() > 0;
    }

    void find_lines(RenderContext& context) {
        gpu::Context& gpu = context.resources.gpu();
        const lines::Viewpoint& view = subject_->view;
        using Facing = OutlineEdges::Facing;
        if (method_named(method_.value()) == Method::stencil_lines) {
            of_front_faces_.upload(gpu, lines_along(edges_->edges_of_faces(view, Facing::front, shown_)));
            of_back_faces_.upload(gpu, lines_along(edges_->edges_of_faces(view, Facing::back, shown_)));
        }
        const auto upload = [&](LineBuffer& buffer, const std::vector<EdgeWithFace>& lines) {
            buffer.upload(gpu, lines_along(edges_->without_specks(lines, view, shortest_.value())));
        };
        if (finds_contours()) upload(found_, edges_->contours(view, shown_));
        if (inner_width_.value() > 0) upload(inner_, inner_edges_);
    }

    // One line an edge; in ink three, their offsets' components in turn (seed B, algorithm 3).
    [[nodiscard]] std::vector<OutlineEdge> lines_along(const std::vector<EdgeWithFace>& edges) const {
        const int copies = offsets_.empty() ? 1 : 3;
        std::vector<OutlineEdge> lines;
        lines.reserve(edges.size() * std::size_t(copies));
        for (int copy = 0; copy < copies; ++copy) {
            for (const EdgeWithFace& edge : edges) {
                const auto& [a, b] = edges_->surface().topology().edges[edge.edge].vertices;
                lines.push_back({point(a, copy), point(b, copy), point(edge.inside, copy), ink(a), ink(b)});
            }
        }
        return lines;
    }

    [[nodiscard]] glm::vec3 point(std::uint32_t vertex, int copy) const {
        const glm::vec3 place(edges_->surface().point(vertex));
        if (offsets_.empty()) return place;
        const glm::vec3& offset = offsets_[vertex];
        return place + glm::vec3(offset[copy], offset[(copy + 1) % 3], offset[(copy + 2) % 3]);
    }

    [[nodiscard]] glm::u8vec4 ink(std::uint32_t vertex) const {
        if (!own_colors_.empty()) return own_colors_[vertex];
        return glm::u8vec4(glm::u8vec3(color_.value() * 255.0f + 0.5f), 255);
    }

    Variable<std::string> method_;
    Variable<float> width_;
    Variable<float> boundary_width_;
    Variable<float> inner_width_;
    Variable<float> crease_angle_;
    Variable<float> shortest_;
    Variable<std::string> width_unit_;
    Variable<std::string> colors_;
    Variable<glm::vec3> color_;
    Variable<float> darkening_;
    Variable<float> halo_depth_;
    Variable<float> offset_;
    Variable<float> grain_;
    Variable<bool> occlude_;
    Variable<float> occluder_scale_;
    Variable<bool> keep_color_;
    Variable<bool> keep_depth_;
    Variable<glm::vec3> clear_color_;
    Variable<std::string> objects_;
    std::shared_ptr<const gpu::Program> lines_;
    std::shared_ptr<const gpu::Program> whole_pixels_;
    Occluder occluder_;

    std::optional<Subject> subject_;  // what the buffers show
    std::optional<OutlineEdges> edges_;
    std::vector<bool> shown_;                // one a mesh
    std::vector<EdgeWithFace> inner_edges_;  // of this surface, in all views
    std::vector<glm::u8vec4> own_colors_;    // one a vertex of the topology; empty for lines of one colour
    std::vector<glm::vec3> offsets_;         // the same; empty but for method ink
    LineBuffer found_, inner_, of_front_faces_, of_back_faces_;
};

}  // namespace

std::unique_ptr<framework::Component> make_outline(const Pass& pass) { return std::make_unique<Outline>(pass); }

}  // namespace croquis::components
