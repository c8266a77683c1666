// What lies upon another line is drawn once: edges of two meshes in one place, hidden lines behind visible ones.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "output/plotter.h"
#include "output/plotter_grid.h"

namespace croquis::output {
namespace {

struct Piece {
    glm::dvec2 from, to;
};

/// A stretch of a piece, in shares of its length.
struct Stretch {
    double begin, end;
};

// The stretch of `piece` along which `other` runs, within the tolerance; empty when begin >= end.
Stretch overlap_of(const Piece& piece, const Piece& other, double tolerance) {
    const glm::dvec2 along = piece.to - piece.from;
    const double length = glm::length(along);
    const glm::dvec2 direction = along / length, across(-direction.y, direction.x);
    double s0 = glm::dot(other.from - piece.from, direction), s1 = glm::dot(other.to - piece.from, direction);
    double h0 = glm::dot(other.from - piece.from, across), h1 = glm::dot(other.to - piece.from, across);
    if (s0 > s1) {
        std::swap(s0, s1);
        std::swap(h0, h1);
    }
    const double begin = std::max(0.0, s0), end = std::min(length, s1);
    // Pieces that meet at an angle are near to each other for a moment, but do not run along each other.
    if (end - begin <= 2 * tolerance) return {0, 0};
    const auto height = [&](double s) { return h0 + (h1 - h0) * (s - s0) / (s1 - s0); };
    if (std::abs(height(begin)) > tolerance || std::abs(height(end)) > tolerance) return {0, 0};
    if (std::abs(height(end) - height(begin)) > 0.05 * (end - begin)) return {0, 0};
    return {begin / length, end / length};
}

// What is left of [0, 1] without the stretches.
std::vector<Stretch> gaps_between(std::vector<Stretch> covered) {
    std::sort(covered.begin(), covered.end(), [](const Stretch& a, const Stretch& b) { return a.begin < b.begin; });
    std::vector<Stretch> left;
    double at = 0;
    for (const Stretch& stretch : covered) {
        if (stretch.begin > at) left.push_back({at, stretch.begin});
        at = std::max(at, stretch.end);
    }
    if (at < 1) left.push_back({at, 1});
    return left;
}

class Cutter {
public:
    explicit Cutter(double tolerance) : tolerance_(tolerance), grid_(2.0) {}

    // The parts of a ring that nothing before it has drawn.
    std::vector<Ring> cut(const Ring& ring) {
        std::vector<Ring> parts;
        const std::size_t count = ring.points.size() - (ring.closed ? 0 : 1);
        bool is_whole = true;
        for (std::size_t i = 0; i < count; ++i) {
            const Piece piece{ring.points[i], ring.points[(i + 1) % ring.points.size()]};
            is_whole = add_free(piece, parts) && is_whole;
        }
        if (is_whole) return {ring};
        const bool wraps = ring.closed && parts.size() > 1 && parts.back().points.back() == ring.points.front() &&
                           parts.front().points.front() == ring.points.front();
        if (wraps) {
            parts.back().points.insert(parts.back().points.end(), parts.front().points.begin() + 1,
                                       parts.front().points.end());
            parts.erase(parts.begin());
        }
        return parts;
    }

private:
    // Appends what is free of a piece to the last part, or as new parts; true when all of it is.
    bool add_free(const Piece& piece, std::vector<Ring>& parts) {
        if (piece.from == piece.to) return true;
        const double length = glm::distance(piece.from, piece.to);
        std::vector<Stretch> covered;
        grid_.for_near(piece.from, piece.to, [&](std::uint32_t number) {
            const Stretch stretch = overlap_of(piece, drawn_[number], tolerance_);
            if (stretch.end > stretch.begin) covered.push_back(stretch);
        });
        const auto point = [&](double share) {
            return share <= 0 ? piece.from : share >= 1 ? piece.to : piece.from + share * (piece.to - piece.from);
        };
        bool is_whole = covered.empty();
        for (const Stretch& left : gaps_between(std::move(covered))) {
            if ((left.end - left.begin) * length <= tolerance_ && !is_whole) continue;
            const Piece part{point(left.begin), point(left.end)};
            if (!parts.empty() && parts.back().points.back() == part.from) {
                parts.back().points.push_back(part.to);
            } else {
                parts.push_back({{part.from, part.to}, false});
            }
            grid_.add(std::uint32_t(drawn_.size()), part.from, part.to);
            drawn_.push_back(part);
        }
        return is_whole;
    }

    double tolerance_;
    SheetGrid grid_;
    std::vector<Piece> drawn_;
};

}  // namespace

void drop_overlaps(std::vector<Ring>& rings, double overlap_tolerance) {
    Cutter cutter(overlap_tolerance);
    std::vector<Ring> parts;
    for (const Ring& ring : rings) {
        if (ring.points.size() < 2) continue;
        for (Ring& part : cutter.cut(ring)) parts.push_back(std::move(part));
    }
    rings = std::move(parts);
}

}  // namespace croquis::output
