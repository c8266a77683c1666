// Joining paths end to end, and the order in which a pen draws them.
#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <optional>

#include "output/plotter.h"
#include "output/plotter_grid.h"

namespace croquis::output {
namespace {

// Ends are numbered 2 · ring (its first point) and 2 · ring + 1 (its last).
std::uint32_t other_end(std::uint32_t end) { return end ^ 1u; }

const glm::dvec2& place_of(const std::vector<Ring>& rings, std::uint32_t end) {
    const std::vector<glm::dvec2>& points = rings[end / 2].points;
    return end % 2 == 0 ? points.front() : points.back();
}

// The direction in which a ring leaves its end.
glm::dvec2 direction_at(const std::vector<Ring>& rings, std::uint32_t end) {
    const std::vector<glm::dvec2>& points = rings[end / 2].points;
    const glm::dvec2 along = end % 2 == 0 ? points[1] - points[0] : points[points.size() - 2] - points.back();
    const double length = glm::length(along);
    return length > 0 ? along / length : glm::dvec2(0.0);
}

constexpr std::uint32_t nothing = 0xffffffffu;

// For each end, the end that the pen goes on with: of all pairs that meet, the straightest first.
std::vector<std::uint32_t> pair_ends(const std::vector<Ring>& rings, double distance) {
    struct Pair {
        double bend;  // -1: straight on
        std::uint32_t a, b;
    };
    SheetGrid grid(std::max(distance, 1e-6));
    std::vector<Pair> pairs;
    for (std::uint32_t end = 0; end < 2 * rings.size(); ++end) {
        if (rings[end / 2].closed) continue;
        const glm::dvec2& place = place_of(rings, end);
        for (std::int64_t ring = 0; ring <= 1; ++ring) {
            grid.for_ring(place, ring, [&](std::uint32_t other) {
                if (glm::distance(place, place_of(rings, other)) > distance) return;
                pairs.push_back({glm::dot(direction_at(rings, end), direction_at(rings, other)), other, end});
            });
        }
        grid.add(end, place);
    }
    std::sort(pairs.begin(), pairs.end(),
              [](const Pair& p, const Pair& q) { return std::tie(p.bend, p.a, p.b) < std::tie(q.bend, q.a, q.b); });
    std::vector<std::uint32_t> partner(2 * rings.size(), nothing);
    for (const Pair& pair : pairs) {
        if (partner[pair.a] != nothing || partner[pair.b] != nothing) continue;
        partner[pair.a] = pair.b;
        partner[pair.b] = pair.a;
    }
    return partner;
}

void append(std::vector<glm::dvec2>& points, const Ring& ring, bool backwards) {
    const std::size_t skip = points.empty() ? 0 : 1;  // the point where both meet
    if (backwards) {
        points.insert(points.end(), ring.points.rbegin() + std::ptrdiff_t(skip), ring.points.rend());
    } else {
        points.insert(points.end(), ring.points.begin() + std::ptrdiff_t(skip), ring.points.end());
    }
}

// From an end onwards through all that is joined to it.
Ring follow(const std::vector<Ring>& rings, const std::vector<std::uint32_t>& partner, std::uint32_t start,
            std::vector<bool>& is_used) {
    Ring joined;
    std::uint32_t end = start;
    while (end != nothing && !is_used[end / 2]) {
        is_used[end / 2] = true;
        append(joined.points, rings[end / 2], end % 2 == 1);
        end = partner[other_end(end)];
    }
    joined.closed = end == start;
    if (joined.closed) joined.points.pop_back();
    if (joined.points.size() < 3) {
        if (joined.closed) joined.points.push_back(joined.points.front());
        joined.closed = false;
    }
    return joined;
}

// A ring and the way round in which the pen draws it: entered at `start`, left at `end`.
struct Leg {
    std::uint32_t ring;
    std::uint32_t entry = 0;  // the point at which a closed ring is entered and left
    bool backwards = false;
    glm::dvec2 start, end;

