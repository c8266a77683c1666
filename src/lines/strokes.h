// From lines to strokes: styles by class and layers, width by light and depth, tapers, dashes, offsets and noise
// (seed D, section 4; seed E, 10.4).
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>

#include "lines/drawing.h"
#include "lines/stroke.h"
#include "lines/stroke_style.h"

namespace croquis::lines {

/// The widths of lines by class, in pixels: info_of(class).width_mm at 96 pixels to the inch.
[[nodiscard]] std::array<double, line_class_count> default_widths();

/// Two eye distances, in scene units.
struct DepthRange {
    double nearest = 0;
    double farthest = 0;
};

/// How a drawing becomes strokes.
struct StrokeOptions {
    StyleSet styles;
    std::array<double, line_class_count> widths = default_widths();  ///< by class, pixels at scale 1
    double hidden_width = hidden_width_mm * pixels_per_mm;           ///< pixels at scale 1
    double scale = 1;  ///< pixels of the drawing to a pixel of widths and styles: 2 where each pixel is drawn as 4
    glm::vec3 light{-0.4f, 0.6f, 0.7f};     ///< towards the light, world axes; of any length
    std::optional<DepthRange> depth_range;  ///< for widths by depth; the drawing's own where not given
    std::uint64_t seed = 0;
    bool hidden = true;  ///< lines that are hidden are drawn too
};

/// The strokes of a drawing, sorted for painting. Uses several threads; the result does not depend on how many. Lines
/// with points that are not finite are left out.
[[nodiscard]] Strokes make_strokes(const Drawing& drawing, const StrokeOptions& options);

/// True when a stroke has one width and one colour and no texture: a plain path of that width draws it.
[[nodiscard]] bool is_even(const Strokes& strokes, const Stroke& stroke);

}  // namespace croquis::lines
