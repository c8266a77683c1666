// The words for blends in descriptors.
#pragma once

#include <string_view>

#include "gpu/state.h"

namespace croquis::components {

/// The blend for one of the choices "none", "over", "multiply", "screen" and "add".
[[nodiscard]] inline gpu::Blend blend_named(std::string_view word) {
    if (word == "over") return gpu::Blend::over;
    if (word == "multiply") return gpu::Blend::multiply;
    if (word == "screen") return gpu::Blend::screen;
    if (word == "add") return gpu::Blend::add;
    return gpu::Blend::off;
}

}  // namespace croquis::components
