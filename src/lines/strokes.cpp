#include "lines/strokes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

#include "base/parallel.h"
#include "lines/stroke_corners.h"
#include "lines/stroke_pen.h"

namespace croquis::lines {
namespace {

constexpr std::size_t lines_a_piece = 128;  // of work
constexpr double corner_reach = 4;          // pixels of the style to both sides of a corner
constexpr double longest_line = 1e6;        // pixels from the frame's corner: no frame is as large

// The order of painting: lines behind most layers first, then the least of the classes.
std::vector<std::uint32_t> painting_order(const Drawing& drawing, bool hidden) {
    std::vector<std::uint32_t> order;
    order.reserve(drawing.lines.size());
    for (std::uint32_t i = 0; i < drawing.lines.size(); ++i) {
        if (hidden || drawing.lines[i].visible()) order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        const Line &first = drawing.lines[a], &second = drawing.lines[b];
        return first.layers != second.layers ? first.layers > second.layers : first.line_class > second.line_class;
    });
    return order;
}

DepthRange depth_range_of(const Drawing& drawing) {
    DepthRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const LinePoint& point : drawing.points) {
        range.nearest = std::min(range.nearest, point.depth);
        range.farthest = std::max(range.farthest, point.depth);
    }
    return range;
}

// Comparisons with what is not a number are false.
bool can_be_drawn(std::span<const LinePoint> points) {
    return points.size() > 1 && std::all_of(points.begin(), points.end(), [](const LinePoint& point) {
               return std::abs(point.position.x) < longest_line && std::abs(point.position.y) < longest_line &&
                      std::isfinite(point.depth);
           });
}

glm::dvec3 unit_or_zero(const glm::dvec3& direction) {
    const double length = glm::length(direction);
    return length > 0 ? direction / length : glm::dvec3(0);
}

// A style's pens by class and by layers, and the brushes of all.
class Pens {
public:
    Pens(const StyleSet& styles, const PenSettings& settings, std::vector<Brush>& brushes) : styles_(styles) {
        brushes.clear();
        for (const StrokeStyle& style : styles_.visible) add(style, settings, brushes);
        for (const StrokeStyle& style : styles_.hidden) add(style, settings, brushes);
    }

    [[nodiscard]] const Pen& pen_of(const Line& line) const {
        const std::size_t layers = std::min<std::size_t>(line.layers, styles_.hidden.size());
        return pens_[line.visible() ? static_cast<std::size_t>(line.line_class) : line_class_count + layers - 1];
    }

private:
    void add(const StrokeStyle& style, const PenSettings& settings, std::vector<Brush>& brushes) {
        const auto same = std::find_if(brushes.begin(), brushes.end(), [&](const Brush& brush) {
            return brush.ends == style.ends && brush.texture == style.texture;
        });
        const auto index = static_cast<std::uint32_t>(same - brushes.begin());
        if (same == brushes.end()) brushes.push_back({style.ends, style.texture});
        pens_.emplace_back(style, index, settings);
    }

    const StyleSet& styles_;
    std::vector<Pen> pens_;
};

// Calls `draw(points, closed)` for the parts of a line between corners.
template <typename Draw>
void draw_between_corners(const Spine& spine, double angle, double reach, const Draw& draw) {
    std::vector<SpinePoint> points(spine.vertices().begin(), spine.vertices().end());
    std::vector<std::size_t> corners = corners_of(spine, angle, reach);
    if (corners.empty()) return draw(points, spine.closed());
    if (spine.closed()) {  // begins and ends at its first corner
        points.pop_back();
        const std::size_t first = corners.front();
        std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(first), points.end());
        points.push_back(points.front());
        for (std::size_t& corner : corners) corner -= first;
    }
    corners.push_back(points.size() - 1);
    std::size_t begin = 0;
    for (const std::size_t corner : corners) {
        if (corner > begin) draw(std::span<const SpinePoint>(points).subspan(begin, corner - begin + 1), false);
        begin = corner;
    }
}

// Draws lines one after the other; each thread has its own.
class LineWriter {
public:
    LineWriter(const Drawing& drawing, const StrokeOptions& options, const Pens& pens)
        : drawing_(drawing), options_(options), pens_(pens), light_(unit_or_zero(glm::dvec3(options.light))) {}

