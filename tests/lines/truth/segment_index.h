// Straight pieces in the picture, found again by a point that lies on them.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "lines/viewpoint.h"

namespace croquis::lines::truth {

class SegmentIndex {
public:
    /// A piece near a point.
    struct Found {
        std::uint32_t id = 0;
        double pixels = 0;    ///< from the point to the piece
        double nearness = 0;  ///< of the piece there
    };

    enum class Depth : std::uint8_t { compared, ignored };

    explicit SegmentIndex(const Viewpoint& view, Depth depth = Depth::compared);

    void add(std::uint32_t id, const ImagePoint& begin, const ImagePoint& end);

    /// The pieces within `reach` pixels of a point, nearest first; those of another eye distance only where depth is
    /// ignored. The reach is at most a hundredth of a pixel.
    [[nodiscard]] std::vector<Found> at(const ImagePoint& point, double reach) const;

private:
    struct Segment {
        std::uint32_t id = 0;
        ImagePoint begin, end;
    };

    [[nodiscard]] std::size_t column_of(double x) const;
    [[nodiscard]] std::size_t row_of(double y) const;

    Viewpoint view_;
    Depth depth_;
    std::size_t columns_, rows_;
    std::vector<Segment> segments_;
    std::vector<std::vector<std::uint32_t>> cells_;
};

}  // namespace croquis::lines::truth
