// A stroke style made ready for drawing: noise seeded, brush known; and the drawing of one line with it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lines/stroke.h"
#include "lines/stroke_noise.h"
#include "lines/stroke_spine.h"
#include "lines/stroke_style.h"

namespace croquis::lines {

/// Strokes as they come from one pen or several; points are counted from the first of `points`.
struct StrokePieces {
    std::vector<Stroke> strokes;
    std::vector<StrokePoint> points;
};

/// What the drawing as a whole gives to every pen.
struct PenSettings {
    double scale = 1;  ///< StrokeOptions::scale
    double nearest = 0, farthest = 0;
    std::uint64_t seed = 0;
};

/// The frame of a line turns over this many pixels of the style to each side of a corner.
constexpr double frame_reach = 2;

/// Draws lines in one style. Immutable; shared between threads.
class Pen {
public:
    Pen(const StrokeStyle& style, std::uint32_t brush, const PenSettings& settings);

    [[nodiscard]] const StrokeStyle& style() const { return *style_; }

    /// Room for the work on one line after the other.
    struct Desk {
        Spine spine;
        std::vector<double> marks;
        struct Sample {
            double along;
            glm::dvec2 offset;  // along tangent and normal, pixels
            bool joined;        // to the sample before
        };
        std::vector<Sample> samples;
    };

    /// Draws a line, whose class gives it a width in pixels, as often as the style says.
    void draw(std::span<const SpinePoint> points, bool closed, double class_width, std::uint32_t line, Desk& desk,
              StrokePieces& out) const;

private:
    // The noises of one pass over the line.
    struct Pass {
        std::vector<PerlinNoise> wobbles;
        PerlinNoise width, opacity, color, ends;
    };
    // The style's lengths for one line, in pixels of the drawing.
    struct Measures {
        double width, taper_start, taper_end, step;
    };

    [[nodiscard]] Measures measures_of(const Spine& spine, double class_width) const;
    void overshoot(const Pass& pass, double width, Spine& spine) const;
    void sample(const Measures& measures, Desk& desk) const;
    void sample_dashes(const Measures& measures, Desk& desk) const;
    void sample_offsets(const Measures& measures, Desk& desk) const;
    [[nodiscard]] StrokePoint point_at(const SpinePoint& base, const Desk::Sample& sample, const Measures& measures,
                                       const Pass& pass, const Spine& spine) const;
    void displace(const SpinePoint& base, const Desk::Sample& sample, const Measures& measures, const Pass& pass,
                  const Spine& spine, StrokePoint& point) const;
    void emit_vertices(const Measures& measures, const Pass& pass, std::uint32_t line, const Spine& spine,
                       StrokePieces& out) const;
    void emit_samples(const Measures& measures, const Pass& pass, std::uint32_t line, const Desk& desk,
                      StrokePieces& out) const;

    const StrokeStyle* style_;
    std::uint32_t brush_;
    PenSettings settings_;
    std::vector<Pass> passes_;
    double noise_step_ = 0;  // pixels between samples that follow the noise; 0: there is none
};

}  // namespace croquis::lines
