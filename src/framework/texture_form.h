// How the image that a texture variable names becomes a texture: the property `form` of the variable.
#pragma once

#include <array>
#include <string_view>

namespace croquis::framework {

enum class TextureForm {
    flat,    ///< as it is (sampler2D)
    volume,  ///< square slices below each other, the first at the top (sampler3D)
    tonal,   ///< tones of strokes, each with its smaller sizes: framework/sliced_image.h (sampler2DArray)
};

/// The words of the property, in the order of the forms.
inline constexpr std::array<std::string_view, 3> texture_forms{"flat", "volume", "tonal"};

}  // namespace croquis::framework
