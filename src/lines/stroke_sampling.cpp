#include "lines/stroke_sampling.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace croquis::lines {
namespace {

constexpr double same_place = 1e-9;
constexpr double steps_a_taper = 8;
constexpr double shortest_step = 0.5;       // pixels
constexpr double finest_dashes = 0.25;      // pixels
constexpr double most_points_a_pixel = 16;  // of an offset pattern

// The largest step at an arc length.
double step_at(double along, double line_length, const MarkRequest& request) {
    double step = request.step > 0 ? request.step : line_length;
    if (along < request.taper_start) step = std::min(step, request.taper_start / steps_a_taper);
    if (along > line_length - request.taper_end) step = std::min(step, request.taper_end / steps_a_taper);
    return std::max(step, shortest_step);
}

OffsetPoint scaled(const OffsetPoint& point, double scale, double start) {
    return {start + scale * point.along, scale * point.tangent, scale * point.normal, point.joined};
}

OffsetPoint cut(const OffsetPoint& a, const OffsetPoint& b, double along) {
    const double t = (along - a.along) / (b.along - a.along);
    return {along, a.tangent + t * (b.tangent - a.tangent), a.normal + t * (b.normal - a.normal), true};
}

}  // namespace

void mark(const Spine& spine, const MarkRequest& request, std::vector<double>& marks) {
    const std::span<const double> along = spine.along();
    const double line_length = spine.length();
    marks.clear();
    marks.push_back(request.begin);
    const auto go_on_to = [&](double next) {
        const double last = marks.back();
        if (next <= last + same_place) return;
        const double step = step_at(0.5 * (last + next), line_length, request);
        const double count = std::ceil((next - last) / step - same_place);
        for (double i = 1; i < count; ++i) marks.push_back(last + (next - last) * i / count);
        marks.push_back(next);
    };

    double breaks[2] = {request.taper_start, line_length - request.taper_end};
    if (request.taper_start <= 0) breaks[0] = 0;
    std::size_t next_break = 0;
    auto vertex = std::upper_bound(along.begin(), along.end(), request.begin);
    for (; vertex != along.end() && *vertex < request.end; ++vertex) {
        for (; next_break < 2 && breaks[next_break] <= *vertex; ++next_break) go_on_to(breaks[next_break]);
        go_on_to(*vertex);
    }
    for (; next_break < 2 && breaks[next_break] < request.end; ++next_break) go_on_to(breaks[next_break]);
    go_on_to(request.end);
    marks.back() = request.end;
}

void fit_dashes(std::vector<double>& lengths, double line_length, bool closed) {
    const double period = std::accumulate(lengths.begin(), lengths.end(), 0.0);
    if (period < finest_dashes) return;
    const double tail = closed ? 0 : lengths.front();
    const double repeats = std::round((line_length - tail) / period);
    if (repeats < 1) {
        lengths = {line_length, 0};
        return;
    }
    const double scale = line_length / (repeats * period + tail);
    for (double& length : lengths) length *= scale;
}

std::vector<Stretch> dashes(const std::vector<double>& lengths, double line_length) {
    const double period = std::accumulate(lengths.begin(), lengths.end(), 0.0);
    if (period < finest_dashes) return {{0, line_length}};
    std::vector<Stretch> found;
    for (double repeat = 0; repeat * period < line_length - same_place; ++repeat) {
        double begin = repeat * period;
        for (std::size_t i = 0; i < lengths.size() && begin < line_length - same_place; i += 2) {
            const double end = std::min(begin + lengths[i], line_length);
            if (end > begin) found.push_back({begin, end});
            begin += lengths[i] + lengths[i + 1];
        }
    }
    return found;
}

double fitted_scale(const OffsetPattern& pattern, double scale, OffsetRun run, double line_length) {
    const double finest = static_cast<double>(pattern.points.size()) / (most_points_a_pixel * pattern.length);
    scale = std::max(scale, finest);
    if (run == OffsetRun::repeat) return scale;
    const double repeats =
        run == OffsetRun::once ? 1 : std::max(1.0, std::round(line_length / (scale * pattern.length)));
    return std::max(line_length / (repeats * pattern.length), finest);
}

std::vector<OffsetPiece> offset_pieces(const OffsetPattern& pattern, double scale, double line_length) {
    std::vector<OffsetPiece> pieces;
    const double period = scale * pattern.length;
    OffsetPoint before;
    bool is_first = true, is_joined = false;
    for (double repeat = 0; repeat * period < line_length - same_place; ++repeat) {
        for (const OffsetPoint& point : pattern.points) {
            const OffsetPoint next = scaled(point, scale, repeat * period);
            const bool draws = !is_first && point.joined;
            OffsetPiece piece{before, next, is_joined};
            is_joined = false;
            if (draws && std::min(before.along, next.along) <= line_length) {
                if (next.along > line_length) piece.end = cut(before, next, line_length);
                if (before.along > line_length) piece.begin = cut(before, next, line_length);
                piece.joined = piece.joined && before.along <= line_length;
                pieces.push_back(piece);
                is_joined = true;
            }
            before = next;
            is_first = false;
        }
    }
    return pieces;
}

}  // namespace croquis::lines
