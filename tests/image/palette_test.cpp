// Palettes by properties that brute force can check: never more colours than asked, no more error than an even division
// of the colour cube has, each pixel at its nearest colour, each area as flat as its neighbourhood says.
#include "image/palette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/random.h"

namespace croquis::image {
namespace {

// Soft blobs of colour with noise, as photographs have them.
Image photograph(int width, int height, std::uint64_t seed) {
    const Random random(seed, "photograph");
    Image image(width, height);
    std::uint64_t index = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto channel = [&](double phase) {
                const double wave = 0.5 + 0.5 * std::sin(0.09 * x + 0.07 * y * phase + phase);
                return std::uint8_t(std::clamp(30 + 190 * wave * wave + 12 * random.unit(index++), 0.0, 255.0));
            };
            image.at(x, y) = {channel(0.3), channel(1.9), channel(3.1), std::uint8_t(random.unit(index++) * 256)};
        }
    }
    return image;
}

double squared_distance(const glm::u8vec3& a, const glm::u8vec4& b) {
    const double x = double(a.x) - b.x, y = double(a.y) - b.y, z = double(a.z) - b.z;
    return x * x + y * y + z * z;
}

// Of the pixels to their nearest entries.
double error_of(const Image& image, const Palette& palette) {
    double sum = 0;
    for (const glm::u8vec4& pixel : image.pixels()) {
        double shortest = HUGE_VAL;
        for (const glm::u8vec3& color : palette) shortest = std::min(shortest, squared_distance(color, pixel));
        sum += shortest;
    }
    return sum;
}

// The centres of n x n x n cells of the colour cube.
Palette uniform_palette(int n) {
    Palette palette;
    for (int i = 0; i < n * n * n; ++i) {
        const auto level = [n](int cell) { return std::uint8_t((2 * cell + 1) * 255 / (2 * n)); };
        palette.emplace_back(level(i / n / n), level(i / n % n), level(i % n));
    }
    return palette;
}

std::set<std::uint32_t> colors_of(const Image& image) {
    std::set<std::uint32_t> colors;
    for (const glm::u8vec4& p : image.pixels()) {
        colors.insert(std::uint32_t(p.x) << 16 | std::uint32_t(p.y) << 8 | std::uint32_t(p.z));
    }
    return colors;
}

TEST(Palette, HasNoMoreColoursThanAsked) {
    const Image image = photograph(61, 47, 1);
    for (const int count : {1, 2, 3, 5, 8, 16, 33, 64}) {
        EXPECT_LE(int(choose_palette(image, count).size()), count);
        EXPECT_LE(int(colors_of(with_fewer_colors(image, count)).size()), count);
    }
}

TEST(Palette, ErrsLessThanAnEvenDivision) {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        const Image image = photograph(61, 47, seed);
        for (const int n : {2, 3, 4}) {
            EXPECT_LE(error_of(image, choose_palette(image, n * n * n)), error_of(image, uniform_palette(n)));
        }
    }
}

TEST(Palette, MoreColoursErrLess) {
    const Image image = photograph(61, 47, 4);
    double before = HUGE_VAL;
    for (const int count : {1, 2, 4, 8, 16, 32, 64}) {
        const double error = error_of(image, choose_palette(image, count));
        EXPECT_LT(error, before) << count;
        before = error;
    }
}

// Moving the one colour of a palette of one away from the mean can only make it worse.
TEST(Palette, OneColourIsTheMean) {
    const Image image = photograph(31, 23, 5);
    const Palette palette = choose_palette(image, 1);
    ASSERT_EQ(palette.size(), 1u);
    glm::dvec3 mean(0.0);
    double opacity = 0;
    for (const glm::u8vec4& pixel : image.pixels()) {
        mean += double(pixel.w) * glm::dvec3(pixel);
        opacity += pixel.w;
    }
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(palette[0][c], mean[c] / opacity, 0.51);
}

