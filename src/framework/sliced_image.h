// Images that hold several: slices of a volume, and the tones of a tonal art map (Praun and others, 2001).
#pragma once

#include <string>
#include <vector>

#include "gpu/texture.h"
#include "image/image.h"

namespace croquis::framework {

/// The slices of a volume: two or more squares below each other, the first at the top. Throws Error, led by `name`, for
/// an image that cannot be cut so.
[[nodiscard]] gpu::Slices cut_volume(const image::Image& image, const std::string& name);

/// The mip levels of a tonal art map. The image holds 3 n + 1 tones below each other, from white to black, each a
/// square with a power of two a side, and to its right its smaller sizes, halved down to one pixel: twice as wide as
/// high.
///
/// Layer j of a level has the tones 3 j to 3 j + 3 in its channels, of each its red. So a pixel's two neighbouring
/// tones always stand in one layer, and are one fetch. Throws Error, led by `name`, for an image that cannot be cut so.
[[nodiscard]] std::vector<gpu::Slices> cut_tonal(const image::Image& image, const std::string& name);

}  // namespace croquis::framework