    void turn_round() {
        backwards = !backwards;
        std::swap(start, end);
    }
};

// Always on to the nearest end, or corner of a closed ring, that is left.
std::vector<Leg> nearest_first(const std::vector<Ring>& rings, const glm::dvec2& start) {
    struct Entry {
        std::uint32_t ring, point;
    };
    std::vector<Entry> entries;
    glm::dvec2 low = start, high = start;
    for (std::uint32_t r = 0; r < rings.size(); ++r) {
        const auto last = std::uint32_t(rings[r].points.size() - 1);
        for (std::uint32_t p = 0; p <= last; ++p) {
            if (rings[r].closed || p == 0 || p == last) entries.push_back({r, p});
            low = glm::min(low, rings[r].points[p]);
            high = glm::max(high, rings[r].points[p]);
        }
    }
    const auto place = [&](std::uint32_t entry) { return rings[entries[entry].ring].points[entries[entry].point]; };
    const double side = std::max({high.x - low.x, high.y - low.y, 1.0});
    SheetGrid grid(std::max(side / std::sqrt(double(entries.size()) + 1.0), 1e-3));
    for (std::uint32_t e = 0; e < entries.size(); ++e) grid.add(e, place(e));

    std::vector<Leg> legs;
    std::vector<std::uint32_t> first_entry(rings.size() + 1, 0);
    for (const Entry& entry : entries) ++first_entry[entry.ring + 1];
    std::partial_sum(first_entry.begin(), first_entry.end(), first_entry.begin());
    const auto reach = std::int64_t(2 * side / grid.cell()) + 2;
    glm::dvec2 pen = start;
    while (legs.size() < rings.size()) {
        double nearest = std::numeric_limits<double>::max();
        std::uint32_t best = nothing;
        for (std::int64_t away = 0; away <= reach; ++away) {
            if (best != nothing && double(away - 1) * grid.cell() > nearest) break;
            grid.for_ring(pen, away, [&](std::uint32_t entry) {
                const double distance = glm::distance(pen, place(entry));
                if (distance < nearest || (distance == nearest && entry < best)) {
                    nearest = distance;
                    best = entry;
                }
            });
        }
        const auto [number, point] = entries[best];
        for (std::uint32_t e = first_entry[number]; e < first_entry[number + 1]; ++e) grid.remove(e, place(e));
        const std::vector<glm::dvec2>& points = rings[number].points;
        Leg leg{number, 0, false, points.front(), points.back()};
        if (rings[number].closed) {
            leg.entry = point;
            leg.start = leg.end = points[point];
        } else if (point != 0) {
            leg.turn_round();
        }
        pen = leg.end;
        legs.push_back(leg);
    }
    return legs;
}

// Makes the way between legs shorter step by step. Work is bounded by looking no farther ahead than `reach` legs, and
// by the number of rounds.
class Shortening {
public:
    Shortening(std::vector<Leg>& legs, const std::vector<Ring>& rings, const glm::dvec2& start)
        : legs_(legs), rings_(rings), start_(start) {}

    void run() {
        constexpr int most_rounds = 20;
        constexpr double worth_a_round = 0.998;
        double way = whole_way();
        for (int round = 0; round < most_rounds; ++round) {
            turn_stretches();
            move_stretches();
            shift_entries();
            const double now = whole_way();
            if (now > worth_a_round * way) return;
            way = now;
        }
    }

private:
    static constexpr double least_gain = 1e-6;  // millimetres

    [[nodiscard]] double whole_way() const {
        double way = 0;
        for (std::size_t i = 0; i < legs_.size(); ++i) way += way_to(end_before(i), i);
        return way;
    }
    [[nodiscard]] glm::dvec2 end_before(std::size_t i) const { return i == 0 ? start_ : legs_[i - 1].end; }
    // The way from a point to a leg; none after the last.
    [[nodiscard]] double way_to(const glm::dvec2& from, std::size_t i) const {
        return i < legs_.size() ? glm::distance(from, legs_[i].start) : 0.0;
    }
    [[nodiscard]] std::size_t reach() const {
        constexpr std::size_t most_comparisons = 2'000'000;
        return std::max<std::size_t>(100, most_comparisons / legs_.size());
    }

    // 2-opt: a stretch of the order is gone through the other way round.
    void turn_stretches() {
        for (std::size_t i = 0; i < legs_.size(); ++i) {
            for (std::size_t j = i; j < std::min(legs_.size(), i + reach()); ++j) {
                const glm::dvec2 before = end_before(i);
                const double now = way_to(before, i) + way_to(legs_[j].end, j + 1);
                const double then = glm::distance(before, legs_[j].end) + way_to(legs_[i].start, j + 1);
                if (then > now - least_gain) continue;
                turn_round(i, j + 1);
            }
        }
    }

    void turn_round(std::size_t begin, std::size_t end) {
        std::reverse(legs_.begin() + std::ptrdiff_t(begin), legs_.begin() + std::ptrdiff_t(end));
        for (std::size_t k = begin; k < end; ++k) legs_[k].turn_round();
    }