// What lies under full transparency takes no colour from what is seen.
TEST(Palette, TransparentPixelsDoNotCount) {
    Image image = photograph(31, 23, 9);
    for (glm::u8vec4& pixel : image.pixels()) pixel.w = 255;
    Image padded(31, 46, {0, 255, 0, 0});
    for (int y = 0; y < 23; ++y) {
        for (int x = 0; x < 31; ++x) padded.at(x, y) = image.at(x, y);
    }
    EXPECT_EQ(choose_palette(padded, 6), choose_palette(image, 6));
    const Image unseen(5, 5, {1, 2, 3, 0});
    EXPECT_TRUE(choose_palette(unseen, 6).empty());
    EXPECT_EQ(with_fewer_colors(unseen, 6), unseen);
}

TEST(Palette, SmallImagesAreReduced) {
    for (const auto& [width, height] : {std::pair(1, 1), std::pair(1, 9), std::pair(2, 3)}) {
        EXPECT_LE(int(colors_of(with_fewer_colors(photograph(width, height, 10), 2)).size()), 2);
    }
}

TEST(Palette, FewColoursStayExactly) {
    Image image(16, 16, {10, 20, 30, 255});
    for (int y = 0; y < 16; ++y) {
        for (int x = 8; x < 16; ++x) image.at(x, y) = {201, 7, 99, 128};
    }
    EXPECT_EQ(with_fewer_colors(image, 2), image);
    EXPECT_EQ(with_fewer_colors(image, 64), image);
}

TEST(Palette, EntriesAreTheNearest) {
    const Image image = photograph(37, 29, 6);
    const Palette palette = choose_palette(image, 12);
    const Raster<std::uint8_t> entries = nearest_entries(image, palette);
    for (std::size_t i = 0; i < image.pixels().size(); ++i) {
        const double taken = squared_distance(palette[entries.pixels()[i]], image.pixels()[i]);
        for (const glm::u8vec3& color : palette) EXPECT_LE(taken, squared_distance(color, image.pixels()[i]));
    }
}

TEST(Palette, TheModeFilterTakesTheMostFrequent) {
    const Random random(7, "values");
    Raster<std::uint8_t> values(23, 19);
    for (std::size_t i = 0; i < values.pixels().size(); ++i) values.pixels()[i] = std::uint8_t(random.unit(i) * 5);
    for (const int radius : {0, 1, 2}) {
        const Raster<std::uint8_t> filtered = mode_filtered(values, radius);
        for (int y = 0; y < values.height(); ++y) {
            for (int x = 0; x < values.width(); ++x) {
                std::map<int, int> counts;
                for (int v = 0; v < values.height(); ++v) {
                    for (int u = 0; u < values.width(); ++u) {
                        const int across = std::abs(u - x), along = std::abs(v - y);  // or the other way round the edge
                        if (std::min(across, values.width() - across) <= radius &&
                            std::min(along, values.height() - along) <= radius) {
                            ++counts[values.at(u, v)];
                        }
                    }
                }
                const auto most = std::max_element(counts.begin(), counts.end(),
                                                   [](const auto& a, const auto& b) { return a.second < b.second; });
                EXPECT_EQ(counts[filtered.at(x, y)], most->second);
                if (counts[values.at(x, y)] == most->second) {
                    EXPECT_EQ(filtered.at(x, y), values.at(x, y));
                }
            }
        }
    }
}

TEST(Palette, AlphaStays) {
    const Image image = photograph(31, 23, 8);
    const Image reduced = with_fewer_colors(image, 4);
    for (std::size_t i = 0; i < image.pixels().size(); ++i) EXPECT_EQ(reduced.pixels()[i].w, image.pixels()[i].w);
}

TEST(Palette, AnEmptyImageStaysEmpty) { EXPECT_TRUE(with_fewer_colors(Image(), 4).empty()); }

}  // namespace
}  // namespace croquis::image
