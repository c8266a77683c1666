// A grid over the sheet: what lies near a point or a straight piece.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <unordered_map>
#include <vector>

namespace croquis::output {

/// Numbers of things by the square cells that they touch. Cells exist only where something lies.
class SheetGrid {
public:
    explicit SheetGrid(double cell) : cell_(cell) {}

    void add(std::uint32_t number, const glm::dvec2& point) { cells_[key(index(point))].push_back(number); }

    /// Every cell of the box around a straight piece that lies within a cell's size of it.
    void add(std::uint32_t number, const glm::dvec2& a, const glm::dvec2& b) {
        for_cells_along(a, b, [&](std::int64_t cell) { cells_[cell].push_back(number); });
    }

    /// Takes a number out of a point's cell.
    void remove(std::uint32_t number, const glm::dvec2& point) {
        const auto found = cells_.find(key(index(point)));
        if (found != cells_.end()) std::erase(found->second, number);
    }

    /// Calls `use(number)` for what was added along cells near the straight piece; a number may come more than once.
    template <typename Use>
    void for_near(const glm::dvec2& a, const glm::dvec2& b, const Use& use) const {
        for_cells_along(a, b, [&](std::int64_t cell) {
            const auto found = cells_.find(cell);
            if (found == cells_.end()) return;
            for (const std::uint32_t number : found->second) use(number);
        });
    }

    /// Calls `use(number)` for what lies in the ring of cells `distance` cells away from the point's.
    template <typename Use>
    void for_ring(const glm::dvec2& point, std::int64_t distance, const Use& use) const {
        const Index middle = index(point);
        for (std::int64_t y = middle.y - distance; y <= middle.y + distance; ++y) {
            const bool is_side = y == middle.y - distance || y == middle.y + distance;
            const std::int64_t step = is_side || distance == 0 ? 1 : 2 * distance;
            for (std::int64_t x = middle.x - distance; x <= middle.x + distance; x += step) {
                const auto found = cells_.find(key({x, y}));
                if (found == cells_.end()) continue;
                for (const std::uint32_t number : found->second) use(number);
            }
        }
    }

    [[nodiscard]] double cell() const { return cell_; }

private:
    struct Index {
        std::int64_t x, y;
    };
    [[nodiscard]] Index index(const glm::dvec2& point) const {
        return {std::int64_t(std::floor(point.x / cell_)), std::int64_t(std::floor(point.y / cell_))};
    }
    static std::int64_t key(const Index& index) { return (index.x << 32) ^ (index.y & 0xffffffff); }

    // Row by row, the cells that the piece crosses and one more on both sides.
    template <typename Use>
    void for_cells_along(const glm::dvec2& a, const glm::dvec2& b, const Use& use) const {
        const glm::dvec2 low = a.y <= b.y ? a : b, high = a.y <= b.y ? b : a;
        const std::int64_t first = index(low).y - 1, last = index(high).y + 1;
        for (std::int64_t row = first; row <= last; ++row) {
            const double height = high.y - low.y;
            const auto x_at = [&](double y) {
                return height > 0 ? low.x + (high.x - low.x) * std::fmin(std::fmax((y - low.y) / height, 0.0), 1.0)
                                  : low.x;
            };
            double left = x_at(double(row) * cell_), right = x_at(double(row + 1) * cell_);
            if (!(height > 0)) right = high.x;
            if (left > right) std::swap(left, right);
            const std::int64_t end = std::int64_t(std::floor(right / cell_)) + 1;
            for (std::int64_t x = std::int64_t(std::floor(left / cell_)) - 1; x <= end; ++x) use(key({x, row}));
        }
    }

    double cell_;
    std::unordered_map<std::int64_t, std::vector<std::uint32_t>> cells_;
};

}  // namespace croquis::output
