#include "lines/face_cutter.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace croquis::lines {
namespace {

// Heights that rounding of the file's coordinates, and our own shifts, may have made, in shifts.
constexpr double shifts_in_doubt = 8;

bool holds(const std::array<std::uint32_t, 3>& face, std::uint32_t vertex) {
    return face[0] == vertex || face[1] == vertex || face[2] == vertex;
}

}  // namespace

/// A face's plane, and how far it can be trusted.
struct FaceCutter::Plane {
    const GeneralPosition& points;
    const Triangle& corners;
    glm::dvec3 origin, normal;  // the normal is twice the face's area long
    double doubt;               // the height within which a corner counts as touching
    double rounding;            // of a height, for a point at a distance of 1

    Plane(const GeneralPosition& of, const Triangle& face)
        : points(of), corners(face), origin(of[face[0]]), doubt(shifts_in_doubt * of.largest_shift()) {
        const glm::dvec3 u = points[face[1]] - origin, v = points[face[2]] - origin;
        normal = glm::cross(u, v);
        const auto sum = [](const glm::dvec3& w) { return std::abs(w.x) + std::abs(w.y) + std::abs(w.z); };
        rounding = 2e-15 * sum(u) * sum(v);
    }

    /// Times the normal's length. Its sign is true.
    [[nodiscard]] double height(std::uint32_t vertex) const {
        const glm::dvec3 offset = points[vertex] - origin;
        const double value = glm::dot(normal, offset);
        const double error = rounding * (std::abs(offset.x) + std::abs(offset.y) + std::abs(offset.z));
        return std::abs(value) > error ? value : points.volume(corners[0], corners[1], corners[2], vertex);
    }

    /// Heights of a face's corners; 0 for corners of both.
    [[nodiscard]] std::array<double, 3> heights(const Triangle& face) const {
        std::array<double, 3> heights{};
        for (std::size_t i = 0; i < 3; ++i) heights[i] = holds(corners, face[i]) ? 0.0 : height(face[i]);
        return heights;
    }

    [[nodiscard]] bool all_touch(const std::array<double, 3>& heights) const {
        const double most = doubt * doubt * glm::dot(normal, normal);
        return std::all_of(heights.begin(), heights.end(), [most](double h) { return h * h <= most; });
    }

    /// On which side a vertex lies: 0 within doubt, which is the larger the farther the plane is drawn out from its
    /// face.
    [[nodiscard]] int certain_side(std::uint32_t vertex) const {
        if (holds(corners, vertex)) return 0;
        const glm::dvec3 u = points[corners[1]] - origin, v = points[corners[2]] - origin, w = v - u;
        const double longest = std::sqrt(std::max({glm::dot(u, u), glm::dot(v, v), glm::dot(w, w)}));
        const double twice_area = glm::length(normal);
        const double value = height(vertex);
        const double slack = doubt * (twice_area + glm::length(points[vertex] - origin) * longest);
        return value > slack ? 1 : value < -slack ? -1 : 0;
    }
};

bool FaceCutter::pierces(std::uint32_t a, std::uint32_t b, const Triangle& face) const {
    const auto& [p, q, r] = face;
    const bool left_of_pq = points_.volume(a, b, p, q) > 0;
    return (points_.volume(a, b, q, r) > 0) == left_of_pq && (points_.volume(a, b, r, p) > 0) == left_of_pq;
}

// A face that lies on one side up to a corner or an edge that touches goes on beyond the plane if a neighbour at what
// touches lies on the other side.
bool FaceCutter::extends_beyond(std::uint32_t face, const Plane& plane) const {
    std::array<std::uint32_t, 3> touching{};
    std::size_t touching_count = 0;
    bool above = false, below = false;
    for (const std::uint32_t v : corners(face)) {
        const int side = plane.certain_side(v);
        above = above || side > 0;
        below = below || side < 0;
        if (side == 0) touching[touching_count++] = v;
    }
    if (above == below) return above;
    if (touching_count == 0) return false;
    for (const std::uint32_t neighbour : surface_.faces_around(touching[0])) {
        const Triangle& others = corners(neighbour);
        if (touching_count == 2 && !holds(others, touching[1])) continue;
        for (const std::uint32_t v : others) {
            if (plane.certain_side(v) == (above ? -1 : 1)) return true;
        }
    }
    return false;
}

void FaceCutter::cut(std::uint32_t face, std::span<const std::uint32_t> others, std::vector<FaceCut>& found) const {
    const Plane plane(points_, corners(face));
    for (const std::uint32_t other : others) cut_pair(face, plane, other, found);
}

void FaceCutter::cut_pair(std::uint32_t f, const Plane& first_plane, std::uint32_t g,
                          std::vector<FaceCut>& found) const {
    const Triangle &first = corners(f), &second = corners(g);
    std::uint32_t shared = 0, shared_count = 0;
    for (const std::uint32_t v : first) {
        if (holds(second, v)) shared = v, ++shared_count;
    }
    if (shared_count > 1) return;

    const std::array<double, 3> second_heights = first_plane.heights(second);
    const auto on_one_side = [](const std::array<double, 3>& heights) {
        const auto [low, high] = std::minmax({heights[0], heights[1], heights[2]});
        return low >= 0 || high <= 0;
    };
    if (on_one_side(second_heights)) return;
    const Plane second_plane(points_, second);
    const std::array<double, 3> first_heights = second_plane.heights(first);
    if (on_one_side(first_heights)) return;
    if (first_plane.all_touch(second_heights) || second_plane.all_touch(first_heights)) return;

    FaceCut cut{{std::min(f, g), std::max(f, g)}, {}, false};
    std::size_t end_count = 0;
    if (shared_count == 1) cut.ends[end_count++] = {shared, shared, model::no_face};
    const auto add_piercings = [&](const Triangle& edges, const std::array<double, 3>& heights, std::uint32_t face) {
        for (std::size_t i = 0; i < 3 && end_count < 2; ++i) {
            const std::size_t next = (i + 1) % 3;
            const auto [a, b] = std::minmax({edges[i], edges[next]});
            if (shared_count == 1 && (a == shared || b == shared)) continue;
            if ((heights[i] > 0) == (heights[next] > 0) || !pierces(a, b, corners(face))) continue;
            cut.ends[end_count++] = {a, b, face};
        }
    };
    add_piercings(first, first_heights, g);
    add_piercings(second, second_heights, f);
    if (end_count < 2) return;
    // A shorter one may come of two edges that touch.
    const double shortest = 4 * shifts_in_doubt * points_.largest_shift();
    cut.is_certain = glm::distance(point_of(cut.ends[0]), point_of(cut.ends[1])) > shortest &&
                     extends_beyond(f, second_plane) && extends_beyond(g, first_plane);
    found.push_back(cut);
}

glm::dvec3 FaceCutter::point_of(const CutPlace& place) const {
    const glm::dvec3 from = surface_.point(place.a), to = surface_.point(place.b);
    if (place.face == model::no_face) return from;
    const auto& [p, q, r] = corners(place.face);
    const glm::dvec3 corner = surface_.point(p);
    const glm::dvec3 normal = glm::cross(surface_.point(q) - corner, surface_.point(r) - corner);
    double start = glm::dot(normal, from - corner), end = glm::dot(normal, to - corner);
    if ((start > 0) == (end > 0)) {
        start = points_.volume(p, q, r, place.a);
        end = points_.volume(p, q, r, place.b);
    }
    return from + start / (start - end) * (to - from);
}

}  // namespace croquis::lines
