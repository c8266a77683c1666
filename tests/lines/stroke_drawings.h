// Drawings of given polylines, for the tests of strokes.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <initializer_list>
#include <vector>

#include "lines/strokes.h"

namespace croquis::lines {

using Polyline = std::vector<glm::dvec2>;

/// One more line of a drawing. Its surface faces +z and is 1 away.
inline Line& add_line(Drawing& drawing, const Polyline& points, LineClass line_class = LineClass::silhouette,
                      std::uint32_t layers = 0, bool closed = false) {
    Line line;
    line.line_class = line_class;
    line.layers = layers;
    line.closed = closed;
    line.first_point = static_cast<std::uint32_t>(drawing.points.size());
    line.point_count = static_cast<std::uint32_t>(points.size());
    for (const glm::dvec2& point : points) drawing.points.push_back({point, 1.0, {0.0f, 0.0f, 1.0f}});
    drawing.lines.push_back(line);
    return drawing.lines.back();
}

inline Drawing drawing_of(const Polyline& points, bool closed = false) {
    Drawing drawing{1000, 1000, {}, {}};
    add_line(drawing, points, LineClass::silhouette, 0, closed);
    return drawing;
}

/// All lines in one style, each 4 pixels wide where the style says nothing else.
inline StrokeOptions options_of(const StrokeStyle& style) {
    StrokeOptions options;
    options.styles = StyleSet(style);
    options.widths.fill(4);
    options.hidden_width = 4;
    return options;
}

/// A wavy line, bent this way and that.
inline Polyline wave(int count = 60) {
    Polyline points;
    for (int i = 0; i < count; ++i)
        points.emplace_back(20 + 5.0 * i, 200 + 60 * std::sin(0.13 * i) + 9 * std::sin(0.7 * i));
    return points;
}

inline Polyline circle(double radius, int count) {
    Polyline points;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * 3.14159265358979323846 * i / count;
        points.push_back(glm::dvec2(300, 300) + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return points;
}

inline double length_of(const Polyline& points) {
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i) length += glm::distance(points[i - 1], points[i]);
    return length;
}

/// The point of a polyline at an arc length; its ends beyond them.
inline glm::dvec2 walk(const Polyline& points, double along) {
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double length = glm::distance(points[i - 1], points[i]);
        if (along <= length) return points[i - 1] + (points[i] - points[i - 1]) * (std::max(along, 0.0) / length);
        along -= length;
    }
    return points.back();
}

inline Polyline positions(const Strokes& strokes, const Stroke& stroke) {
    Polyline points;
    for (const StrokePoint& point : strokes.points_of(stroke)) points.push_back(point.position);
    return points;
}

}  // namespace croquis::lines
