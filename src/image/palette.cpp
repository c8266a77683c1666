#include "image/palette.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <glm/geometric.hpp>
#include <numeric>

#include "base/parallel.h"

namespace croquis::image {
namespace {

constexpr std::size_t rows_grain = 16;
constexpr int mode_radius = 2;  // pixels

// Colours that lie together in a cell of the colour cube, as their mean and number.
struct Sample {
    glm::dvec3 color{0.0};
    double weight = 0;
};

std::uint32_t packed(const glm::u8vec4& pixel) {
    return std::uint32_t(pixel.x) << 16 | std::uint32_t(pixel.y) << 8 | std::uint32_t(pixel.z);
}

// The distinct colours of what is not fully transparent, ascending, or one more than `count` of them.
std::vector<std::uint32_t> distinct_colors(const Image& image, std::size_t count) {
    std::vector<std::uint32_t> found;
    for (const glm::u8vec4& pixel : image.pixels()) {
        if (pixel.w == 0) continue;
        const std::uint32_t color = packed(pixel);
        const auto place = std::lower_bound(found.begin(), found.end(), color);
        if (place != found.end() && *place == color) continue;
        found.insert(place, color);
        if (found.size() > count) break;
    }
    return found;
}

// Cells of 8 levels a side: fewer samples than any photograph's colours, without moving their means. A pixel weighs as
// much as it is opaque.
std::vector<Sample> samples_of(const Image& image) {
    constexpr int bits = 5, dropped = 8 - bits;
    std::vector<Sample> cells(std::size_t{1} << (3 * bits));
    for (const glm::u8vec4& pixel : image.pixels()) {
        const std::size_t cell = (std::size_t(pixel.x >> dropped) << (2 * bits)) |
                                 (std::size_t(pixel.y >> dropped) << bits) | std::size_t(pixel.z >> dropped);
        const double weight = pixel.w / 255.0;
        cells[cell].color += weight * glm::dvec3(pixel);
        cells[cell].weight += weight;
    }
    std::erase_if(cells, [](const Sample& cell) { return cell.weight == 0; });
    for (Sample& cell : cells) cell.color /= cell.weight;
    return cells;
}

// A box of median cut: a stretch of the samples.
struct Box {
    std::span<Sample> samples;
    glm::dvec3 mean{0.0};
    double spread = 0;  // largest of the sums of squared differences along the three axes
    int axis = 0;       // the one that it lies on

    explicit Box(std::span<Sample> inside) : samples(inside) {
        double weight = 0;
        for (const Sample& sample : samples) {
            mean += sample.weight * sample.color;
            weight += sample.weight;
        }
        mean /= weight;
        glm::dvec3 squares(0.0);
        for (const Sample& sample : samples) {
            squares += sample.weight * (sample.color - mean) * (sample.color - mean);
        }
        axis = squares.x >= squares.y && squares.x >= squares.z ? 0 : squares.y >= squares.z ? 1 : 2;
        spread = squares[axis];
    }

