#include "truth/ink.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string_view>

#include "truth/segment_index.h"

namespace croquis::lines::truth {
namespace {

ImagePoint image_point(const Viewpoint& view, const LinePoint& point) {
    const bool perspective = view.projection == model::Projection::perspective;
    return {point.position, perspective ? 1.0 / point.depth : -point.depth};
}

template <typename Use>
void for_each_piece(const Viewpoint& view, const Drawing& drawing, const Line& line, const Use& use) {
    const auto points = drawing.points_of(line);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        use(image_point(view, points[i]), image_point(view, points[i + 1]));
    }
    if (line.closed && !points.empty()) use(image_point(view, points.back()), image_point(view, points.front()));
}

/// Calls `use(point, length)` for points on a piece, away from its ends; none for a piece too short to tell.
template <typename Use>
void for_each_sample(const ImagePoint& begin, const ImagePoint& end, const Use& use) {
    const double length = glm::distance(begin.position, end.position);
    if (length < 0.02) return;
    const auto count = static_cast<std::size_t>(std::ceil(length / 3)) + 2;
    for (std::size_t i = 0; i < count; ++i) {
        // An irrational offset keeps the samples off the regular places where test models have their vertices.
        const double share = (static_cast<double>(i) + 0.6180339887) / static_cast<double>(count);
        use(ImagePoint{begin.position + (end.position - begin.position) * share,
                       begin.nearness + (end.nearness - begin.nearness) * share},
            length / static_cast<double>(count));
    }
}

SegmentIndex index_of(const Viewpoint& view, const Drawing& drawing, SegmentIndex::Depth depth) {
    SegmentIndex index(view, depth);
    for (std::uint32_t l = 0; l < drawing.lines.size(); ++l) {
        for_each_piece(view, drawing, drawing.lines[l],
                       [&](const ImagePoint& begin, const ImagePoint& end) { index.add(l, begin, end); });
    }
    return index;
}

SegmentIndex::Depth depth_of(const Alike& alike) {
    return alike.depth ? SegmentIndex::Depth::compared : SegmentIndex::Depth::ignored;
}

double only_in(const Viewpoint& view, const Drawing& one, const Drawing& other, std::string_view name,
               std::string& text, const Alike& alike, double reach) {
    const SegmentIndex index = index_of(view, other, depth_of(alike));
    double only = 0;
    for (const Line& line : one.lines) {
        for_each_piece(view, one, line, [&](const ImagePoint& begin, const ImagePoint& end) {
            for_each_sample(begin, end, [&](const ImagePoint& point, double length) {
                const auto found = index.at(point, reach);
                const bool is_there = std::any_of(found.begin(), found.end(), [&](const SegmentIndex::Found& f) {
                    const Line& there = other.lines[f.id];
                    return (there.line_class == line.line_class || !alike.line_class) && there.layers == line.layers &&
                           (there.mesh == line.mesh || !alike.mesh);
                });
                if (is_there) return;
                only += length;
                if (text.size() > 1000) return;
                text += fmt::format("only in the {}: {} of {} layers, mesh {}, at ({:.3f}, {:.3f}) depth {:.5f}\n",
                                    name, info_of(line.line_class).name, line.layers, line.mesh, point.position.x,
                                    point.position.y, view.distance_of(point.nearness));
            });
        });
    }
    return only;
}

}  // namespace

Drawing drawing_of(const Viewpoint& view, const std::vector<Stroke3>& strokes) {
    Drawing drawing{view.width, view.height, {}, {}};
    for (const Stroke3& stroke : strokes) {
        Line line;
        line.line_class = stroke.line_class;
        line.mesh = stroke.mesh;
        line.layers = stroke.layers;
        line.first_point = static_cast<std::uint32_t>(drawing.points.size());
        line.point_count = 2;
        drawing.lines.push_back(line);
        for (const glm::dvec3& point : {stroke.from, stroke.to}) {
            drawing.points.push_back({view.project(point).position, view.eye_distance(point), glm::vec3(0.0f)});
        }
    }
    return drawing;
}

double difference(const Viewpoint& view, const Drawing& one, const Drawing& other, std::string& text,
                  const Alike& alike, double reach) {
    return only_in(view, one, other, "first", text, alike, reach) +
           only_in(view, other, one, "second", text, alike, reach);
}

double doubled_ink(const Viewpoint& view, const Drawing& drawing, std::string& text) {
    Drawing visible = drawing;
    std::erase_if(visible.lines, [](const Line& line) { return !line.visible(); });
    const SegmentIndex index = index_of(view, visible, SegmentIndex::Depth::ignored);
    double doubled = 0;
    for (const Line& line : visible.lines) {
        for_each_piece(view, visible, line, [&](const ImagePoint& begin, const ImagePoint& end) {
            for_each_sample(begin, end, [&](const ImagePoint& point, double length) {
                const auto found = index.at(point, 1e-4);
                if (found.size() < 2) return;
                doubled += length;
                if (text.size() > 1000) return;
                text += fmt::format("{} lines at ({:.3f}, {:.3f}):", found.size(), point.position.x, point.position.y);
                for (const auto& f : found) {
                    text += fmt::format(" {} depth {:.5f}", info_of(visible.lines[f.id].line_class).name,
                                        view.distance_of(f.nearness));
                }
                text += "\n";
            });
        });
    }
    return doubled;
}

double length_of(const Drawing& drawing, LineClass line_class, std::uint32_t layers) {
    double length = 0;
    for (const Line& line : drawing.lines) {
        if (line.line_class == line_class && line.layers == layers) length += lines::length_of(drawing, line);
    }
    return length;
}

double length_of(const Drawing& drawing) {
    double length = 0;
    for (const Line& line : drawing.lines) length += lines::length_of(drawing, line);
    return length;
}

std::size_t count_of(const Drawing& drawing, LineClass line_class, std::uint32_t layers) {
    return static_cast<std::size_t>(std::count_if(drawing.lines.begin(), drawing.lines.end(), [&](const Line& line) {
        return line.line_class == line_class && line.layers == layers;
    }));
}

std::string text_of(const Drawing& drawing) {
    std::string text;
    for (const Line& line : drawing.lines) {
        text += fmt::format("{}, mesh {}, {} layers{}:", info_of(line.line_class).name, line.mesh, line.layers,
                            line.closed ? ", closed" : "");
        for (const LinePoint& point : drawing.points_of(line)) {
            text += fmt::format(" ({:.2f}, {:.2f}, {:.4f})", point.position.x, point.position.y, point.depth);
        }
        text += "\n";
    }
    return text;
}

}  // namespace croquis::lines::truth