    // Or-opt: up to three legs in a row are drawn somewhere else.
    void move_stretches() {
        constexpr std::size_t longest = 3;
        for (std::size_t i = 0; i < legs_.size(); ++i) {
            for (std::size_t end = i + 1; end <= std::min(i + longest, legs_.size()); ++end) move_stretch(i, end);
        }
    }

    void move_stretch(std::size_t begin, std::size_t end) {
        const glm::dvec2 head = legs_[begin].start, tail = legs_[end - 1].end, before = end_before(begin);
        const double saved = way_to(before, begin) + way_to(tail, end) - way_to(before, end);
        double best = saved - least_gain;
        std::size_t place = begin;
        bool turned = false;
        const std::size_t first = begin > reach() ? begin - reach() : 0;
        for (std::size_t at = first; at <= std::min(legs_.size(), end + reach()); ++at) {
            if (at >= begin && at <= end) continue;
            const glm::dvec2 from = end_before(at);
            const double now = way_to(from, at);
            const double straight = glm::distance(from, head) + way_to(tail, at) - now;
            const double backwards = glm::distance(from, tail) + way_to(head, at) - now;
            if (std::min(straight, backwards) >= best) continue;
            best = std::min(straight, backwards);
            place = at;
            turned = backwards < straight;
        }
        if (place == begin) return;
        if (turned) turn_round(begin, end);
        const auto at = [&](std::size_t i) { return legs_.begin() + std::ptrdiff_t(i); };
        if (place < begin) {
            std::rotate(at(place), at(begin), at(end));
        } else {
            std::rotate(at(begin), at(end), at(place));
        }
    }

    // A closed ring is entered where the way in and the way on are shortest together.
    void shift_entries() {
        for (std::size_t i = 0; i < legs_.size(); ++i) {
            Leg& leg = legs_[i];
            if (!rings_[leg.ring].closed) continue;
            const glm::dvec2 before = end_before(i);
            double best = glm::distance(before, leg.start) + way_to(leg.end, i + 1) - least_gain;
            const std::vector<glm::dvec2>& points = rings_[leg.ring].points;
            for (std::uint32_t p = 0; p < points.size(); ++p) {
                const double way = glm::distance(before, points[p]) + way_to(points[p], i + 1);
                if (way >= best) continue;
                best = way;
                leg.entry = p;
                leg.start = leg.end = points[p];
            }
        }
    }

    std::vector<Leg>& legs_;
    const std::vector<Ring>& rings_;
    glm::dvec2 start_;
};

}  // namespace

void join_ends(std::vector<Ring>& rings, double join_distance) {
    std::erase_if(rings, [](const Ring& ring) { return ring.points.size() < 2; });
    const std::vector<std::uint32_t> partner = pair_ends(rings, join_distance);
    std::vector<Ring> joined;
    std::vector<bool> is_used(rings.size(), false);
    for (std::uint32_t r = 0; r < rings.size(); ++r) {
        if (!rings[r].closed) continue;
        is_used[r] = true;
        joined.push_back(rings[r]);
    }
    // Open chains from their free ends, then what is left: circles.
    for (std::uint32_t end = 0; end < 2 * rings.size(); ++end) {
        if (!is_used[end / 2] && partner[end] == nothing) joined.push_back(follow(rings, partner, end, is_used));
    }
    for (std::uint32_t r = 0; r < rings.size(); ++r) {
        if (!is_used[r]) joined.push_back(follow(rings, partner, 2 * r, is_used));
    }
    rings = std::move(joined);
}

void order_rings(std::vector<Ring>& rings, const glm::dvec2& start) {
    std::erase_if(rings, [](const Ring& ring) { return ring.points.empty(); });
    if (rings.empty()) return;
    std::vector<Leg> legs = nearest_first(rings, start);
    Shortening(legs, rings, start).run();
    std::vector<Ring> ordered;
    for (const Leg& leg : legs) {
        Ring ring = std::move(rings[leg.ring]);
        if (ring.closed) {
            std::rotate(ring.points.begin(), ring.points.begin() + leg.entry, ring.points.end());
        } else if (leg.backwards) {
            std::reverse(ring.points.begin(), ring.points.end());
        }
        ordered.push_back(std::move(ring));
    }
    rings = std::move(ordered);
}

}  // namespace croquis::output
