#include "lines/stroke_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "lines/stroke_ribbon.h"

namespace croquis::lines {
namespace {

constexpr std::size_t strokes_a_piece = 128;  // of work

// The texture coordinates of one stroke.
struct TextureScale {
    double per_pixel = 0;  // repetitions along the spine
};

TextureScale texture_scale(std::span<const StrokePoint> points, bool closed, double length, double aspect) {
    float widest = 0;
    for (const StrokePoint& point : points) widest = std::max(widest, point.width);
    if (widest <= 0 || aspect <= 0 || length <= 0) return {};
    const double repeats = length / (widest * aspect);
    return {(closed ? std::max(1.0, std::round(repeats)) : repeats) / length};
}

// Ribbons of some strokes.
class RibbonMaker {
public:
    explicit RibbonMaker(StrokeMesh& mesh) : mesh_(mesh) {}

    void add(std::span<const StrokePoint> points, const Stroke& stroke, StrokeEnds ends, double aspect) {
        const std::vector<Crossbar> bars = crossbars_of(points, stroke.closed, ends);
        if (bars.empty()) return;
        const TextureScale scale = texture_scale(points, stroke.closed, bars.back().along, aspect);
        const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
        for (const Crossbar& bar : bars) {
            const StrokePoint& point = points[bar.point];
            const auto u = static_cast<float>(bar.along * scale.per_pixel);
            add_vertex(bar.left, point, {u, 0.5f - arm_share(bar, bar.left)});
            add_vertex(bar.centre, point, {u, 0.5f});
            add_vertex(bar.right, point, {u, 0.5f + arm_share(bar, bar.right)});
        }
        for (std::uint32_t i = 0; i + 1 < bars.size(); ++i) {
            const std::uint32_t a = first + 3 * i, b = a + 3;
            if (is_straight(bars[i]) && is_straight(bars[i + 1])) {
                add_triangle(a, a + 2, b);
                add_triangle(b, a + 2, b + 2);
                continue;
            }
            for (const std::uint32_t side : {0u, 2u}) {
                add_triangle(a + 1, a + side, b + side);
                add_triangle(a + 1, b + side, b + 1);
            }
        }
    }

private:
    static bool is_straight(const Crossbar& bar) {
        const glm::dvec2 off = 0.5 * (bar.left + bar.right) - bar.centre;
        return glm::dot(off, off) < 1e-12;
    }

    // How far an arm reaches, as a share of the stroke's whole width there.
    static float arm_share(const Crossbar& bar, const glm::dvec2& tip) {
        if (bar.half_width <= 0) return 0;
        return static_cast<float>(std::min(0.5, glm::distance(bar.centre, tip) / (2 * bar.half_width)));
    }

    void add_vertex(const glm::dvec2& position, const StrokePoint& point, const glm::vec2& texture) {
        mesh_.vertices.push_back({glm::vec2(position), point.depth, texture, point.color});
    }

    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const glm::vec2 &p = mesh_.vertices[a].position, &q = mesh_.vertices[b].position,
                        &r = mesh_.vertices[c].position;
        if (p == q || q == r || r == p) return;
        mesh_.indices.insert(mesh_.indices.end(), {a, b, c});
    }

    StrokeMesh& mesh_;
};

void append(const StrokeMesh& piece, StrokeMesh& mesh) {
    const auto first_vertex = static_cast<std::uint32_t>(mesh.vertices.size());
    const auto first_index = static_cast<std::uint32_t>(mesh.indices.size());
    mesh.vertices.insert(mesh.vertices.end(), piece.vertices.begin(), piece.vertices.end());
    for (const std::uint32_t index : piece.indices) mesh.indices.push_back(index + first_vertex);
    for (const StrokeMeshPart& part : piece.parts) {
        if (!mesh.parts.empty() && mesh.parts.back().brush == part.brush) {
            mesh.parts.back().index_count += part.index_count;
        } else {
            mesh.parts.push_back({part.brush, part.first_index + first_index, part.index_count});
        }
    }
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
            const auto added = static_cast<std::uint32_t>(piece.indices.size()) - first;
            if (!piece.parts.empty() && piece.parts.back().brush == stroke.brush) {
                piece.parts.back().index_count += added;
            } else if (added > 0) {
                piece.parts.push_back({stroke.brush, first, added});
            }
        }
    });
    StrokeMesh mesh;
    for (const StrokeMesh& piece : pieces) append(piece, mesh);
    return mesh;
}

}  // namespace croquis::lines
