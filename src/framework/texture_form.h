// How the image that a texture variable names becomes a texture: the property `form` of the variable.
#pragma once

#include <optional>
#include <string_view>

namespace croquis::framework {

enum class TextureForm {
    flat,    ///< as it is (sampler2D)
    volume,  ///< square slices below each other, the first at the top (sampler3D)
    tonal,   ///< tones of strokes, each with its smaller sizes: framework/tonal_image.h (sampler2DArray)
};

[[nodiscard]] inline std::optional<TextureForm> texture_form_named(std::string_view name) {
    if (name == "flat") return TextureForm::flat;
    if (name == "volume") return TextureForm::volume;
    if (name == "tonal") return TextureForm::tonal;
    return std::nullopt;
}

}  // namespace croquis::framework
