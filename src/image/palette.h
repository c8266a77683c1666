// Fewer colours in a picture, in flat areas: what makes a photographed texture fit for a comic (seed A, 3.6.4).
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "image/image.h"

namespace croquis::image {

using Palette = std::vector<glm::u8vec3>;

constexpr int most_palette_colors = 256;

/// At most `count` colours for an image: median cut (Heckbert, Color image quantization for frame buffer display,
/// 1982), refined by k-means. Pixels weigh as much as they are opaque. An image of no more colours gives
/// exactly its own, none if it is transparent all over. `count` is 1 to `most_palette_colors`.
[[nodiscard]] Palette choose_palette(const Image& image, int count);

/// The place of the palette's nearest colour for each pixel.
[[nodiscard]] Raster<std::uint8_t> nearest_entries(const Image& image, const Palette& palette);

/// Gives each pixel the value that most pixels within `radius` of it have, its own where that is one of the most
/// frequent. So specks and ragged borders go and areas become flat. The values repeat at the borders, as textures do;
/// `radius` is at most their width and height.
[[nodiscard]] Raster<std::uint8_t> mode_filtered(const Raster<std::uint8_t>& values, int radius);

/// The image in at most `count` colours and in flat areas. Alpha stays as it is.
[[nodiscard]] Image with_fewer_colors(const Image& image, int count);

}  // namespace croquis::image
