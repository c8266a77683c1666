#include "lines/drawing.h"

#include <glm/geometric.hpp>

namespace croquis::lines {

double length_of(const Drawing& drawing, const Line& line) {
    const std::span<const LinePoint> points = drawing.points_of(line);
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        length += glm::distance(points[i - 1].position, points[i].position);
    }
    if (line.closed && points.size() > 1) length += glm::distance(points.back().position, points.front().position);
    return length;
}

}  // namespace croquis::lines
