#include "model/shade_split.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <optional>

namespace croquis::model {
namespace {

double mean_cosine(const ShadeTriangle& t) { return (t[0].cosine + t[1].cosine + t[2].cosine) / 3.0; }

double longest_side(const ShadeTriangle& t) {
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        longest = std::max(longest, glm::distance(t[i].position, t[(i + 1) % 3].position));
    }
    return longest;
}

bool has_no_area(const ShadeTriangle& t) {
    return glm::cross(t[1].position - t[0].position, t[2].position - t[0].position) == glm::dvec3(0.0);
}

// A threshold with corners on both sides of it: a shadow line that crosses the triangle.
std::optional<double> crossing_threshold(const ShadeTriangle& t, std::span<const double> thresholds) {
    const auto [low, high] = std::minmax({t[0].cosine, t[1].cosine, t[2].cosine});
    const auto first_above = std::upper_bound(thresholds.begin(), thresholds.end(), low);
    if (first_above == thresholds.end() || *first_above >= high) return std::nullopt;
    return *first_above;
}

ShadeCorner middle(const ShadeCorner& a, const ShadeCorner& b) {
    return {0.5 * (a.position + b.position), 0.5 * (a.cosine + b.cosine)};
}

// Where the shadow line crosses the edge: equation 4.6. On it the cosine is the threshold, whatever rounding says.
ShadeCorner on_shadow_line(const ShadeCorner& a, const ShadeCorner& b, double threshold) {
    const double lambda = (threshold - b.cosine) / (a.cosine - b.cosine);
    return {lambda * a.position + (1.0 - lambda) * b.position, threshold};
}

// Figure 4.18 b: the corner that is alone on its side of the shadow line, and the other two in turn.
ShadeTriangle lone_corner_first(const ShadeTriangle& t, double threshold) {
    for (std::size_t i = 0; i < 3; ++i) {
        const ShadeCorner &lone = t[i], &next = t[(i + 1) % 3], &last = t[(i + 2) % 3];
        const bool is_below = lone.cosine < threshold && next.cosine >= threshold && last.cosine >= threshold;
        const bool is_above = lone.cosine > threshold && next.cosine <= threshold && last.cosine <= threshold;
        if (is_below || is_above) return {lone, next, last};
    }
    return t;
}

// Figure 4.18 b: four triangles, the third edge cut in its middle.
std::array<ShadeTriangle, 4> split_at(const ShadeTriangle& triangle, double threshold) {
    const auto [lone, next, last] = lone_corner_first(triangle, threshold);
    const ShadeCorner first_cut = on_shadow_line(lone, next, threshold);
    const ShadeCorner second_cut = on_shadow_line(lone, last, threshold);
    const ShadeCorner far_cut = middle(next, last);
    return {ShadeTriangle{lone, first_cut, second_cut}, ShadeTriangle{first_cut, next, far_cut},
            ShadeTriangle{first_cut, far_cut, second_cut}, ShadeTriangle{second_cut, far_cut, last}};
}

ShadeCorner lit_corner(const LitSurface& surface, std::uint32_t vertex) {
    const glm::dvec3 position(surface.positions[vertex]);
    const glm::dvec3 to_light = glm::normalize(glm::dvec3(surface.light) - surface.light.w * position);
    return {position, glm::dot(glm::dvec3(surface.normals[vertex]), to_light)};
}

}  // namespace

int shade_level(double cosine, std::span<const double> thresholds) {
    return int(std::upper_bound(thresholds.begin(), thresholds.end(), cosine) - thresholds.begin());
}

std::vector<ShadePiece> split_by_shade(const ShadeTriangle& triangle, std::span<const double> thresholds,
                                       double smallest_split) {
    std::vector<ShadePiece> pieces;
    std::vector<ShadeTriangle> waiting{triangle};
    while (!waiting.empty()) {
        const ShadeTriangle current = waiting.back();
        waiting.pop_back();
        const auto threshold = crossing_threshold(current, thresholds);
        if (!threshold || longest_side(current) <= smallest_split) {
            pieces.push_back({current, shade_level(mean_cosine(current), thresholds)});
            continue;
        }
        for (const ShadeTriangle& part : split_at(current, *threshold)) {
            if (!has_no_area(part)) waiting.push_back(part);
        }
    }
    return pieces;
}

std::vector<ShadePiece> split_by_shade(const LitSurface& surface, std::span<const double> thresholds,
                                       double smallest_split) {
    std::vector<ShadePiece> all;
    for (std::size_t i = 0; i + 2 < surface.triangles.size(); i += 3) {
        ShadeTriangle triangle;
        for (std::size_t c = 0; c < 3; ++c) triangle[c] = lit_corner(surface, surface.triangles[i + c]);
        for (ShadePiece& piece : split_by_shade(triangle, thresholds, smallest_split)) {
            piece.triangle = std::uint32_t(i / 3);
            all.push_back(piece);
        }
    }
    return all;
}

}  // namespace croquis::model
