// Ear clipping (Meisters 1975) in the plane of Newell's normal: quadratic, so polygons past a bound become fans.
#include "model/triangulate.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace croquis::model {
namespace {

constexpr std::size_t most_clipped = 4096;  // corners; ears of more would take seconds

using Polygon = std::vector<glm::dvec2>;

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The polygon along the axis in which it is largest, so that it runs counter-clockwise.
Polygon flatten(std::span<const glm::dvec3> polygon) {
    glm::dvec3 normal(0.0);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3& a = polygon[i];
        const glm::dvec3& b = polygon[(i + 1) % polygon.size()];
        normal += glm::cross(a - polygon[0], b - polygon[0]);
    }
    const glm::dvec3 size = glm::abs(normal);
    const int drop = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    const int u = (drop + 1) % 3, v = (drop + 2) % 3;
    const double side = normal[drop] < 0 ? -1.0 : 1.0;
    Polygon flat;
    for (const glm::dvec3& p : polygon) flat.emplace_back(side * (p[u] - polygon[0][u]), p[v] - polygon[0][v]);
    return flat;
}

bool is_convex(const Polygon& flat) {
    const std::size_t count = flat.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (turn(flat[i], flat[(i + 1) % count], flat[(i + 2) % count]) < 0) return false;
    }
    return true;
}

bool is_inside(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    if (p == a || p == b || p == c) return false;  // polygons that touch themselves, as those with bridged holes
    return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
}

/// The corners still there, as a ring.
class Ring {
public:
    explicit Ring(const Polygon& flat) : flat_(flat), next_(flat.size()), previous_(flat.size()), left_(flat.size()) {
        for (std::uint32_t i = 0; i < flat.size(); ++i) {
            next_[i] = (i + 1) % static_cast<std::uint32_t>(flat.size());
            previous_[next_[i]] = i;
        }
    }

    void clip(std::vector<std::uint32_t>& triangles) {
        std::uint32_t corner = 0;
        std::size_t refused = 0;
        while (left_ > 3) {
            if (refused > left_ || is_ear(corner)) {  // a polygon that crosses itself may have no ear: cut anyway
                cut(corner, triangles);
                refused = 0;
                corner = next_[next_[corner]];
            } else {
                ++refused;
                corner = next_[corner];
            }
        }
        triangles.insert(triangles.end(), {previous_[corner], corner, next_[corner]});
    }

private:
    [[nodiscard]] bool is_ear(std::uint32_t corner) const {
        const std::uint32_t a = previous_[corner], c = next_[corner];
        if (turn(flat_[a], flat_[corner], flat_[c]) <= 0) return false;
        for (std::uint32_t p = next_[c]; p != a; p = next_[p]) {
            if (is_inside(flat_[p], flat_[a], flat_[corner], flat_[c])) return false;
        }
        return true;
    }

    void cut(std::uint32_t corner, std::vector<std::uint32_t>& triangles) {
        triangles.insert(triangles.end(), {previous_[corner], corner, next_[corner]});
        next_[previous_[corner]] = next_[corner];
        previous_[next_[corner]] = previous_[corner];
        --left_;
    }

    const Polygon& flat_;
    std::vector<std::uint32_t> next_, previous_;
    std::size_t left_;
};

}  // namespace

void triangulate(std::span<const glm::dvec3> polygon, std::vector<std::uint32_t>& triangles) {
    if (polygon.size() < 3) return;
    const auto count = static_cast<std::uint32_t>(polygon.size());
    if (count > 3 && count <= most_clipped) {
        const Polygon flat = flatten(polygon);
        if (!is_convex(flat)) return Ring(flat).clip(triangles);
    }
    for (std::uint32_t i = 1; i + 1 < count; ++i) triangles.insert(triangles.end(), {0, i, i + 1});
}

}  // namespace croquis::model
