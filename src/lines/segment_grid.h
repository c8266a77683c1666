// The straight pieces of a drawing's visible lines, found by place.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <unordered_map>
#include <vector>

#include "lines/drawing.h"

namespace croquis::lines {

class SegmentGrid {
public:
    /// The nearest point of a piece.
    struct Nearest {
        std::uint32_t line = 0;
        std::uint32_t segment = 0;  ///< starts at this point of the line
        double share = 0;           ///< of the segment
        double distance = 0;        ///< pixels
    };

    /// Built for questions with a radius of about `radius` pixels.
    SegmentGrid(const Drawing& drawing, double radius) : drawing_(drawing), cell_(4.0 * std::max(radius, 0.5)) {
        for (std::uint32_t l = 0; l < drawing.lines.size(); ++l) {
            if (drawing.lines[l].visible()) insert(l);
        }
    }

    /// Calls visit(Nearest) for every piece within `radius` of a point; perhaps more than once, and for some farther
    /// ones.
    template <typename Visit>
    void visit_near(const glm::dvec2& point, double radius, const Visit& visit) const {
        for (long row = cell(point.y - radius); row <= cell(point.y + radius); ++row) {
            for (long column = cell(point.x - radius); column <= cell(point.x + radius); ++column) {
                const auto found = cells_.find(key(column, row));
                if (found == cells_.end()) continue;
                for (const auto& [line, segment] : found->second) visit(nearest(line, segment, point));
            }
        }
    }

private:
    [[nodiscard]] long cell(double value) const { return static_cast<long>(std::floor(value / cell_)); }
    static std::uint64_t key(long column, long row) {
        return static_cast<std::uint64_t>(static_cast<std::uint32_t>(column)) << 32 | static_cast<std::uint32_t>(row);
    }

    void insert(std::uint32_t line) {
        const auto points = drawing_.points_of(drawing_.lines[line]);
        for (std::uint32_t i = 0; i + 1 < points.size(); ++i) {
            const glm::dvec2 a = points[i].position, b = points[i + 1].position;
            const auto steps = static_cast<std::uint32_t>(glm::distance(a, b) / cell_) + 1;
            std::uint64_t last = ~std::uint64_t{0};
            for (std::uint32_t s = 0; s <= 2 * steps; ++s) {
                const glm::dvec2 p = glm::mix(a, b, double(s) / (2.0 * steps));
                const std::uint64_t here = key(cell(p.x), cell(p.y));
                if (here != last) cells_[here].push_back({line, i});
                last = here;
            }
        }
    }

    [[nodiscard]] Nearest nearest(std::uint32_t line, std::uint32_t segment, const glm::dvec2& point) const {
        const auto points = drawing_.points_of(drawing_.lines[line]);
        const glm::dvec2 a = points[segment].position, along = points[segment + 1].position - a;
        const double squared = glm::dot(along, along);
        const double share = squared > 0 ? std::clamp(glm::dot(point - a, along) / squared, 0.0, 1.0) : 0.0;
        return {line, segment, share, glm::distance(point, a + share * along)};
    }

    struct Place {
        std::uint32_t line, segment;
    };
    const Drawing& drawing_;
    double cell_;
    std::unordered_map<std::uint64_t, std::vector<Place>> cells_;
};

}  // namespace croquis::lines
