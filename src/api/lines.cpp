// From a model to a drawing in lines: the public face of src/lines.
#include "croquis/lines.h"

#include <chrono>
#include <utility>

#include "api/lines_state.h"
#include "api/view_request.h"
#include "base/error.h"
#include "base/log.h"
#include "base/names.h"
#include "lines/drafter.h"
#include "model/animation.h"

namespace croquis {
namespace {

constexpr int longest_side = 1 << 16;

double milliseconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

lines::Visibility visibility_named(const std::string& name) {
    using lines::Visibility;
    const std::pair<const char*, Visibility> known[] = {{"automatic", Visibility::automatic},
                                                        {"quantitative", Visibility::quantitative},
                                                        {"walking", Visibility::walking},
                                                        {"ray_cast", Visibility::ray_cast},
                                                        {"none", Visibility::none}};
    std::vector<std::string> names;
    for (const auto& [word, visibility] : known) {
        if (name == word) return visibility;
        names.emplace_back(word);
    }
    fail("expected the visibility to be automatic, quantitative, walking, ray_cast or none, found \"{}\"{}", name,
         suggestion(name, names));
}

lines::Options drafter_options(const LineOptions& asked) {
    if (!(asked.crease_angle >= 0 && asked.crease_angle <= 180)) {
        fail("expected the crease angle to be 0 to 180 degrees, found {:g}", asked.crease_angle);
    }
    lines::Options options;
    if (!asked.classes.empty()) options.classes = {};
    for (const std::string& name : asked.classes) options.classes.add(lines::line_class_named(name));
    options.crease_angle = asked.crease_angle * radians_per_degree;
    options.hidden = asked.hidden;
    options.visibility = visibility_named(asked.visibility);
    options.finder = asked.finder;
    options.clean = asked.clean;
    options.seed = asked.seed;
    return options;
}

void check_size(const LineOptions& options) {
    if (options.width < 1 || options.height < 1 || options.width > longest_side || options.height > longest_side) {
        fail("expected a size of 1x1 to {}x{} pixels, found {}x{}", longest_side, longest_side, options.width,
             options.height);
    }
}

// Appends a view's lines of some classes, moved to where the view lies in the frame. A silhouette that was looked at as
// a possible contour, and is none, may not have been asked for.
void append(lines::Drawing& all, const lines::Drawing& view, const lines::LineClasses& classes,
            const glm::dvec2& corner) {
    const auto moved_by = static_cast<std::uint32_t>(all.points.size());
    for (lines::Line line : view.lines) {
        if (!classes.has(line.line_class)) continue;
        line.first_point += moved_by;
        all.lines.push_back(line);
    }
    for (lines::LinePoint point : view.points) {
        point.position += corner;
        all.points.push_back(point);
    }
}

std::vector<std::string> mesh_names_of(const model::Model& model) {
    std::vector<std::string> names;
    for (const model::Mesh& mesh : model.meshes) {
        names.push_back(mesh.name.empty() ? fmt::format("mesh{}", names.size() + 1) : mesh.name);
    }
    return names;
}

void add(LineReport& report, const lines::Report& one) {
    report.find += one.find;
    report.visibility += one.visibility;
    report.chain += one.chain;
    report.silhouette_edges += one.silhouette_edges;
    report.clusters += one.clusters;
}

}  // namespace

std::vector<LineClass> line_classes() {
    std::vector<LineClass> classes;
    for (const lines::LineClassInfo& info : lines::line_class_infos()) {
        classes.push_back({std::string(info.name), info.width_mm, std::string(info.help)});
    }
    return classes;
}

LineDrawing draw_lines(const Model& model, const LineOptions& options) {
    check_size(options);
    const lines::Options find = drafter_options(options);
    const auto state = std::make_shared<LineDrawing::State>();
    const std::shared_ptr<const model::Model>& source = model.model_;
    model::Pose pose;
    if (!options.animation.empty()) {
        pose = model::pose_at(*source, model::find_clip(*source, options.animation), options.time);
    }
    const model::Pose* posed = options.animation.empty() ? nullptr : &pose;

    const auto start = std::chrono::steady_clock::now();
    state->surface = std::make_shared<const lines::Surface>(source, posed);
    state->report.adjacency = milliseconds_since(start);
    state->views = place_views(*state->surface, posed, options);
    const auto before_drafter = std::chrono::steady_clock::now();
    lines::Drafter drafter(state->surface, find);
    state->report.prepare = milliseconds_since(before_drafter);

    state->drawing.width = options.width;
    state->drawing.height = options.height;
    for (std::uint32_t v = 0; v < state->views.size(); ++v) {
        append(state->drawing, drafter.draw(state->views[v].viewpoint), find.classes, state->views[v].corner);
        state->view_of_line.resize(state->drawing.lines.size(), v);
        add(state->report, drafter.report());
    }
    state->mesh_names = mesh_names_of(*source);
    state->file_units = model::SceneSpace::of(*source).radius;
    state->seed = options.seed;
    state->is_clean = options.clean;
    state->report.triangles = state->surface->face_count();
    state->report.lines = state->drawing.lines.size();
    for (const lines::Line& line : state->drawing.lines) state->report.points += line.point_count;
    if (state->drawing.lines.empty()) warn("{}: no line lies in the frame: the drawing is empty", source->name);
    return LineDrawing(state);
}

int LineDrawing::width() const { return int(state_->drawing.width); }
int LineDrawing::height() const { return int(state_->drawing.height); }
const LineReport& LineDrawing::report() const { return state_->report; }

std::vector<LinePath> LineDrawing::paths() const {
    const lines::Drawing& drawing = state_->drawing;
    std::vector<LinePath> paths;
    paths.reserve(drawing.lines.size());
    for (std::size_t l = 0; l < drawing.lines.size(); ++l) {
        const lines::Line& line = drawing.lines[l];
        LinePath path;
        path.line_class = lines::info_of(line.line_class).name;
        path.mesh = state_->mesh_names[line.mesh];
        path.view = state_->views[state_->view_of_line[l]].name;
        path.layers = int(line.layers);
        path.closed = line.closed;
        for (const lines::LinePoint& point : drawing.points_of(line)) {
            path.points.push_back({point.position.x, point.position.y, point.depth * state_->file_units});
        }
        paths.push_back(std::move(path));
    }
    return paths;
}

}  // namespace croquis
