// What a line looks like as a stroke (seed D, section 4; seed E, 10.4; SPEC rows L9 and L11). The file format, and what
// each setting does, is described in docs/strokes.md.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lines/drawing.h"
#include "lines/stroke.h"
#include "lines/stroke_offsets.h"

namespace croquis::lines {

/// A length with its unit.
struct Length {
    enum class Unit : std::uint8_t {
        pixels,       ///< px: of the drawing at scale 1, 96 to the inch
        millimetres,  ///< mm
        widths,       ///< w: times the line's own width, which its class gives
        share,        ///< %: of the line's length
    };
    double value = 0;  ///< of shares: 0 to 1
    Unit unit = Unit::pixels;

    bool operator==(const Length&) const = default;
};

constexpr double pixels_per_mm = 96 / 25.4;

/// What turns lengths into pixels of the drawing.
struct LengthScale {
    double pixel = 1;  ///< pixels of the drawing to a pixel of the style
    double width = 1;  ///< of the line, pixels of the drawing
    double line = 0;   ///< length of the line, pixels of the drawing
};

[[nodiscard]] double pixels_of(const Length& length, const LengthScale& scale);

/// A displacement by Perlin noise of the place in the picture, so that neighbouring strokes move alike.
struct Wobble {
    Length across;       ///< at most, along the line's normal
    Length along;        ///< at most, along its tangent
    Length every{30.0};  ///< the size of one wiggle: the noise's lattice
    bool operator==(const Wobble&) const = default;
};

/// A variation by noise of the place in the picture.
struct Variation {
    double amount = 0;  ///< at most: a share of the value
    Length every{30.0};
    bool operator==(const Variation&) const = default;
};

/// Factors of the width at two ends of a scale, and linear between.
struct WidthRange {
    double from = 1;
    double to = 1;
    bool operator==(const WidthRange&) const = default;
};

/// How an offset pattern runs along a line.
enum class OffsetRun : std::uint8_t {
    repeat,  ///< at its own size, from the beginning; cut off where the line ends
    fit,     ///< scaled so that a whole number of patterns fills the line
    once,    ///< scaled so that one pattern fills the line
};

/// How lines are drawn as strokes. The defaults draw them plainly: even, black, with round ends.
struct StrokeStyle {
    std::string help;

    Length width{1.0, Length::Unit::widths};
    Length full_width_from;  ///< lines shorter than that are thinner, in proportion
    glm::vec3 color{0.0f};
    float opacity = 1;
    StrokeEnds ends = StrokeEnds::round;
    std::string texture;  ///< Brush::texture

    Length taper_start, taper_end;   ///< of open lines; they never take more than the whole line together
    double taper_to = 0;             ///< width at the very end, a share of the full one
    Length overshoot;                ///< how far open ends go on, straight; at most a quarter of the line
    double overshoot_variation = 0;  ///< share of it that differs from end to end

    std::optional<WidthRange> width_by_light;  ///< from where the surface is turned from the light to where it faces it
    std::optional<WidthRange> width_by_depth;  ///< from the nearest point of the drawing to the farthest
    Variation vary_width, vary_opacity, vary_color;

    std::vector<Wobble> wobbles;
    std::uint32_t passes = 1;            ///< how often the line is drawn over, each time with other noise
    std::optional<double> corner_angle;  ///< radians: lines break where they turn by more

    std::vector<Length> dash;  ///< on, off, on, off …; empty: unbroken
    bool dash_fit = false;     ///< scaled so that open lines end with a dash, closed ones with a gap

    std::string offsets;                           ///< the name of the offset file; empty: none
    std::shared_ptr<const OffsetPattern> pattern;  ///< what that file says; StrokeStyles reads it
    double offset_scale = 1;
    OffsetRun offset_run = OffsetRun::repeat;

    /// The styles of lines behind 1, 2, and 3 or more layers. Where one is empty, the one before it counts.
    std::array<std::string, 3> hidden_styles;
    /// The styles of classes of visible lines that are drawn otherwise.
    std::array<std::string, line_class_count> class_styles;
};

/// Reads the text of a style file. Names of other files are kept as they are. Throws Error at a line and column of
/// `file_name`.
[[nodiscard]] StrokeStyle read_stroke_style(std::string_view text, const std::string& file_name);

/// The style of each line of a drawing, by its class and by how many layers hide it.
struct StyleSet {
    std::array<StrokeStyle, line_class_count> visible;
    std::array<StrokeStyle, 3> hidden;  ///< behind 1, 2, and 3 or more layers

    /// Plain lines; hidden ones dashed.
    StyleSet();
    /// One style for all visible lines; hidden ones dashed.
    explicit StyleSet(const StrokeStyle& style);

    [[nodiscard]] const StrokeStyle& style_of(const Line& line) const;
};

/// Hidden lines after ISO 128-20, line 02: dashes of 12 widths, gaps of 3.
[[nodiscard]] StrokeStyle dashed_style();

}  // namespace croquis::lines
