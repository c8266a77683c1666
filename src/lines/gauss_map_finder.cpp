#include "lines/gauss_map_finder.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/error.h"
#include "base/parallel.h"
#include "lines/facing.h"
#include "lines/ordered_set.h"
#include "lines/radix_order.h"

namespace croquis::lines {
namespace {

constexpr std::size_t edges_a_piece = 4096;
constexpr double overlap = 1.5;  // of a bin's circle, as a factor to the circle around its triangle

/// A spherical triangle of the decomposition.
struct Bin {
    std::array<glm::dvec3, 3> corners{};
    glm::dvec3 centre{0.0};
    double radius = 0;  ///< angle from the centre to the corners
    std::uint32_t first_child = 0;
    std::uint32_t child_count = 0;
    std::uint32_t level = 0;
};

Bin bin_of(const std::array<glm::dvec3, 3>& corners, std::uint32_t level) {
    Bin bin;
    bin.corners = corners;
    bin.centre = glm::normalize(corners[0] + corners[1] + corners[2]);
    for (const glm::dvec3& corner : corners) {
        bin.radius = std::max(bin.radius, std::acos(std::min(1.0, glm::dot(bin.centre, corner))));
    }
    bin.level = level;
    return bin;
}

/// The sides of an icosahedron, counter-clockwise seen from outside. Its corners are those of three golden rectangles;
/// any three that are nearest neighbours make a side.
std::vector<Bin> icosahedron() {
    const double golden = 0.5 * (1.0 + std::sqrt(5.0));
    std::vector<glm::dvec3> corners;
    for (const double a : {-1.0, 1.0}) {
        for (const double b : {-golden, golden}) {
            for (const glm::dvec3& corner : {glm::dvec3(0, a, b), glm::dvec3(a, b, 0), glm::dvec3(b, 0, a)}) {
                corners.push_back(glm::normalize(corner));
            }
        }
    }
    const auto neighbours = [](const glm::dvec3& p, const glm::dvec3& q) { return glm::dot(p, q) > 0.4; };
    std::vector<Bin> sides;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        for (std::size_t j = i + 1; j < corners.size(); ++j) {
            for (std::size_t k = j + 1; k < corners.size(); ++k) {
                const glm::dvec3 &a = corners[i], &b = corners[j], &c = corners[k];
                if (!neighbours(a, b) || !neighbours(b, c) || !neighbours(c, a)) continue;
                const bool outwards = glm::dot(glm::cross(a, b), c) > 0;
                sides.push_back(bin_of({a, outwards ? b : c, outwards ? c : b}, 1));
            }
        }
    }
    return sides;
}

/// All bins, level after level; the first is the whole sphere.
std::vector<Bin> make_bins() {
    std::vector<Bin> bins(1);
    for (const Bin& side : icosahedron()) bins.push_back(side);
    bins[0].first_child = 1;
    bins[0].child_count = static_cast<std::uint32_t>(bins.size()) - 1;
    for (std::size_t b = 1; bins[b].level + 1 < gauss_map_levels; ++b) {
        const std::uint32_t level = bins[b].level + 1;
        const auto [p, q, r] = bins[b].corners;
        const glm::dvec3 pq = glm::normalize(p + q), qr = glm::normalize(q + r), rp = glm::normalize(r + p);
        bins[b].first_child = static_cast<std::uint32_t>(bins.size());
        bins[b].child_count = 4;
        for (const auto& corners : {std::array{p, pq, rp}, {pq, q, qr}, {rp, qr, r}, {pq, qr, rp}}) {
            bins.push_back(bin_of(corners, level));
        }
    }
    return bins;
}

/// An edge's arc.
struct Arc {
    glm::dvec3 from, to;
};

bool holds(const Bin& bin, const Arc& arc, GaussBins kind) {
    if (kind == GaussBins::overlapping) {
        const double least = std::cos(overlap * bin.radius);
        return glm::dot(bin.centre, arc.from) >= least && glm::dot(bin.centre, arc.to) >= least;
    }
    for (std::size_t side = 0; side < 3; ++side) {
        const glm::dvec3 inwards = glm::cross(bin.corners[side], bin.corners[(side + 1) % 3]);
        if (glm::dot(inwards, arc.from) < 0 || glm::dot(inwards, arc.to) < 0) return false;
    }
    return true;
}

/// The smallest bin that holds an arc; of several of one size, the one whose centre is nearest to the arc's middle.
std::uint32_t bin_for(const std::vector<Bin>& bins, const Arc& arc, GaussBins kind) {
    const glm::dvec3 middle = arc.from + arc.to;
    if (!(glm::length(arc.from) > 0.5 && glm::length(arc.to) > 0.5)) return 0;  // a face that a pose folded to nothing
    std::uint32_t bin = 0;
    while (true) {
        std::uint32_t next = 0;
        for (std::uint32_t c = bins[bin].first_child; c < bins[bin].first_child + bins[bin].child_count; ++c) {
            if (!holds(bins[c], arc, kind)) continue;
            if (next == 0 || glm::dot(bins[c].centre, middle) > glm::dot(bins[next].centre, middle)) next = c;
        }
        if (next == 0) return bin;
        bin = next;
    }
}

/// The arcs of a surface in their bins.
class GaussMap {
public:
    GaussMap(const Surface& surface, GaussBins kind) : bins_(make_bins()), reach_(bins_.size(), -1.0) {
        std::vector<KeyedNumber> items;
        items.reserve(surface.edge_count());
        for (std::uint32_t e = 0; e < surface.edge_count(); ++e) {
            if (surface.pairs()[e].first != surface.pairs()[e].second) items.push_back({0, e});
        }
        parallel_for(items.size(), edges_a_piece, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                items[i].key = bin_for(bins_, arc_of(surface, items[i].number), kind);
            }
        });
        radix_sort(items);
        starts_.assign(bins_.size() + 1, 0);
        for (const KeyedNumber& item : items) ++starts_[item.key + 1];
        for (std::size_t b = 1; b < starts_.size(); ++b) starts_[b] += starts_[b - 1];
        for (const KeyedNumber& item : items) edges_.push_back(item.number);
        measure_reach(surface);
    }

    [[nodiscard]] std::array<std::size_t, gauss_map_levels> counts() const {
        std::array<std::size_t, gauss_map_levels> counts{};
        for (std::size_t b = 0; b < bins_.size(); ++b) counts[bins_[b].level] += starts_[b + 1] - starts_[b];
        return counts;
    }

    /// Replaces `edges` by those of all bins that the great circle across a direction may cut.
    void choose(const glm::dvec3& direction, std::vector<std::uint32_t>& edges) const {
        edges.clear();
        append(0, direction, edges);
    }

