#include "framework/sliced_image.h"

#include <bit>

#include "base/error.h"

namespace croquis::framework {
namespace {

constexpr int tones_between_layers = 3;  // four in each, the last of one is the first of the next

constexpr double most_off = 1;  // that white and black may be, in levels of 0 to 255

void add(gpu::Slices& slices, const glm::u8vec4& pixel) {
    for (int channel = 0; channel < 4; ++channel) slices.pixels.push_back(pixel[channel]);
}

// A square of four tones: those of `size` pixels a side that stand from column `left` on.
void add_layer(gpu::Slices& level, const image::Image& image, int first_tone, int left) {
    const int tone_height = image.width() / 2;
    for (int y = 0; y < level.height; ++y) {
        for (int x = 0; x < level.width; ++x) {
            glm::u8vec4 tones;
            for (int i = 0; i < 4; ++i) tones[i] = image.at(left + x, (first_tone + i) * tone_height + y).x;
            add(level, tones);
        }
    }
}

// Of its largest size.
double mean_of_tone(const image::Image& image, int tone) {
    const int side = image.width() / 2;
    double sum = 0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) sum += image.at(x, tone * side + y).x;
    }
    return sum / (double(side) * side);
}

}  // namespace

gpu::Slices cut_volume(const image::Image& image, const std::string& name) {
    const int side = image.width();
    if (image.height() % side != 0 || image.height() < 2 * side) {
        fail("{}: expected two or more square slices of a volume below each other, found {} x {} pixels", name, side,
             image.height());
    }
    gpu::Slices slices{{}, side, side, image.height() / side};
    slices.pixels.reserve(image.pixels().size_bytes());
    for (const glm::u8vec4& pixel : image.pixels()) add(slices, pixel);
    return slices;
}

std::vector<gpu::Slices> cut_tonal(const image::Image& image, const std::string& name) {
    const int side = image.width() / 2;
    const int tones = side > 0 ? image.height() / side : 0;
    if (!std::has_single_bit(unsigned(image.width())) || side < 1 || image.height() != tones * side || tones < 4 ||
        tones % tones_between_layers != 1) {
        fail(
            "{}: expected 4, 7, 10, ... tones below each other, each half as high as the image is wide, and that a "
            "power of two; found {} x {} pixels",
            name, image.width(), image.height());
    }
    const double first = mean_of_tone(image, 0), last = mean_of_tone(image, tones - 1);
    if (first < 255 - most_off || last > most_off) {
        fail("{}: expected tones from white (255) to black (0), found {:.1f} to {:.1f}", name, first, last);
    }
    std::vector<gpu::Slices> levels;
    int left = 0;
    for (int size = side; size >= 1; size /= 2) {
        gpu::Slices& level = levels.emplace_back(gpu::Slices{{}, size, size, tones / tones_between_layers});
        for (int layer = 0; layer < level.count; ++layer) add_layer(level, image, layer * tones_between_layers, left);
        left += size;
    }
    return levels;
}

}  // namespace croquis::framework
