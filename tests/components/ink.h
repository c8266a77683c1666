// What strokes must look like, computed without any triangle: the share of a pixel's samples within half the width of
// the spine.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <vector>

#include "image/image.h"

namespace croquis::test_support {

/// A spine in pixels from the upper left, with its width at each point.
struct Spine {
    std::vector<glm::dvec2> points;
    std::vector<double> widths;
    bool closed = false;
};

/// How far inside the ink a place lies, pixels; negative outside.
[[nodiscard]] inline double depth_in_ink(const Spine& spine, const glm::dvec2& place) {
    double deepest = -std::numeric_limits<double>::infinity();
    const std::size_t count = spine.points.size(),
                      segments = spine.closed ? count : std::max<std::size_t>(count, 2) - 1;
    for (std::size_t i = 0; i < segments; ++i) {
        const std::size_t j = (i + 1) % count;
        const glm::dvec2 step = spine.points[j] - spine.points[i], from = place - spine.points[i];
        const double square = glm::dot(step, step);
        const double share = square > 0 ? std::clamp(glm::dot(from, step) / square, 0.0, 1.0) : 0.0;
        const double half_width = 0.5 * (spine.widths[i] + share * (spine.widths[j] - spine.widths[i]));
        deepest = std::max(deepest, half_width - glm::length(from - share * step));
    }
    return deepest;
}

/// The share of each pixel that the spines' ink covers together.
[[nodiscard]] inline image::Raster<double> coverage(const std::vector<Spine>& spines, int width, int height) {
    constexpr int side = 8;
    image::Raster<double> covered(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            std::vector<const Spine*> near;  // those whose ink any of the samples can lie in
            for (const Spine& spine : spines) {
                if (depth_in_ink(spine, {x + 0.5, y + 0.5}) > -0.75) near.push_back(&spine);
            }
            int inside = 0;
            for (int s = 0; s < side * side && !near.empty(); ++s) {
                const glm::dvec2 sample(x + (s % side + 0.5) / side, y + (s / side + 0.5) / side);
                inside += std::any_of(near.begin(), near.end(),
                                      [&](const Spine* spine) { return depth_in_ink(*spine, sample) >= 0; });
            }
            covered.at(x, y) = double(inside) / (side * side);
        }
    }
    return covered;
}

/// The ink of a picture of black on white, 0 to 1.
[[nodiscard]] inline double ink_at(const image::Image& picture, int x, int y) {
    return 1.0 - picture.at(x, y).x / 255.0;
}

[[nodiscard]] inline bool same_pixels(const image::Image& a, const image::Image& b) {
    return std::equal(a.pixels().begin(), a.pixels().end(), b.pixels().begin(), b.pixels().end());
}

/// How a picture in black on white differs from what it must show.
struct InkDifference {
    double mean = 0;
    double largest = 0;
};

[[nodiscard]] inline InkDifference difference(const image::Image& picture, const image::Raster<double>& truth) {
    InkDifference found;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const double apart = std::abs(ink_at(picture, x, y) - truth.at(x, y));
            found.mean += apart / (picture.width() * picture.height());
            found.largest = std::max(found.largest, apart);
        }
    }
    return found;
}

}  // namespace croquis::test_support