    // How many samples lie in the lower part, so that both parts weigh alike and neither is empty.
    [[nodiscard]] std::size_t median() {
        std::sort(samples.begin(), samples.end(),
                  [this](const Sample& a, const Sample& b) { return a.color[axis] < b.color[axis]; });
        const double half = 0.5 * std::accumulate(samples.begin(), samples.end(), 0.0,
                                                  [](double sum, const Sample& s) { return sum + s.weight; });
        double below = 0;
        std::size_t cut = 0;
        while (cut + 1 < samples.size() && (cut == 0 || below + samples[cut].weight <= half)) {
            below += samples[cut++].weight;
        }
        return cut;
    }
};

std::vector<glm::dvec3> median_cut(std::span<Sample> samples, std::size_t count) {
    std::vector<Box> boxes{Box(samples)};
    while (boxes.size() < count) {
        const auto widest = std::max_element(boxes.begin(), boxes.end(),
                                             [](const Box& a, const Box& b) { return a.spread < b.spread; });
        if (widest->spread <= 0) break;
        const std::size_t cut = widest->median();
        const Box low(widest->samples.first(cut)), high(widest->samples.subspan(cut));
        *widest = low;
        boxes.push_back(high);
    }
    std::vector<glm::dvec3> means;
    for (const Box& box : boxes) means.push_back(box.mean);
    return means;
}

template <typename Color>
std::size_t nearest(const std::vector<Color>& palette, const glm::dvec3& color) {
    std::size_t best = 0;
    double shortest = HUGE_VAL;
    for (std::size_t i = 0; i < palette.size(); ++i) {
        const glm::dvec3 apart = glm::dvec3(palette[i]) - color;
        const double distance = glm::dot(apart, apart);
        if (distance < shortest) {
            shortest = distance;
            best = i;
        }
    }
    return best;
}

// Lloyd's rounds: each sample to its nearest colour, each colour to the mean of its samples.
void refine(std::vector<glm::dvec3>& colors, std::span<const Sample> samples) {
    constexpr int most_rounds = 24;
    constexpr double settled = 0.01;  // levels
    for (int round = 0; round < most_rounds; ++round) {
        std::vector<Sample> sums(colors.size());
        for (const Sample& sample : samples) {
            Sample& sum = sums[nearest(colors, sample.color)];
            sum.color += sample.weight * sample.color;
            sum.weight += sample.weight;
        }
        double moved = 0;
        for (std::size_t i = 0; i < colors.size(); ++i) {
            if (sums[i].weight == 0) continue;
            const glm::dvec3 mean = sums[i].color / sums[i].weight;
            moved = std::max(moved, glm::distance(mean, colors[i]));
            colors[i] = mean;
        }
        if (moved < settled) return;
    }
}

}  // namespace

Palette choose_palette(const Image& image, int count) {
    assert(count >= 1 && count <= most_palette_colors);
    Palette palette;
    const std::vector<std::uint32_t> distinct = distinct_colors(image, std::size_t(count));
    if (distinct.size() <= std::size_t(count)) {
        for (const std::uint32_t color : distinct) palette.emplace_back(color >> 16, color >> 8, color);
        return palette;
    }
    std::vector<Sample> samples = samples_of(image);
    std::vector<glm::dvec3> colors = median_cut(samples, std::size_t(count));
    refine(colors, samples);
    for (const glm::dvec3& color : colors) palette.emplace_back(color + 0.5);
    return palette;
}

Raster<std::uint8_t> nearest_entries(const Image& image, const Palette& palette) {
    assert(!palette.empty() && palette.size() <= std::size_t(most_palette_colors));
    Raster<std::uint8_t> entries(image.width(), image.height());
    parallel_for(std::size_t(image.height()), rows_grain, [&](std::size_t begin, std::size_t end) {
        for (int y = int(begin); y < int(end); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                entries.at(x, y) = std::uint8_t(nearest(palette, glm::dvec3(image.at(x, y))));
            }
        }
    });
    return entries;
}

Raster<std::uint8_t> mode_filtered(const Raster<std::uint8_t>& values, int radius) {
    const int width = values.width(), height = values.height();
    assert(radius <= width && radius <= height);
    Raster<std::uint8_t> filtered(width, height);
    const auto mode_at = [&](int x, int y) {
        std::array<std::uint16_t, 256> counts{};
        std::uint8_t mode = values.at(x, y);
        const auto each_neighbour = [&](const auto& visit) {
            for (int v = y - radius; v <= y + radius; ++v) {
                for (int u = x - radius; u <= x + radius; ++u) {
                    visit(values.at((u + width) % width, (v + height) % height));
                }
            }
        };
        each_neighbour([&](std::uint8_t value) { ++counts[value]; });
        each_neighbour([&](std::uint8_t value) {
            if (counts[value] > counts[mode]) mode = value;
        });
        return mode;
    };
    parallel_for(std::size_t(values.height()), rows_grain, [&](std::size_t begin, std::size_t end) {
        for (int y = int(begin); y < int(end); ++y) {
            for (int x = 0; x < values.width(); ++x) filtered.at(x, y) = mode_at(x, y);
        }
    });
    return filtered;
}

Image with_fewer_colors(const Image& image, int count) {
    if (image.empty()) return image;
    const Palette palette = choose_palette(image, count);
    if (palette.empty()) return image;  // nothing of it shows
    const int radius = std::min({mode_radius, image.width(), image.height()});
    const Raster<std::uint8_t> entries = mode_filtered(nearest_entries(image, palette), radius);
    Image reduced(image.width(), image.height());
    for (std::size_t i = 0; i < reduced.pixels().size(); ++i) {
        reduced.pixels()[i] = glm::u8vec4(palette[entries.pixels()[i]], image.pixels()[i].w);
    }
    return reduced;
}

}  // namespace croquis::image