    void write(std::uint32_t index, StrokePieces& out) {
        const Line& line = drawing_.lines[index];
        const std::span<const LinePoint> points = drawing_.points_of(line);
        if (!can_be_drawn(points)) return;
        const Pen& pen = pens_.pen_of(line);
        points_.clear();
        for (const LinePoint& point : points) points_.push_back({point.position, point.depth, light_at(point, pen)});

        const double width =
            options_.scale *
            (line.visible() ? options_.widths[static_cast<std::size_t>(line.line_class)] : options_.hidden_width);
        const auto draw = [&](std::span<const SpinePoint> part, bool closed) {
            pen.draw(part, closed, width, index, desk_, out);
        };
        if (!pen.style().corner_angle) return draw(points_, line.closed);
        Spine whole;
        whole.assign(points_, line.closed);
        if (whole.is_usable()) {
            draw_between_corners(whole, *pen.style().corner_angle, corner_reach * options_.scale, draw);
        }
    }

private:
    [[nodiscard]] double light_at(const LinePoint& point, const Pen& pen) const {
        if (!pen.style().width_by_light) return 0;
        return 0.5 + 0.5 * glm::dot(glm::dvec3(point.normal), light_);
    }

    const Drawing& drawing_;
    const StrokeOptions& options_;
    const Pens& pens_;
    glm::dvec3 light_;
    Pen::Desk desk_;
    std::vector<SpinePoint> points_;
};

// Appends all pieces, in order.
void join(const std::vector<StrokePieces>& pieces, Strokes& strokes) {
    std::vector<std::size_t> first_stroke(pieces.size() + 1, 0), first_point(pieces.size() + 1, 0);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        first_stroke[i + 1] = first_stroke[i] + pieces[i].strokes.size();
        first_point[i + 1] = first_point[i] + pieces[i].points.size();
    }
    strokes.strokes.resize(first_stroke.back());
    strokes.points.resize(first_point.back());
    parallel_for(pieces.size(), 4, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            std::copy(pieces[i].points.begin(), pieces[i].points.end(),
                      strokes.points.begin() + static_cast<std::ptrdiff_t>(first_point[i]));
            std::transform(pieces[i].strokes.begin(), pieces[i].strokes.end(),
                           strokes.strokes.begin() + static_cast<std::ptrdiff_t>(first_stroke[i]), [&](Stroke stroke) {
                               stroke.first_point += static_cast<std::uint32_t>(first_point[i]);
                               return stroke;
                           });
        }
    });
}

}  // namespace

std::array<double, line_class_count> default_widths() {
    std::array<double, line_class_count> widths{};
    for (const LineClassInfo& info : line_class_infos()) {
        widths[static_cast<std::size_t>(info.line_class)] = info.width_mm * pixels_per_mm;
    }
    return widths;
}

Strokes make_strokes(const Drawing& drawing, const StrokeOptions& options) {
    const DepthRange depths = options.depth_range ? *options.depth_range : depth_range_of(drawing);
    Strokes strokes;
    const Pens pens(options.styles, {options.scale, depths.nearest, depths.farthest, options.seed}, strokes.brushes);
    const std::vector<std::uint32_t> order = painting_order(drawing, options.hidden);

    std::vector<StrokePieces> pieces((order.size() + lines_a_piece - 1) / lines_a_piece);
    parallel_for(pieces.size(), 1, [&](std::size_t begin, std::size_t end) {
        LineWriter writer(drawing, options, pens);
        for (std::size_t i = begin * lines_a_piece; i < std::min(end * lines_a_piece, order.size()); ++i) {
            writer.write(order[i], pieces[i / lines_a_piece]);
        }
    });
    join(pieces, strokes);
    return strokes;
}

bool is_even(const Strokes& strokes, const Stroke& stroke) {
    if (!strokes.brushes[stroke.brush].texture.empty()) return false;
    const std::span<const StrokePoint> points = strokes.points_of(stroke);
    return std::all_of(points.begin(), points.end(), [&](const StrokePoint& point) {
        return point.width == points.front().width && point.color == points.front().color;
    });
}

}  // namespace croquis::lines