private:
    static Arc arc_of(const Surface& surface, std::uint32_t edge) {
        const FacePair& pair = surface.pairs()[edge];
        return {glm::dvec3(surface.planes()[pair.first]), glm::dvec3(surface.planes()[pair.second])};
    }

    /// How far the arcs in and below each bin lie from its centre. Children come after their parents.
    void measure_reach(const Surface& surface) {
        const auto angle = [](const glm::dvec3& a, const glm::dvec3& b) {
            return std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
        };
        for (std::size_t b = bins_.size(); b-- > 1;) {
            const Bin& bin = bins_[b];
            double cosine = 1.0;
            for (std::uint32_t i = starts_[b]; i < starts_[b + 1]; ++i) {
                const Arc arc = arc_of(surface, edges_[i]);
                cosine = std::min({cosine, glm::dot(bin.centre, arc.from), glm::dot(bin.centre, arc.to)});
            }
            if (starts_[b + 1] > starts_[b]) reach_[b] = std::acos(std::clamp(cosine, -1.0, 1.0));
            for (std::uint32_t c = bin.first_child; c < bin.first_child + bin.child_count; ++c) {
                if (reach_[c] >= 0) reach_[b] = std::max(reach_[b], angle(bin.centre, bins_[c].centre) + reach_[c]);
            }
        }
    }

    void append(std::size_t b, const glm::dvec3& direction, std::vector<std::uint32_t>& edges) const {
        const Bin& bin = bins_[b];
        if (b > 0) {
            if (reach_[b] < 0) return;  // empty
            // Normals are in single precision; so near the circle the faces themselves decide.
            const double from_circle = std::abs(std::asin(std::clamp(glm::dot(bin.centre, direction), -1.0, 1.0)));
            if (from_circle > reach_[b] + 2e-5) return;
        }
        edges.insert(edges.end(), edges_.begin() + starts_[b], edges_.begin() + starts_[b + 1]);
        for (std::uint32_t c = bin.first_child; c < bin.first_child + bin.child_count; ++c) append(c, direction, edges);
    }

    std::vector<Bin> bins_;
    std::vector<double> reach_;          // radians; negative where there is nothing
    std::vector<std::uint32_t> starts_;  // of each bin's run in edges_
    std::vector<std::uint32_t> edges_;
};

class GaussMapFinder final : public SilhouetteFinder {
public:
    GaussMapFinder(const Surface& surface, GaussBins kind)
        : surface_(surface), map_(surface, kind), set_(surface.edge_count()) {}

    const std::vector<std::uint32_t>& find(const Viewpoint& view) override {
        if (view.projection != model::Projection::parallel) {
            fail("expected a parallel projection for a Gauss map of silhouettes, found a perspective one");
        }
        map_.choose(view.back, candidates_);
        const Facing facing(surface_, view);
        found_in_piece_.resize((candidates_.size() + edges_a_piece - 1) / edges_a_piece);
        parallel_for(found_in_piece_.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t piece = begin; piece < end; ++piece) {
                const std::size_t first = piece * edges_a_piece;
                const std::size_t count = std::min(edges_a_piece, candidates_.size() - first);
                found_in_piece_[piece].clear();
                facing.append_silhouettes(std::span(candidates_).subspan(first, count), found_in_piece_[piece]);
            }
        });
        for (const std::vector<std::uint32_t>& found : found_in_piece_) {
            for (const std::uint32_t e : found) set_.add(e);
        }
        set_.take(found_);
        return found_;
    }

private:
    const Surface& surface_;
    GaussMap map_;
    OrderedSet set_;
    std::vector<std::uint32_t> candidates_, found_;
    std::vector<std::vector<std::uint32_t>> found_in_piece_;
};

}  // namespace

std::unique_ptr<SilhouetteFinder> make_gauss_map_finder(const Surface& surface, GaussBins bins) {
    return std::make_unique<GaussMapFinder>(surface, bins);
}

std::array<std::size_t, gauss_map_levels> gauss_map_counts(const Surface& surface, GaussBins bins) {
    return GaussMap(surface, bins).counts();
}

}  // namespace croquis::lines
