#include "output/vector_regions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "output/plotter.h"

namespace croquis::output {
namespace {

// Places are rounded to this, so that ends that meet are one place.
constexpr double steps_per_pixel = 256;

double snapped(double place) { return std::round(place * steps_per_pixel) / steps_per_pixel; }

// A piece from top to bottom.
struct Wall {
    glm::dvec2 top, bottom;

    // Exact at both ends, and the same number for the bands above and below a height.
    [[nodiscard]] double x_at(double y) const {
        if (y <= top.y) return top.x;
        if (y >= bottom.y) return bottom.x;
        return top.x + (bottom.x - top.x) * ((y - top.y) / (bottom.y - top.y));
    }
};

// A cell of a band: from wall to wall. The frame's sides count as walls.
struct Cell {
    std::uint32_t left_wall, right_wall;
    std::uint32_t region;
};

struct Band {
    double top = 0, bottom = 0;
    std::vector<Cell> cells;  // from left to right
    // Where the walls between the cells stand at the top and at the bottom, one more than cells; never going back, for
    // walls that cross within a rounding step are not cut there.
    std::vector<double> x_top, x_bottom;
};

// A piece of the border of a region, which lies on its right on the screen.
struct BorderEdge {
    std::uint32_t region;
    glm::dvec2 from, to;
};

bool lies_before(const glm::dvec2& a, const glm::dvec2& b) { return a.y < b.y || (a.y == b.y && a.x < b.x); }

class Regions {
public:
    Regions(std::span<const BoundaryPiece> pieces, double width, double height, const RegionAt& region_at)
        : region_at_(region_at) {
        walls_.push_back({{0.0, 0.0}, {0.0, height}});
        walls_.push_back({{width, 0.0}, {width, height}});
        heights_ = {0.0, height};
        for (const BoundaryPiece& piece : pieces) {
            glm::dvec2 top(snapped(piece.from.x), snapped(piece.from.y)),
                bottom(snapped(piece.to.x), snapped(piece.to.y));
            if (bottom.y < top.y) std::swap(top, bottom);
            heights_.insert(heights_.end(), {top.y, bottom.y});
            if (top.y == bottom.y) {
                level_heights_.insert(top.y);
            } else {
                walls_.push_back({top, bottom});
            }
        }
        std::sort(heights_.begin(), heights_.end());
        heights_.erase(std::unique(heights_.begin(), heights_.end()), heights_.end());
        std::erase_if(heights_, [&](double y) { return y < 0 || y > height; });
    }

    std::vector<BorderEdge> borders() {
        std::vector<std::uint32_t> by_top(walls_.size());
        for (std::uint32_t w = 0; w < walls_.size(); ++w) by_top[w] = w;
        std::sort(by_top.begin(), by_top.end(),
                  [&](std::uint32_t a, std::uint32_t b) { return walls_[a].top.y < walls_[b].top.y; });
        std::vector<std::uint32_t> active;
        std::size_t next = 0;
        for (std::size_t i = 0; i + 1 < heights_.size(); ++i) {
            std::erase_if(active, [&](std::uint32_t w) { return walls_[w].bottom.y <= heights_[i]; });
            for (; next < by_top.size() && walls_[by_top[next]].top.y <= heights_[i]; ++next) {
                if (walls_[by_top[next]].bottom.y > heights_[i]) active.push_back(by_top[next]);
            }
            constexpr int most_cuts = 24;
            add_band(heights_[i], heights_[i + 1], active, most_cuts);
        }
        close(last_, {});
        return std::move(borders_);
    }

private:
    // Cuts a band at crossings of walls until their order is the same above and below.
    void add_band(double top, double bottom, const std::vector<std::uint32_t>& active, int cuts_left) {
        std::vector<std::uint32_t> order = active;
        const double middle = 0.5 * (top + bottom);
        std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
            const double xa = walls_[a].x_at(middle), xb = walls_[b].x_at(middle);
            return xa < xb || (xa == xb && a < b);
        });
        if (cuts_left > 0) {
            for (std::size_t i = 0; i + 1 < order.size(); ++i) {
                const double cut = crossing_of(walls_[order[i]], walls_[order[i + 1]], top, bottom);
                if (!(cut > top && cut < bottom)) continue;
                add_band(top, cut, active, cuts_left - 1);
                add_band(cut, bottom, active, cuts_left - 1);
                return;
            }
        }
        Band band{top, bottom, {}, {}, {}};
        for (std::size_t i = 0; i < order.size(); ++i) {
            if (i > 0) band.cells.push_back({order[i - 1], order[i], no_region});
            const Wall& wall = walls_[order[i]];
            band.x_top.push_back(std::max(wall.x_at(top), i > 0 ? band.x_top.back() : 0.0));
            band.x_bottom.push_back(std::max(wall.x_at(bottom), i > 0 ? band.x_bottom.back() : 0.0));
        }
        find_regions(band);
        add_sides(band);
        close(last_, band);
        last_ = std::move(band);
    }

