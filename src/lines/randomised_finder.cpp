#include "lines/randomised_finder.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>

#include "lines/edge_lottery.h"
#include "lines/facing.h"
#include "lines/ordered_set.h"

namespace croquis::lines {
namespace {
static double envd(const char*n,double d){const char*s=getenv(n);return s?atof(s):d;}

/// The edges at each vertex, regular or not.
class EdgeStars {
public:
    explicit EdgeStars(const Surface& surface) : starts_(surface.vertex_count() + 2, 0), edges_(2 * surface.edge_count()) {
        const std::vector<model::Edge>& edges = surface.topology().edges;
        for (const model::Edge& edge : edges) {
            for (const std::uint32_t v : edge.vertices) ++starts_[v + 2];
        }
        for (std::size_t v = 2; v < starts_.size(); ++v) starts_[v] += starts_[v - 1];
        for (std::uint32_t e = 0; e < edges.size(); ++e) {
            for (const std::uint32_t v : edges[e].vertices) edges_[starts_[v + 1]++] = e;
        }
    }

    [[nodiscard]] std::span<const std::uint32_t> around(std::uint32_t vertex) const {
        return std::span(edges_).subspan(starts_[vertex], starts_[vertex + 1] - starts_[vertex]);
    }

private:
    std::vector<std::uint32_t> starts_, edges_;
};

static const double draws_a_root = envd("DRAWS", 2.0);
static const double first_draws = envd("FIRST", 4.0);
static const double searches_a_root = envd("SEARCHES", 0.1);
static const double search_steps = envd("STEPS", 12);

class RandomisedFinder final : public SilhouetteFinder {
public:
    RandomisedFinder(const Surface& surface, std::uint64_t seed)
        : surface_(surface), lottery_(surface, seed), stars_(surface), set_(surface.edge_count()) {}

    const std::vector<std::uint32_t>& find(const Viewpoint& view) override {
        const Facing facing(surface_, view);
        const double root = std::sqrt(static_cast<double>(lottery_.size()));
        candidates_.clear();
        candidates_ = found_;
        const auto draws = static_cast<std::size_t>(root * draws_a_root * (found_.empty() ? first_draws : 1.0));
        if (lottery_.size() > 0) lottery_.draw(drawn_, draws, candidates_);
        drawn_ += draws;
        const auto searches = std::min(static_cast<std::size_t>(root * searches_a_root), found_.size());
        hits_.clear();
        facing.append_silhouettes(candidates_, hits_);
        for (const std::uint32_t e : hits_) trace(facing, e);
        for (std::size_t s = 0; s < searches; ++s) search(facing, view, found_[found_.size() * s / searches]);
        set_.take(found_);
        return found_;
    }

    void reset() override {
        found_.clear();
        drawn_ = 0;
    }

private:
    [[nodiscard]] bool silhouette(const Facing& facing, std::uint32_t edge) const {
        const FacePair& pair = surface_.pairs()[edge];
        return facing.front(pair.first) != facing.front(pair.second);
    }

    /// Adds the curve through a silhouette edge, with all its branches.
    void trace(const Facing& facing, std::uint32_t edge) {
        if (set_.has(edge)) return;
        set_.add(edge);
        const auto& ends = surface_.topology().edges[edge].vertices;
        open_.assign(ends.begin(), ends.end());
        while (!open_.empty()) {
            const std::uint32_t vertex = open_.back();
            open_.pop_back();
            for (const std::uint32_t e : stars_.around(vertex)) {
                if (set_.has(e) || !facing.silhouette(e)) continue;
                set_.add(e);
                const auto& [a, b] = surface_.topology().edges[e].vertices;
                open_.push_back(a == vertex ? b : a);
            }
        }
    }

    /// From an edge that was a silhouette in the last view and is none now: over the surface, away from the eye if the
    /// edge is turned to it now, else towards the eye, until a silhouette is met or the bound.
    void search(const Facing& facing, const Viewpoint& view, std::uint32_t edge) {
        if (set_.has(edge)) return;
        const double sense = facing.front(surface_.pairs()[edge].first) ? -1.0 : 1.0;
        const auto nearness = [&](std::uint32_t v) {
            const glm::dvec3 to_eye = view.towards_eye(surface_.point(v));
            return sense * (view.projection == model::Projection::perspective ? -glm::dot(to_eye, to_eye) : glm::dot(view.back, surface_.point(v)));
        };
        const auto& ends = surface_.topology().edges[edge].vertices;
        std::uint32_t vertex = ends[0];
        double reached = nearness(vertex);
        for (int step = 0; step < search_steps; ++step) {
            std::uint32_t best = vertex;
            for (const std::uint32_t e : stars_.around(vertex)) {
                if (facing.silhouette(e)) {
                    trace(facing, e);
                    return;
                }
                const auto& [a, b] = surface_.topology().edges[e].vertices;
                const std::uint32_t other = a == vertex ? b : a;
                const double near = nearness(other);
                if (near > reached) {
                    reached = near;
                    best = other;
                }
            }
            if (best == vertex) return;
            vertex = best;
        }
    }

    const Surface& surface_;
    EdgeLottery lottery_;
    EdgeStars stars_;
    OrderedSet set_;
    std::uint64_t drawn_ = 0;
    std::vector<std::uint32_t> candidates_, hits_, around_, open_, found_;
};

}  // namespace

std::unique_ptr<SilhouetteFinder> make_randomised_finder(const Surface& surface, std::uint64_t seed) {
    return std::make_unique<RandomisedFinder>(surface, seed);
}

}  // namespace croquis::lines
