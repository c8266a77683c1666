// The cross-shaped neighbourhood of seed C's figure 3.5, and how pictures of edges are compared.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

#include "base/random.h"
#include "image/image.h"

namespace croquis::test_support {

constexpr glm::u8vec4 black{0, 0, 0, 255}, white{255, 255, 255, 255};

/// The centre, left, right, below and above; the image's border repeats outwards.
template <typename Pixel>
[[nodiscard]] std::array<Pixel, 5> cross_at(const image::Raster<Pixel>& raster, int x, int y) {
    const int left = std::max(x - 1, 0), right = std::min(x + 1, raster.width() - 1);
    const int above = std::max(y - 1, 0), below = std::min(y + 1, raster.height() - 1);
    return {raster.at(x, y), raster.at(left, y), raster.at(right, y), raster.at(x, below), raster.at(x, above)};
}

/// Compares a picture with the colours that `expected` gives at each pixel, within so many levels a channel. Where it
/// gives none, rounding decides; that may be so for a hundredth of the pixels.
using ExpectedPixel = std::function<std::optional<glm::vec4>(int x, int y)>;

inline void expect_pixels(const image::Image& picture, const ExpectedPixel& expected, double tolerance = 0.51,
                          double undecided_share = 0.01) {
    int undecided = 0, wrong = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const std::optional<glm::vec4> truth = expected(x, y);
            if (!truth) {
                ++undecided;
                continue;
            }
            const glm::vec4 apart = glm::abs(glm::vec4(picture.at(x, y)) - 255.0f * *truth);
            const float largest = std::max(std::max(apart.x, apart.y), std::max(apart.z, apart.w));
            if (double(largest) <= tolerance) continue;
            if (++wrong > 3) continue;
            ADD_FAILURE() << "at " << x << ", " << y << ": expected " << 255.0f * truth->x << " " << 255.0f * truth->y
                          << " " << 255.0f * truth->z << " " << 255.0f * truth->w << ", found "
                          << int(picture.at(x, y).x) << " " << int(picture.at(x, y).y) << " " << int(picture.at(x, y).z)
                          << " " << int(picture.at(x, y).w);
        }
    }
    EXPECT_EQ(wrong, 0) << "wrong pixels in all";
    EXPECT_LE(undecided, undecided_share * picture.width() * picture.height());
}

}  // namespace croquis::test_support