    // The height at which two walls change places, strictly within a band; not a number where they do not.
    static double crossing_of(const Wall& a, const Wall& b, double top, double bottom) {
        const double above = a.x_at(top) - b.x_at(top), below = a.x_at(bottom) - b.x_at(bottom);
        constexpr double unseen = 1.0 / steps_per_pixel;
        if (above * below >= 0 || std::min(std::abs(above), std::abs(below)) < unseen) {
            return std::numeric_limits<double>::quiet_NaN();
        }
        return top + (bottom - top) * (above / (above - below));
    }

    // A cell that goes on from the band before is what it was.
    void find_regions(Band& band) const {
        const bool may_go_on = level_heights_.count(band.top) == 0;
        const double middle = 0.5 * (band.top + band.bottom);
        std::size_t before = 0;
        for (Cell& cell : band.cells) {
            if (may_go_on) {
                const auto same = std::find_if(
                    last_.cells.begin() + std::ptrdiff_t(before), last_.cells.end(), [&](const Cell& other) {
                        return other.left_wall == cell.left_wall && other.right_wall == cell.right_wall;
                    });
                if (same != last_.cells.end()) {
                    cell.region = same->region;
                    before = std::size_t(same - last_.cells.begin());
                    continue;
                }
            }
            const double x = 0.5 * (walls_[cell.left_wall].x_at(middle) + walls_[cell.right_wall].x_at(middle));
            cell.region = region_at_({x, middle});
        }
    }

    void add_sides(const Band& band) {
        std::uint32_t left = no_region;
        for (std::size_t i = 0; i <= band.cells.size() && !band.cells.empty(); ++i) {
            const bool is_last = i == band.cells.size();
            const std::uint32_t right = is_last ? no_region : band.cells[i].region;
            if (left != right) {
                const glm::dvec2 top(band.x_top[i], band.top), bottom(band.x_bottom[i], band.bottom);
                add(left, top, bottom);
                add(right, bottom, top);
            }
            left = right;
        }
    }

    // Borders between two bands that lie upon each other: the lower edge of one, the upper edge of the other.
    void close(const Band& above, const Band& below) {
        const double y = above.cells.empty() ? below.top : above.bottom;
        struct Step {
            double x;
            bool is_above;
            std::uint32_t region;  // to the right of x
        };
        std::vector<Step> steps;
        const auto add_steps = [&](const Band& band, const std::vector<double>& walls, bool is_above) {
            for (std::size_t i = 0; i < walls.size(); ++i) {
                steps.push_back({walls[i], is_above, i < band.cells.size() ? band.cells[i].region : no_region});
            }
        };
        add_steps(above, above.x_bottom, true);
        add_steps(below, below.x_top, false);
        std::stable_sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) { return a.x < b.x; });
        std::uint32_t over = no_region, under = no_region;
        double from = 0;
        for (const Step& step : steps) {
            if (over != under && step.x > from) {
                add(over, {step.x, y}, {from, y});
                add(under, {from, y}, {step.x, y});
            }
            (step.is_above ? over : under) = step.region;
            from = step.x;
        }
    }

    void add(std::uint32_t region, const glm::dvec2& from, const glm::dvec2& to) {
        if (region != no_region && from != to) borders_.push_back({region, from, to});
    }

    const RegionAt& region_at_;
    std::vector<Wall> walls_;
    std::vector<double> heights_;
    std::set<double> level_heights_;  // of level pieces, which part what lies above and below
    Band last_;
    std::vector<BorderEdge> borders_;
};

// As many edges of a region come to each point as leave it: they form closed rings.
std::vector<std::vector<Ring>> rings_of(std::vector<BorderEdge> edges, std::uint32_t count) {
    const auto comes_first = [](const BorderEdge& a, const BorderEdge& b) {
        if (a.region != b.region) return a.region < b.region;
        return lies_before(a.from, b.from);
    };
    std::stable_sort(edges.begin(), edges.end(), comes_first);
    std::vector<std::vector<Ring>> rings(count);
    std::vector<bool> is_used(edges.size(), false);
    for (std::size_t first = 0; first < edges.size(); ++first) {
        if (is_used[first]) continue;
        Ring ring;
        ring.closed = true;
        std::size_t i = first;
        while (i < edges.size() && !is_used[i]) {
            is_used[i] = true;
            ring.points.push_back(edges[i].from);
            const BorderEdge wanted{edges[i].region, edges[i].to, {}};
            i = std::size_t(std::lower_bound(edges.begin(), edges.end(), wanted, comes_first) - edges.begin());
            while (i < edges.size() && is_used[i] && edges[i].from == wanted.from && edges[i].region == wanted.region)
                ++i;
            if (i < edges.size() && edges[i].from != wanted.from) break;
        }
        rings[edges[first].region].push_back(std::move(ring));
    }
    return rings;
}

}  // namespace

std::vector<std::vector<Ring>> regions_between(std::span<const BoundaryPiece> pieces, double width, double height,
                                               std::uint32_t count, const RegionAt& region_at) {
    std::vector<std::vector<Ring>> regions = rings_of(Regions(pieces, width, height, region_at).borders(), count);
    constexpr double unseen = 0.004;  // pixels
    for (std::vector<Ring>& rings : regions) {
        drop_idle_points(rings, unseen);
        std::erase_if(rings, [](const Ring& ring) { return ring.points.size() < 3; });
    }
    return regions;
}

}  // namespace croquis::output
