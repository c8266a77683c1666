#include "lines/stroke_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "base/parallel.h"
#include "lines/stroke_ribbon.h"

namespace croquis::lines {
namespace {

constexpr std::size_t strokes_a_piece = 128;  // of work

// How often the texture repeats along a pixel of the spine.
double repeats_a_pixel(std::span<const StrokePoint> points, bool closed, double length, double aspect) {
    float widest = 0;
    for (const StrokePoint& point : points) widest = std::max(widest, point.width);
    if (widest <= 0 || aspect <= 0 || length <= 0) return 0;
    const double repeats = length / (widest * aspect);
    return (closed ? std::max(1.0, std::round(repeats)) : repeats) / length;
}

// Ribbons of some strokes.
class RibbonMaker {
public:
    explicit RibbonMaker(StrokeMesh& mesh) : mesh_(mesh) {}

    void add(std::span<const StrokePoint> points, const Stroke& stroke, StrokeEnds ends, double aspect) {
        const std::vector<Crossbar> bars = crossbars_of(points, stroke.closed, ends);
        if (bars.empty()) return;
        const double per_pixel = repeats_a_pixel(points, stroke.closed, bars.back().along, aspect);
        std::optional<Corners> before;
        for (std::size_t i = 0; i < bars.size(); ++i) {
            const Crossbar& bar = bars[i];
            const StrokePoint& point = points[bar.point];
            const auto u = static_cast<float>(bar.along * per_pixel);
            Corners corners;
            corners.left = add_vertex(bar.left, point, {u, 0.5f - arm_share(bar, bar.left)});
            corners.right = add_vertex(bar.right, point, {u, 0.5f + arm_share(bar, bar.right)});
            const bool is_bent = !is_straight(bar) || (i > 0 && !is_straight(bars[i - 1])) ||
                                 (i + 1 < bars.size() && !is_straight(bars[i + 1]));
            if (is_bent) corners.centre = add_vertex(bar.centre, point, {u, 0.5f});
            if (before) add_piece(*before, corners);
            before = corners;
        }
    }

private:
    // The vertices of a crossbar. Only one whose arms, or a neighbour's, are not in line needs its centre.
    struct Corners {
        std::uint32_t left = 0, right = 0;
        std::optional<std::uint32_t> centre;
    };

    void add_piece(const Corners& a, const Corners& b) {
        if (!a.centre || !b.centre) {
            add_triangle(a.left, a.right, b.left);
            add_triangle(b.left, a.right, b.right);
            return;
        }
        add_triangle(*a.centre, a.left, b.left);
        add_triangle(*a.centre, b.left, *b.centre);
        add_triangle(*a.centre, a.right, b.right);
        add_triangle(*a.centre, b.right, *b.centre);
    }

    static bool is_straight(const Crossbar& bar) {
        const glm::dvec2 off = 0.5 * (bar.left + bar.right) - bar.centre;
        return glm::dot(off, off) < 1e-12;
    }

    // How far an arm reaches, as a share of the stroke's whole width there.
    static float arm_share(const Crossbar& bar, const glm::dvec2& tip) {
        if (bar.half_width <= 0) return 0;
        return static_cast<float>(std::min(0.5, glm::distance(bar.centre, tip) / (2 * bar.half_width)));
    }

    std::uint32_t add_vertex(const glm::dvec2& position, const StrokePoint& point, const glm::vec2& texture) {
        mesh_.vertices.push_back({glm::vec2(position), point.depth, texture, point.color});
        return static_cast<std::uint32_t>(mesh_.vertices.size()) - 1;
    }

    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const glm::vec2 &p = mesh_.vertices[a].position, &q = mesh_.vertices[b].position,
                        &r = mesh_.vertices[c].position;
        if (p == q || q == r || r == p) return;
        mesh_.indices.insert(mesh_.indices.end(), {a, b, c});
    }

    StrokeMesh& mesh_;
};

void add_part(const StrokeMeshPart& part, std::vector<StrokeMeshPart>& parts) {
    if (part.index_count == 0) return;
    if (!parts.empty() && parts.back().brush == part.brush) {
        parts.back().index_count += part.index_count;
    } else {
        parts.push_back(part);
    }
}

StrokeMesh joined(const std::vector<StrokeMesh>& pieces) {
    std::vector<std::size_t> first_vertex(pieces.size() + 1, 0), first_index(pieces.size() + 1, 0);
    StrokeMesh mesh;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        first_vertex[i + 1] = first_vertex[i] + pieces[i].vertices.size();
        first_index[i + 1] = first_index[i] + pieces[i].indices.size();
        for (StrokeMeshPart part : pieces[i].parts) {
            part.first_index += static_cast<std::uint32_t>(first_index[i]);
            add_part(part, mesh.parts);
        }
    }
    mesh.vertices.resize(first_vertex.back());
    mesh.indices.resize(first_index.back());
    parallel_for(pieces.size(), 4, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            std::copy(pieces[i].vertices.begin(), pieces[i].vertices.end(),
                      mesh.vertices.begin() + static_cast<std::ptrdiff_t>(first_vertex[i]));
            std::transform(pieces[i].indices.begin(), pieces[i].indices.end(),
                           mesh.indices.begin() + static_cast<std::ptrdiff_t>(first_index[i]),
                           [&](std::uint32_t index) { return index + static_cast<std::uint32_t>(first_vertex[i]); });
        }
    });
    return mesh;
}

}  // namespace

StrokeMesh make_stroke_mesh(const Strokes& strokes, const TextureAspect& aspect) {
    std::vector<double> aspects;
    for (const Brush& brush : strokes.brushes) {
        aspects.push_back(aspect && !brush.texture.empty() ? aspect(brush.texture) : 1.0);
    }
    const std::size_t count = strokes.strokes.size();
    std::vector<StrokeMesh> pieces((count + strokes_a_piece - 1) / strokes_a_piece);
    parallel_for(pieces.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin * strokes_a_piece; i < std::min(end * strokes_a_piece, count); ++i) {
            StrokeMesh& piece = pieces[i / strokes_a_piece];
            const Stroke& stroke = strokes.strokes[i];
            const auto first = static_cast<std::uint32_t>(piece.indices.size());
            const Brush& brush = strokes.brushes[stroke.brush];
            RibbonMaker(piece).add(strokes.points_of(stroke), stroke, brush.ends, aspects[stroke.brush]);
            add_part({stroke.brush, first, static_cast<std::uint32_t>(piece.indices.size()) - first}, piece.parts);
        }
    });
    return joined(pieces);
}

}  // namespace croquis::lines
