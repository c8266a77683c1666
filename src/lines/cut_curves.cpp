#include "lines/cut_curves.h"

#include <algorithm>
#include <atomic>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>
#include <optional>
#include <span>

#include "base/parallel.h"
#include "lines/face_cutter.h"
#include "lines/general_position.h"
#include "lines/overlap_tree.h"

namespace croquis::lines {
namespace {

/// Up to this length, in scene units, doubtful segments between two certain ones count.
constexpr double longest_bridge = 1e-3;
/// Pairs of faces with overlapping boxes that are looked at. A well-made model has some 20 a face.
constexpr std::size_t most_pairs_a_face = 64;
constexpr std::size_t most_pairs_of_few_faces = 4'000'000;

/// Nothing for a tangle.
std::optional<std::vector<FaceCut>> find_cuts(const Surface& surface, const GeneralPosition& points,
                                              const FaceCutter& cutter) {
    const OverlapTree tree(surface.topology().faces, points);
    const std::vector<OverlapTree::NodePair> shares = tree.shares();
    std::vector<std::vector<FaceCut>> found(shares.size());
    const std::size_t most_pairs = surface.face_count() * most_pairs_a_face + most_pairs_of_few_faces;
    std::atomic<std::size_t> pairs = 0;
    parallel_for(shares.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto cut = [&](std::uint32_t face, std::span<const std::uint32_t> others) {
                pairs.fetch_add(others.size(), std::memory_order_relaxed);
                cutter.cut(face, others, found[i]);
            };
            tree.visit_overlaps(shares[i], cut, [&] { return pairs.load(std::memory_order_relaxed) > most_pairs; });
        }
    });
    if (pairs > most_pairs) return std::nullopt;
    std::vector<FaceCut> cuts;
    for (const std::vector<FaceCut>& part : found) cuts.insert(cuts.end(), part.begin(), part.end());
    std::sort(cuts.begin(), cuts.end(), [](const FaceCut& a, const FaceCut& b) { return a.faces < b.faces; });
    return cuts;
}

/// The places at which cuts end, in ascending order, and the two of each cut.
struct Ends {
    std::vector<CutPlace> places;
    std::vector<std::array<std::uint32_t, 2>> of_cuts;

    explicit Ends(const std::vector<FaceCut>& cuts) {
        places.reserve(2 * cuts.size());
        for (const FaceCut& cut : cuts) places.insert(places.end(), cut.ends.begin(), cut.ends.end());
        std::sort(places.begin(), places.end());
        places.erase(std::unique(places.begin(), places.end()), places.end());
        const auto number_of = [this](const CutPlace& place) {
            return static_cast<std::uint32_t>(std::lower_bound(places.begin(), places.end(), place) - places.begin());
        };
        of_cuts.reserve(cuts.size());
        for (const FaceCut& cut : cuts) of_cuts.push_back({number_of(cut.ends[0]), number_of(cut.ends[1])});
    }
};

/// Sets of connected places (union by smaller number, with path halving).
class Runs {
public:
    explicit Runs(std::size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0u); }
    std::uint32_t of(std::uint32_t place) {
        while (parents_[place] != place) place = parents_[place] = parents_[parents_[place]];
        return place;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        const auto [low, high] = std::minmax({of(a), of(b)});
        parents_[high] = low;
    }

private:
    std::vector<std::uint32_t> parents_;
};

/// Which cuts to keep: the certain ones, and short runs of doubtful ones that join certain ones, where a curve runs
/// through a corner or across a sliver. Long runs are faces that touch.
std::vector<bool> kept_cuts(const std::vector<FaceCut>& cuts, const Ends& ends, const std::vector<glm::dvec3>& points) {
    struct Run {
        glm::dvec3 low{1e300}, high{-1e300};
        std::uint32_t certain_ends = 0;
    };
    Runs runs(points.size());
    std::vector<bool> is_certain(points.size(), false), is_doubtful(points.size(), false);
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        for (const std::uint32_t end : ends.of_cuts[i]) (cuts[i].is_certain ? is_certain : is_doubtful)[end] = true;
        if (!cuts[i].is_certain) runs.join(ends.of_cuts[i][0], ends.of_cuts[i][1]);
    }
    std::vector<Run> extents(points.size());
    for (std::uint32_t p = 0; p < points.size(); ++p) {
        if (!is_doubtful[p]) continue;
        Run& run = extents[runs.of(p)];
        run.low = glm::min(run.low, points[p]);
        run.high = glm::max(run.high, points[p]);
        if (is_certain[p]) ++run.certain_ends;
    }
    std::vector<bool> kept(cuts.size());
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        const Run& run = extents[runs.of(ends.of_cuts[i][0])];
        kept[i] = cuts[i].is_certain || (run.certain_ends > 1 && glm::distance(run.low, run.high) <= longest_bridge);
    }
    return kept;
}

/// The edge of a place; of a vertex, one of its edges.
std::uint32_t edge_of(const Surface& surface, const CutPlace& place) {
    std::array<std::uint32_t, 2> vertices{place.a, place.b};
    if (place.face == model::no_face) {
        const auto& corners = surface.topology().faces[surface.faces_around(place.a).front()].vertices;
        vertices[1] = corners[0] == place.a ? corners[1] : corners[0];
        if (vertices[1] < vertices[0]) std::swap(vertices[0], vertices[1]);
    }
    const std::vector<model::Edge>& edges = surface.topology().edges;
    const auto edge =
        std::lower_bound(edges.begin(), edges.end(), vertices,
                         [](const model::Edge& e, const std::array<std::uint32_t, 2>& v) { return e.vertices < v; });
    return static_cast<std::uint32_t>(edge - edges.begin());
}

}  // namespace

CutCurves find_cut_curves(const Surface& surface) {
    const GeneralPosition positions(surface);
    const FaceCutter cutter(surface, positions);
    const std::optional<std::vector<FaceCut>> found = find_cuts(surface, positions, cutter);
    if (!found) return {{}, {}, true};
    const std::vector<FaceCut>& cuts = *found;
    const Ends ends(cuts);
    std::vector<glm::dvec3> points;
    points.reserve(ends.places.size());
    for (const CutPlace& place : ends.places) points.push_back(cutter.point_of(place));
    const std::vector<bool> kept = kept_cuts(cuts, ends, points);

    CutCurves curves;
    constexpr std::uint32_t unused = 0xffffffffu;
    std::vector<std::uint32_t> node_of(points.size(), unused);
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        if (kept[i]) node_of[ends.of_cuts[i][0]] = node_of[ends.of_cuts[i][1]] = 0;
    }
    for (std::size_t p = 0; p < points.size(); ++p) {
        if (node_of[p] == unused) continue;
        node_of[p] = static_cast<std::uint32_t>(curves.nodes.size());
        curves.nodes.push_back({points[p], edge_of(surface, ends.places[p]), ends.places[p].face});
    }
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        if (!kept[i]) continue;
        curves.segments.push_back({cuts[i].faces, {node_of[ends.of_cuts[i][0]], node_of[ends.of_cuts[i][1]]}});
    }
    return curves;
}

}  // namespace croquis::lines
