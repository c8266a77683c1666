#include "lines/stroke_pen.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "lines/stroke_sampling.h"

namespace croquis::lines {
namespace {

constexpr double steps_a_wiggle = 6;
constexpr double most_overshoot = 0.25;  // of a line's length, at each end
constexpr double shortest_step = 0.5;    // pixels of the style

// Lengths of noise are in px or mm: they do not depend on the line.
double wiggle_pixels(const Length& every, double scale) { return pixels_of(every, {scale, 1, 0}); }

double factor_at(const WidthRange& range, double t) { return glm::mix(range.from, range.to, glm::clamp(t, 0.0, 1.0)); }

// -1 to 1 for a place.
double variation_at(const PerlinNoise& noise, const Variation& variation, const glm::dvec2& place, double scale) {
    return variation.amount * noise.at(place / wiggle_pixels(variation.every, scale)).x;
}

// From a pointed end to the full width as a quarter of a sine, so that it comes in without a shoulder.
double taper_at(double from_end, double taper, double least) {
    if (from_end >= taper) return 1;
    return glm::mix(least, 1.0, std::sin(std::numbers::pi / 2 * from_end / taper));
}

}  // namespace

Pen::Pen(const StrokeStyle& style, std::uint32_t brush, const PenSettings& settings)
    : style_(&style), brush_(brush), settings_(settings) {
    const std::uint64_t seed = settings.seed;
    for (std::uint32_t pass = 0; pass < style.passes; ++pass) {
        const auto noise = [&](const char* what) { return PerlinNoise(seed, fmt::format("stroke {} {}", what, pass)); };
        Pass made{{}, noise("width"), noise("opacity"), noise("color"), noise("ends")};
        for (std::size_t layer = 0; layer < style.wobbles.size(); ++layer) {
            made.wobbles.emplace_back(seed, fmt::format("stroke wobble {} {}", pass, layer));
        }
        passes_.push_back(std::move(made));
    }

    double finest = std::numeric_limits<double>::infinity();
    for (const Wobble& wobble : style.wobbles) finest = std::min(finest, wiggle_pixels(wobble.every, settings.scale));
    for (const Variation* variation : {&style.vary_width, &style.vary_opacity, &style.vary_color}) {
        if (variation->amount > 0) finest = std::min(finest, wiggle_pixels(variation->every, settings.scale));
    }
    if (std::isfinite(finest)) noise_step_ = std::max(finest / steps_a_wiggle, shortest_step * settings.scale);
}

void Pen::draw(std::span<const SpinePoint> points, bool closed, double class_width, std::uint32_t line, Desk& desk,
               StrokePieces& out) const {
    for (const Pass& pass : passes_) {
        desk.spine.assign(points, closed);
        if (!desk.spine.is_usable()) return;
        if (style_->overshoot.value > 0) overshoot(pass, measures_of(desk.spine, class_width).width, desk.spine);
        const Measures measures = measures_of(desk.spine, class_width);
        const bool has_tapers = measures.taper_start > 0 || measures.taper_end > 0;
        if (!style_->pattern && style_->dash.empty() && noise_step_ == 0 && !has_tapers) {
            emit_vertices(measures, pass, line, desk.spine, out);
            continue;
        }
        desk.samples.clear();
        if (style_->pattern) {
            sample_offsets(measures, desk);
        } else if (!style_->dash.empty()) {
            sample_dashes(measures, desk);
        } else {
            sample(measures, desk);
        }
        emit_samples(measures, pass, line, desk, out);
    }
}

Pen::Measures Pen::measures_of(const Spine& spine, double class_width) const {
    LengthScale scale{settings_.scale, class_width, spine.length()};
    scale.width = pixels_of(style_->width, scale);  // what w means from here on
    const double full_from = pixels_of(style_->full_width_from, scale);
    if (spine.length() < full_from) scale.width *= spine.length() / full_from;
    Measures measures{scale.width, 0, 0, noise_step_};
    if (spine.closed()) return measures;
    measures.taper_start = pixels_of(style_->taper_start, scale);
    measures.taper_end = pixels_of(style_->taper_end, scale);
    const double both = measures.taper_start + measures.taper_end;
    if (both > spine.length()) {
        measures.taper_start *= spine.length() / both;
        measures.taper_end *= spine.length() / both;
    }
    return measures;
}

void Pen::overshoot(const Pass& pass, double width, Spine& spine) const {
    if (spine.closed()) return;
    const double asked = pixels_of(style_->overshoot, {settings_.scale, width, spine.length()});
    const double full = std::min(asked, most_overshoot * spine.length());
    const auto at_end = [&](const SpinePoint& end) {
        constexpr double every = 17;  // pixels of the style: ends that far apart differ
        const double noise = pass.ends.at(end.position / (every * settings_.scale)).x;
        return full * (1 - style_->overshoot_variation * (0.5 + 0.5 * noise));
    };
    const std::span<const SpinePoint> vertices = spine.vertices();
    spine.extend(at_end(vertices.front()), at_end(vertices.back()), frame_reach * settings_.scale);
}

void Pen::sample(const Measures& measures, Desk& desk) const {
    const double length = desk.spine.length();
    mark(desk.spine, {0, length, measures.taper_start, measures.taper_end, measures.step}, desk.marks);
    for (const double along : desk.marks) desk.samples.push_back({along, {0, 0}, along > 0});
}

void Pen::sample_dashes(const Measures& measures, Desk& desk) const {
    const Spine& spine = desk.spine;
    std::vector<double> lengths;
    for (const Length& length : style_->dash) {
        lengths.push_back(pixels_of(length, {settings_.scale, measures.width, spine.length()}));
    }
    if (style_->dash_fit) fit_dashes(lengths, spine.length(), spine.closed());
    for (const Stretch& dash : dashes(lengths, spine.length())) {
        mark(spine, {dash.begin, dash.end, measures.taper_start, measures.taper_end, measures.step}, desk.marks);
        bool joined = false;
        for (const double along : desk.marks) {
            desk.samples.push_back({along, {0, 0}, joined});
            joined = true;
        }
    }
}

void Pen::sample_offsets(const Measures& measures, Desk& desk) const {
    const Spine& spine = desk.spine;
    const OffsetPattern& pattern = *style_->pattern;
    double scale = style_->offset_scale * settings_.scale;
    scale = fitted_scale(pattern, scale, style_->offset_run, spine.length());
    for (const OffsetPiece& piece : offset_pieces(pattern, scale, spine.length())) {
        if (!piece.joined) {
            desk.samples.push_back({piece.begin.along, {piece.begin.tangent, piece.begin.normal}, false});
        }
        const double span = piece.end.along - piece.begin.along;
        if (span == 0) {
            desk.samples.push_back({piece.end.along, {piece.end.tangent, piece.end.normal}, true});
            continue;
        }
        const double low = std::min(piece.begin.along, piece.end.along);
        const double high = std::max(piece.begin.along, piece.end.along);
        mark(spine, {low, high, measures.taper_start, measures.taper_end, measures.step}, desk.marks);
        if (span < 0) std::reverse(desk.marks.begin(), desk.marks.end());
        for (std::size_t i = 1; i < desk.marks.size(); ++i) {
            const double t = (desk.marks[i] - piece.begin.along) / span;
            desk.samples.push_back({desk.marks[i],
                                    {glm::mix(piece.begin.tangent, piece.end.tangent, t),
                                     glm::mix(piece.begin.normal, piece.end.normal, t)},
                                    true});
        }
    }
}

void Pen::displace(const SpinePoint& base, const Desk::Sample& sample, const Measures& measures, const Pass& pass,
                   const Spine& spine, StrokePoint& point) const {
    const double scale = settings_.scale;
    const glm::dvec2 tangent = spine.tangent(sample.along, frame_reach * scale);
    const glm::dvec2 normal = left_of(tangent);
    point.position += sample.offset.x * tangent + sample.offset.y * normal;
    const LengthScale lengths{scale, measures.width, spine.length()};
    for (std::size_t i = 0; i < style_->wobbles.size(); ++i) {
        const Wobble& wobble = style_->wobbles[i];
        const glm::dvec2 noise = pass.wobbles[i].at(base.position / wiggle_pixels(wobble.every, scale));
        point.position += pixels_of(wobble.along, lengths) * glm::dot(noise, tangent) * tangent +
                          pixels_of(wobble.across, lengths) * glm::dot(noise, normal) * normal;
    }
}

StrokePoint Pen::point_at(const SpinePoint& base, const Desk::Sample& sample, const Measures& measures,
                          const Pass& pass, const Spine& spine) const {
    const StrokeStyle& style = *style_;
    const double scale = settings_.scale;
    StrokePoint point;
    point.position = base.position;
    point.depth = static_cast<float>(base.depth);
    if (sample.offset != glm::dvec2(0) || !style.wobbles.empty()) displace(base, sample, measures, pass, spine, point);

    double width = measures.width;
    if (!spine.closed()) {
        width *= taper_at(sample.along, measures.taper_start, style.taper_to) *
                 taper_at(spine.length() - sample.along, measures.taper_end, style.taper_to);
    }
    if (style.width_by_light) width *= factor_at(*style.width_by_light, base.light);
    if (style.width_by_depth && settings_.farthest > settings_.nearest) {
        const double t = (base.depth - settings_.nearest) / (settings_.farthest - settings_.nearest);
        width *= factor_at(*style.width_by_depth, t);
    }
    glm::vec3 color = style.color;
    double opacity = style.opacity;
    if (style.vary_width.amount > 0) width *= 1 + variation_at(pass.width, style.vary_width, base.position, scale);
    if (style.vary_opacity.amount > 0) {
        opacity *= 1 - std::abs(variation_at(pass.opacity, style.vary_opacity, base.position, scale));
    }
    if (style.vary_color.amount > 0) {
        const double shift = variation_at(pass.color, style.vary_color, base.position, scale);
        color = glm::mix(color, glm::vec3(shift > 0 ? 1.0f : 0.0f), static_cast<float>(std::abs(shift)));
    }
    point.width = static_cast<float>(width);
    point.color = glm::vec4(color, static_cast<float>(opacity));
    return point;
}

void Pen::emit_vertices(const Measures& measures, const Pass& pass, std::uint32_t line, const Spine& spine,
                        StrokePieces& out) const {
    const std::size_t count = spine.vertices().size() - (spine.closed() ? 1 : 0);
    out.strokes.push_back({line, spine.closed(), static_cast<std::uint32_t>(out.points.size()),
                           static_cast<std::uint32_t>(count), brush_});
    for (std::size_t i = 0; i < count; ++i) {
        const double along = spine.along()[i];
        out.points.push_back(point_at(spine.vertices()[i], {along, {0, 0}, i > 0}, measures, pass, spine));
        out.points.back().along = static_cast<float>(along);
    }
}

void Pen::emit_samples(const Measures& measures, const Pass& pass, std::uint32_t line, const Desk& desk,
                       StrokePieces& out) const {
    const Spine& spine = desk.spine;
    const bool closed = spine.closed() && !style_->pattern && style_->dash.empty();
    const std::size_t count = desk.samples.size() - (closed ? 1 : 0);  // the first one's repetition
    for (std::size_t i = 0; i < count; ++i) {
        const Desk::Sample& sample = desk.samples[i];
        StrokePoint point = point_at(spine.at(sample.along), sample, measures, pass, spine);
        if (i == 0 || !sample.joined) {
            out.strokes.push_back({line, closed, static_cast<std::uint32_t>(out.points.size()), 0, brush_});
        } else {
            const StrokePoint& before = out.points.back();
            point.along = before.along + static_cast<float>(glm::distance(before.position, point.position));
        }
        out.points.push_back(point);
        ++out.strokes.back().point_count;
    }
}

}  // namespace croquis::lines
