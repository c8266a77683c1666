#include "lines/stroke_noise.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace croquis::lines {
namespace {

// Unit vectors all around; a lattice point picks two with eight of its random bits each.
const std::array<glm::dvec2, 256>& directions() {
    static const std::array<glm::dvec2, 256> all = [] {
        std::array<glm::dvec2, 256> made;
        for (std::size_t i = 0; i < made.size(); ++i) {
            const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(made.size());
            made[i] = {std::cos(angle), std::sin(angle)};
        }
        return made;
    }();
    return all;
}

double fade(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }

}  // namespace

glm::dvec2 PerlinNoise::at(const glm::dvec2& place) const {
    const glm::dvec2 corner = glm::floor(place);
    const glm::dvec2 inside = place - corner;
    const auto column = static_cast<std::int64_t>(corner.x);
    const auto row = static_cast<std::int64_t>(corner.y);
    const std::array<glm::dvec2, 256>& gradients = directions();

    const auto pull = [&](int dx, int dy) {
        const auto x = static_cast<std::uint64_t>(column + dx);
        const auto y = static_cast<std::uint64_t>(row + dy);
        const std::uint64_t bits = random_.bits(x << 32 | (y & 0xffffffffu));
        const glm::dvec2 from_corner = inside - glm::dvec2(dx, dy);
        return glm::dvec2(glm::dot(gradients[bits & 255u], from_corner),
                          glm::dot(gradients[bits >> 8 & 255u], from_corner));
    };
    const double x = fade(inside.x);
    const glm::dvec2 upper = glm::mix(pull(0, 0), pull(1, 0), x);
    const glm::dvec2 lower = glm::mix(pull(0, 1), pull(1, 1), x);

    // Of a component the greatest value is the square root of a half, and most stay far below: half as much again fills
    // the disc better, and the little that comes out of it is brought back to its rim.
    const glm::dvec2 value = 1.5 * glm::mix(upper, lower, fade(inside.y));
    const double length = glm::length(value);
    return length > 1 ? value / length : value;
}

}  // namespace croquis::lines
