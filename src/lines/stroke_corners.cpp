#include "lines/stroke_corners.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace croquis::lines {
namespace {

double turn_at(const Spine& spine, std::size_t vertex, double reach) {
    const double along = spine.along()[vertex];
    const glm::dvec2 here = spine.vertices()[vertex].position;
    const glm::dvec2 in = here - spine.at(along - reach).position, out = spine.at(along + reach).position - here;
    return std::abs(std::atan2(in.x * out.y - in.y * out.x, glm::dot(in, out)));
}

}  // namespace

std::vector<std::size_t> corners_of(const Spine& spine, double angle, double reach) {
    const std::size_t count = spine.vertices().size() - 1;  // the last one ends the line or repeats the first
    const double wide = std::min(reach, spine.length() / 4);
    std::vector<double> turns(count, 0);
    for (std::size_t i = spine.closed() ? 0 : 1; i < count; ++i) {
        const double turn = turn_at(spine, i, wide);
        if (turn > angle && turn_at(spine, i, wide / 4) > angle) turns[i] = turn;
    }

    std::vector<std::size_t> corners;
    for (std::size_t i = 0; i < count; ++i) {
        if (turns[i] == 0) continue;
        bool is_sharpest = true;
        for (std::size_t j = i; j-- > 0 && spine.along()[i] - spine.along()[j] < wide;) {
            is_sharpest = is_sharpest && turns[j] < turns[i];
        }
        for (std::size_t j = i + 1; j < count && spine.along()[j] - spine.along()[i] < wide; ++j) {
            is_sharpest = is_sharpest && turns[j] <= turns[i];
        }
        if (is_sharpest) corners.push_back(i);
    }
    return corners;
}

}  // namespace croquis::lines
