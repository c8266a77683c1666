#include "lines/general_position.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "base/random.h"

namespace croquis::lines {
namespace {

constexpr std::size_t vertices_a_piece = 16384;

__extension__ using WideInteger = __int128;

bool is_finite(const glm::dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

// Three numbers in [-1, 1) of 21 bits each.
glm::dvec3 shift_of(const Random& random, std::uint32_t vertex) {
    const std::uint64_t bits = random.bits(vertex);
    const auto part = [bits](int shift) { return static_cast<double>(bits >> shift & 0x1fffff) * 0x1p-20 - 1.0; };
    return {part(0), part(21), part(42)};
}

}  // namespace

GeneralPosition::GeneralPosition(const Surface& surface) : points_(surface.vertex_count()) {
    parallel_for(points_.size(), vertices_a_piece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            const glm::dvec3 point = surface.point(static_cast<std::uint32_t>(v));
            points_[v] = is_finite(point) ? point : glm::dvec3(0.0);
        }
    });
    glm::dvec3 farthest(0.0);
    for (const glm::dvec3& point : points_) farthest = glm::max(farthest, glm::abs(point));
    const double reach = std::max({farthest.x, farthest.y, farthest.z});
    if (reach > 0) extent_ = std::ldexp(1.0, std::ilogb(reach) + 1);

    const Random random(0, "general position");
    const double grid = extent_ * grid_share;
    parallel_for(points_.size(), vertices_a_piece, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            const glm::dvec3 moved = points_[v] + largest_shift() * shift_of(random, static_cast<std::uint32_t>(v));
            points_[v] = grid * glm::floor(moved / grid);
        }
    });
}

double GeneralPosition::volume(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t top) const {
    // Differences on the grid are exact.
    const glm::dvec3 u = points_[b] - points_[a], v = points_[c] - points_[a], w = points_[top] - points_[a];
    const glm::dvec3 plus = {u.y * v.z, u.z * v.x, u.x * v.y}, minus = {u.z * v.y, u.x * v.z, u.y * v.x};
    const double value = glm::dot(plus - minus, w);
    const double size = glm::dot(glm::abs(plus) + glm::abs(minus), glm::abs(w));
    constexpr double bound = 7.7715611723761027e-16;  // (7 + 56e) e of Shewchuk 1997, with e = 2^-53
    return std::abs(value) > bound * size ? value : exact_volume(u, v, w);
}

double GeneralPosition::exact_volume(const glm::dvec3& u, const glm::dvec3& v, const glm::dvec3& w) const {
    const double grid = extent_ * grid_share;
    const auto whole = [grid](double x) { return static_cast<WideInteger>(x / grid); };
    const WideInteger value = (whole(u.y) * whole(v.z) - whole(u.z) * whole(v.y)) * whole(w.x) +
                              (whole(u.z) * whole(v.x) - whole(u.x) * whole(v.z)) * whole(w.y) +
                              (whole(u.x) * whole(v.y) - whole(u.y) * whole(v.x)) * whole(w.z);
    return static_cast<double>(value) * grid * grid * grid;
}

}  // namespace croquis::lines
