// A component for tests that stands for a rendering pass: a generated texture with given content.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <variant>

#include "framework/component.h"
#include "image/image.h"

namespace croquis::test_support {

using DepthValues = image::Raster<std::uint32_t>;  ///< 24-bit depth buffer values

constexpr std::uint32_t largest_depth = (1u << 24) - 1u;

/// What the passes of component test_source hand on, by the name of their texture.
using Sources = std::map<std::string, std::variant<image::Image, DepthValues>>;

/// Makes the component. `sources` must outlive it.
[[nodiscard]] framework::CreateComponent test_source(const Sources& sources);

}  // namespace croquis::test_support
