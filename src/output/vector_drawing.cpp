#include "output/vector_drawing.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "lines/stroke_mesh.h"
#include "lines/strokes.h"
#include "output/plotter.h"

namespace croquis::output {
namespace {

using lines::LineClass;
using lines::Stroke;
using lines::StrokePoint;

// What is painted first comes first: lines behind most layers, then visible ones, outlines last.
struct GroupKey {
    std::uint32_t front = 0;  // 0 to 2: behind 3 and more, 2, 1 layers; 3: visible
    std::uint32_t class_order = 0;
    std::uint32_t mesh = 0;
    bool operator<(const GroupKey& other) const {
        return std::tie(front, class_order, mesh) < std::tie(other.front, other.class_order, other.mesh);
    }
};

constexpr std::uint32_t visible_front = 3;

GroupKey key_of(const lines::Line& line, DrawnLines::Hidden hidden) {
    GroupKey key;
    const std::uint32_t most_layers = hidden == DrawnLines::Hidden::by_layers ? visible_front : 1;
    key.front = visible_front - std::min(line.layers, most_layers);
    key.class_order = std::uint32_t(lines::line_class_count) - 1 - std::uint32_t(line.line_class);
    key.mesh = line.mesh;
    return key;
}

std::string front_name(std::uint32_t front, DrawnLines::Hidden hidden) {
    if (front == visible_front) return "visible";
    return hidden == DrawnLines::Hidden::by_layers ? "hidden-" + std::to_string(visible_front - front) : "hidden";
}

std::string class_name(const GroupKey& key) {
    const auto line_class = LineClass(lines::line_class_count - 1 - key.class_order);
    return std::string(lines::info_of(line_class).name);
}

Ring spine_of(const DrawnLines& drawn, const Stroke& stroke, const Sheet& sheet) {
    Ring ring;
    ring.closed = stroke.closed;
    for (const StrokePoint& point : drawn.strokes.points_of(stroke)) ring.points.push_back(sheet.place(point.position));
    return ring;
}

// Adds a spine to a path as the drawing has it: a curve that keeps near to the points in the pixels of the frame, or
// the points themselves.
void add_spine(Ring&& spine, const DrawnLines& drawn, const Sheet& sheet, VectorPath& path) {
    if (drawn.spines == DrawnLines::Spines::polylines) {
        path.rings.push_back(std::move(spine));
        return;
    }
    CurveLimits limits;
    limits.tolerance *= sheet.mm_per_pixel;
    limits.bulge *= sheet.mm_per_pixel;
    path.curves.push_back(fit_curve(spine.points, spine.closed, limits));
}

// Colours that no eye tells apart, and opacities that files write alike, are one.
glm::vec4 rounded(const glm::vec4& color) {
    const auto level = [](float channel, float levels) { return std::round(channel * levels) / levels; };
    return {level(color.x, 255), level(color.y, 255), level(color.z, 255), level(color.w, 1000)};
}

Ink pen_ink(const StrokePoint& point, const lines::Brush& brush, const Sheet& sheet) {
    return {.kind = Ink::Kind::stroke,
            .width = std::round(double(point.width) * sheet.mm_per_pixel * 1000) / 1000,
            .color = rounded(point.color),
            .round_ends = brush.ends == lines::StrokeEnds::round};
}

// Pieces of a stroke of nearly one colour each, as filled outlines.
class Areas {
public:
    Areas(const lines::Strokes& strokes, const Stroke& stroke, const Sheet& sheet)
        : points_(strokes.points_of(stroke)), stroke_(stroke), sheet_(sheet), brush_(strokes.brushes[stroke.brush]) {}

    std::vector<VectorPath> paths() {
        std::vector<VectorPath> found;
        if (color_run_end(0) + 1 >= points_.size()) {
            found.push_back(area(0, points_.size(), stroke_.closed));
            return found;
        }
        std::size_t begin = 0;
        while (begin + 1 < points_.size()) {
            const std::size_t end = color_run_end(begin);
            found.push_back(area(begin, end + 1, false));
            begin = end;
        }
        if (stroke_.closed) found.push_back(closing_area());
        return found;
    }

private:
    // The last point up to which the colour stays within a step that hardly shows.
    [[nodiscard]] std::size_t color_run_end(std::size_t begin) const {
        constexpr float step = 1.0f / 24.0f;
        std::size_t end = begin + 1;
        while (end < points_.size()) {
            const glm::vec4 change = points_[end].color - points_[begin].color;
            const float most =
                std::max({std::abs(change.x), std::abs(change.y), std::abs(change.z), std::abs(change.w)});
            if (most > step) break;
            ++end;
        }
        return std::max(begin + 1, end - 1);
    }

    [[nodiscard]] VectorPath area(std::size_t begin, std::size_t end, bool closed) const {
        return area_of({points_.begin() + std::ptrdiff_t(begin), points_.begin() + std::ptrdiff_t(end)}, closed);
    }

    [[nodiscard]] VectorPath closing_area() const { return area_of({points_.back(), points_.front()}, false); }

