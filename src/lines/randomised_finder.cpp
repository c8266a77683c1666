#include "lines/randomised_finder.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "lines/edge_lottery.h"
#include "lines/facing.h"
#include "lines/ordered_set.h"

namespace croquis::lines {
namespace {

// Measured over turning sequences (bench/finders_bench.cpp). Detecting a curve with constant probability takes draws in
// proportion to the root of the number of edges (seed D).
constexpr double draws_a_root = 1.0;
constexpr double searches_a_root = 0.04;
constexpr double first_view = 8.0;     // a view without one before it draws that many times as often
constexpr std::size_t old_a_test = 2;  // of so many old silhouettes one is tested again
constexpr int most_search_steps = 12;

/// An edge at a vertex, with its faces: what a step over the surface looks at stands in one place.
struct Spoke {
    std::uint32_t edge = 0;
    FacePair faces;
};

/// The regular edges at each vertex.
class EdgeStars {
public:
    explicit EdgeStars(const Surface& surface) : starts_(surface.vertex_count() + 2, 0) {
        const std::vector<model::Edge>& edges = surface.topology().edges;
        const std::span<const FacePair> pairs = surface.pairs();
        for (std::uint32_t e = 0; e < edges.size(); ++e) {
            if (pairs[e].first == pairs[e].second) continue;
            for (const std::uint32_t v : edges[e].vertices) ++starts_[v + 2];
        }
        for (std::size_t v = 2; v < starts_.size(); ++v) starts_[v] += starts_[v - 1];
        spokes_.resize(starts_.back());
        for (std::uint32_t e = 0; e < edges.size(); ++e) {
            if (pairs[e].first == pairs[e].second) continue;
            for (const std::uint32_t v : edges[e].vertices) spokes_[starts_[v + 1]++] = {e, pairs[e]};
        }
    }

    [[nodiscard]] std::span<const Spoke> around(std::uint32_t vertex) const {
        return std::span(spokes_).subspan(starts_[vertex], starts_[vertex + 1] - starts_[vertex]);
    }

private:
    std::vector<std::uint32_t> starts_;
    std::vector<Spoke> spokes_;
};

class RandomisedFinder final : public SilhouetteFinder {
public:
    RandomisedFinder(const Surface& surface, std::uint64_t seed)
        : surface_(surface),
          lottery_(surface, seed),
          stars_(surface),
          set_(surface.edge_count()),
          reached_(surface.vertex_count()) {}

    const std::vector<std::uint32_t>& find(const Viewpoint& view) override {
        const Facing facing(surface_, view);
        const double root = std::sqrt(static_cast<double>(lottery_.size()));
        candidates_.clear();
        for (std::size_t i = 0; i < found_.size(); i += old_a_test) candidates_.push_back(found_[i]);
        draw(static_cast<std::size_t>(root * draws_a_root * (found_.empty() ? first_view : 1.0)));
        hits_.clear();
        facing.append_silhouettes(candidates_, hits_);
        const std::size_t searches = std::min(static_cast<std::size_t>(root * searches_a_root), found_.size());
        for (std::size_t s = 0; s < searches; ++s) search(facing, view, found_[found_.size() * s / searches]);
        trace(facing);
        reached_.clear();
        set_.take(found_);
        return found_;
    }

    void reset() override {
        found_.clear();
        drawn_ = 0;
    }

private:
    void draw(std::size_t count) {
        if (lottery_.size() > 0) lottery_.draw(drawn_, count, candidates_);
        drawn_ += count;
    }

    /// Adds the curves through the hits, with all their branches. All their ends go on a step at a time, so that many
    /// loads are under way.
    void trace(const Facing& facing) {
        while (!hits_.empty()) {
            add_hits();
            hits_.clear();
            for (const std::uint32_t v : open_) {
                const std::span<const Spoke> star = stars_.around(v);
                std::size_t next = hits_.size();
                hits_.resize(next + star.size() + 1);
                for (const Spoke& spoke : star) {
                    hits_[next] = spoke.edge;
                    next += facing.differ(spoke.faces) ? 1 : 0;
                }
                hits_.resize(next);
            }
        }
    }

    /// Hits that are new join the set; vertices of theirs that are new are open.
    void add_hits() {
        open_.clear();
        for (const std::uint32_t e : hits_) {
            if (set_.has(e)) continue;
            set_.add(e);
            for (const std::uint32_t v : surface_.topology().edges[e].vertices) {
                if (reached_.has(v)) continue;
                reached_.add(v);
                open_.push_back(v);
            }
        }
    }

    /// From an edge that was a silhouette in the last view and is none now: over the surface, away from the eye if the
    /// edge is turned to it now, else towards the eye, until a silhouette is hit or the bound is reached (seed D).
    void search(const Facing& facing, const Viewpoint& view, std::uint32_t edge) {
        const FacePair& faces = surface_.pairs()[edge];
        if (facing.differ(faces)) return;
        const double sense = facing.front(faces.first) ? -1.0 : 1.0;
        std::uint32_t vertex = surface_.topology().edges[edge].vertices[0];
        double reached = sense * nearness(view, vertex);
        for (int step = 0; step < most_search_steps; ++step) {
            std::uint32_t next = vertex;
            for (const Spoke& spoke : stars_.around(vertex)) {
                if (facing.differ(spoke.faces)) {
                    hits_.push_back(spoke.edge);
                    return;
                }
                const auto& [a, b] = surface_.topology().edges[spoke.edge].vertices;
                const std::uint32_t other = a == vertex ? b : a;
                const double near = sense * nearness(view, other);
                if (near <= reached) continue;
                reached = near;
                next = other;
            }
            if (next == vertex) return;
            vertex = next;
        }
    }

    /// Grows towards the eye.
    [[nodiscard]] double nearness(const Viewpoint& view, std::uint32_t vertex) const {
        const glm::dvec3 point = surface_.point(vertex);
        if (view.projection == model::Projection::parallel) return glm::dot(view.back, point);
        const glm::dvec3 to_eye = view.towards_eye(point);
        return -glm::dot(to_eye, to_eye);
    }

    const Surface& surface_;
    EdgeLottery lottery_;
    EdgeStars stars_;
    OrderedSet set_, reached_;  // silhouette edges; vertices
    std::uint64_t drawn_ = 0;
    std::vector<std::uint32_t> candidates_;  // edges to test first: old silhouettes and drawn ones
    std::vector<std::uint32_t> hits_;        // silhouettes, some already in the set
    std::vector<std::uint32_t> open_;        // vertices just reached
    std::vector<std::uint32_t> found_;
};

}  // namespace

std::unique_ptr<SilhouetteFinder> make_randomised_finder(const Surface& surface, std::uint64_t seed) {
    return std::make_unique<RandomisedFinder>(surface, seed);
}

}  // namespace croquis::lines