    [[nodiscard]] VectorPath area_of(std::vector<StrokePoint> points, bool closed) const {
        glm::vec4 color(0.0f);
        for (const StrokePoint& point : points) color += point.color / float(points.size());
        lines::Strokes one;
        one.points = std::move(points);
        one.brushes.assign(1, brush_);
        one.strokes.push_back({0, closed, 0, std::uint32_t(one.points.size()), 0});
        VectorPath path;
        path.ink = Ink{.kind = Ink::Kind::fill, .width = 0, .color = rounded(color)};
        for (const lines::Ring& outline : lines::outline_of(one, one.strokes.front())) {
            Ring ring;
            ring.closed = true;
            for (const glm::dvec2& point : outline) ring.points.push_back(sheet_.place(point));
            path.rings.push_back(std::move(ring));
        }
        return path;
    }

    std::span<const StrokePoint> points_;
    const Stroke& stroke_;
    const Sheet& sheet_;
    const lines::Brush& brush_;
};

// Dashes of one line are one path.
void add(VectorGroup& group, const DrawnLines& drawn, const Stroke& stroke, const Sheet& sheet,
         std::uint32_t& last_line) {
    const std::span<const StrokePoint> points = drawn.strokes.points_of(stroke);
    if (points.size() < 2) return;
    if (!lines::is_even(drawn.strokes, stroke)) {
        for (VectorPath& path : Areas(drawn.strokes, stroke, sheet).paths()) group.paths.push_back(std::move(path));
        last_line = 0xffffffffu;
        return;
    }
    const Ink ink = pen_ink(points.front(), drawn.strokes.brushes[stroke.brush], sheet);
    if (!group.ink) group.ink = ink;
    const bool goes_on = last_line == stroke.line && !group.paths.empty() && !stroke.closed &&
                         group.paths.back().ink.value_or(*group.ink) == ink;
    if (!goes_on) {
        group.paths.emplace_back();
        if (*group.ink != ink) group.paths.back().ink = ink;
    }
    add_spine(spine_of(drawn, stroke, sheet), drawn, sheet, group.paths.back());
    last_line = stroke.line;
}

}  // namespace

std::vector<VectorGroup> groups_of(const DrawnLines& drawn, std::uint32_t view, const Sheet& sheet, NameGiver& names) {
    std::map<GroupKey, VectorGroup> by_key;
    std::map<GroupKey, std::uint32_t> last_lines;
    for (const Stroke& stroke : drawn.strokes.strokes) {
        if (!drawn.views.empty() && drawn.view_of_line[stroke.line] != view) continue;
        const GroupKey key = key_of(drawn.drawing.lines[stroke.line], drawn.hidden);
        add(by_key[key], drawn, stroke, sheet, last_lines.try_emplace(key, 0xffffffffu).first->second);
    }
    const std::string prefix = drawn.views.empty() ? "" : drawn.views[view] + "-";
    std::vector<VectorGroup> fronts;
    std::uint32_t front = 0xffffffffu, class_order = 0xffffffffu;
    for (auto& [key, group] : by_key) {
        const std::string front_id = prefix + front_name(key.front, drawn.hidden);
        const std::string class_id = front_id + "-" + class_name(key);
        if (key.front != front) {
            fronts.emplace_back().id = names.name(front_id);
            class_order = 0xffffffffu;
        }
        if (key.class_order != class_order) fronts.back().groups.emplace_back().id = names.name(class_id);
        front = key.front;
        class_order = key.class_order;
        const std::string& mesh = drawn.meshes[key.mesh];
        group.id = names.name(class_id, mesh);
        if (group.id != class_id + "-" + mesh) group.title = mesh;
        fronts.back().groups.back().groups.push_back(std::move(group));
    }
    return fronts;
}

std::vector<VectorGroup> pens_of(const DrawnLines& drawn, const Sheet& sheet, NameGiver& names) {
    std::map<double, std::vector<Ring>, std::greater<>> rings_by_width;
    for (const Stroke& stroke : drawn.strokes.strokes) {
        const std::span<const StrokePoint> points = drawn.strokes.points_of(stroke);
        if (points.size() < 2) continue;
        // A pen has one width: a stroke's is that of its widest point, in steps of hundredths.
        float widest = 0;
        for (const StrokePoint& point : points) widest = std::max(widest, point.width);
        const double width = std::max(0.01, std::round(double(widest) * sheet.mm_per_pixel * 100) / 100);
        rings_by_width[width].push_back(spine_of(drawn, stroke, sheet));
    }
    std::vector<VectorGroup> pens;
    glm::dvec2 place(0.0);
    for (auto& [width, rings] : rings_by_width) {
        VectorGroup pen;
        pen.id = names.name("pen-" + number_text(width) + "mm");
        pen.layer = std::to_string(pens.size() + 1) + " pen " + number_text(width) + " mm";
        pen.ink = Ink{.width = width};
        for (Ring& ring : plan_pen(std::move(rings), place)) {
            place = end_of(ring);
            add_spine(std::move(ring), drawn, sheet, pen.paths.emplace_back());
        }
        pens.push_back(std::move(pen));
    }
    return pens;
}

}  // namespace croquis::output
