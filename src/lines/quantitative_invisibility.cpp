// Appel's quantitative invisibility as seed D refines it. The number of layers over a line changes where it passes
// behind a silhouette (by two) or a border (by one), where it goes through a face (by one), and at cusps. So within a
// cluster of connected edges all numbers follow from one, and that one is asked for only if the cluster can be visible.
// Intersections lie within faces, connected to no edge: each of their pieces is asked for.
#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "base/parallel.h"
#include "lines/pieces.h"
#include "lines/stars.h"

namespace croquis::lines {
namespace {

constexpr std::uint32_t no_cluster = 0xffffffffu;
constexpr std::int32_t unset = std::numeric_limits<std::int32_t>::min();

/// A connected set of edges. Numbers are relative until `start` is added.
struct Cluster {
    std::int32_t start = unset;  ///< what to add to get layers
    bool is_hidden = false;      ///< for certain, throughout; only known where layers are not counted
    bool is_doubtful = false;
    /// The least relative number over its lines, and the longest piece that has it.
    std::int32_t least = std::numeric_limits<std::int32_t>::max();
    Piece best;
    std::int32_t best_number = 0;
    double best_length = -1;
    /// No start lies below these: no number of layers is negative, and what its own body hides has one at least. The
    /// second holds only for bodies that do not pass through themselves or each other.
    std::int32_t lowest_start = std::numeric_limits<std::int32_t>::min();
    std::int32_t lowest_start_of_solid = std::numeric_limits<std::int32_t>::min();
    bool is_pierced = false;

    [[nodiscard]] std::int32_t bound() const {
        return is_pierced ? lowest_start : std::max(lowest_start, lowest_start_of_solid);
    }
};

class Propagation {
public:
    explicit Propagation(const VisibilityTask& task)
        : task_(task),
          crossings_(task),
          ends_(layers_at_ends(task.surface, task.view, task.edges)),
          first_number_(task.edges.edges().size(), unset),
          cluster_of_(task.edges.edges().size(), no_cluster),
          gain_(task.edges.edges().size(), 0),
          base_(task.edges.vertices().size(), unset) {
        for (const Crossing& crossing : task.crossings) gain_[crossing.edge] += crossing.gain;
    }

    void run() {
        const auto count = static_cast<std::uint32_t>(task_.edges.edges().size());
        for (std::uint32_t e = 0; e < count; ++e) {
            const ImageEdge& edge = task_.edges.edges()[e];
            if (cluster_of_[e] != no_cluster || !edge.is_line) continue;
            if (edge.line_class != LineClass::intersection) gather_cluster(e);
        }
    }

    std::vector<Cluster>& clusters() { return clusters_; }
    [[nodiscard]] std::uint32_t cluster_of(std::uint32_t edge) const { return cluster_of_[edge]; }
    [[nodiscard]] const CrossingsByEdge& crossings() const { return crossings_; }

    /// Calls visit(piece, relative number) for the pieces of an edge within the frame.
    template <typename Visit>
    void visit_pieces(std::uint32_t e, const Visit& visit) const {
        const Interval inside = frame_interval(task_.view, task_.edges, task_.edges.edges()[e]);
        std::int32_t number = first_number_[e];
        double from = inside.from;
        const auto close = [&](double to) {
            to = std::clamp(to, inside.from, inside.to);
            if (from < to) visit(Piece{e, from, to, 0}, number);
            from = std::max(from, to);
        };
        for (const Crossing& crossing : crossings_.of(e)) {
            if (crossing.gain == 0) continue;
            close(crossing.share);
            number += crossing.gain;
        }
        close(inside.to);
    }

private:
    void gather_cluster(std::uint32_t first_edge) {
        const auto number = static_cast<std::uint32_t>(clusters_.size());
        clusters_.emplace_back();
        waiting_.assign(1, first_edge);
        cluster_of_[first_edge] = number;
        first_number_[first_edge] = 0;
        while (!waiting_.empty()) {
            const std::uint32_t e = waiting_.back();
            waiting_.pop_back();
            const ImageEdge& edge = task_.edges.edges()[e];
            measure(e, clusters_[number]);
            pass(edge.a, first_number_[e] - ends_[e][0], number);
            pass(edge.b, first_number_[e] + gain_[e] - ends_[e][1], number);
        }
    }

    /// Notes the layers over a vertex that its own faces do not make, and carries it on to the edges that end there.
    void pass(std::uint32_t vertex, std::int32_t base, std::uint32_t cluster) {
        if (task_.edges.vertices()[vertex].vertex == no_vertex) return;
        if (base_[vertex] != unset) {
            if (base_[vertex] != base) clusters_[cluster].is_doubtful = true;
            return;
        }
        base_[vertex] = base;
        for (const std::uint32_t e : task_.edges.edges_at(vertex)) {
            if (cluster_of_[e] != no_cluster) continue;
            cluster_of_[e] = cluster;
            const bool at_a = task_.edges.edges()[e].a == vertex;
            first_number_[e] = base + ends_[e][at_a ? 0 : 1] - (at_a ? 0 : gain_[e]);
            waiting_.push_back(e);
        }
    }

    void measure(std::uint32_t e, Cluster& cluster) {
        const ImageEdge& edge = task_.edges.edges()[e];
        cluster.is_doubtful |= edge.is_edge_on;
        for (const Crossing& crossing : crossings_.of(e)) {
            cluster.is_doubtful |= crossing.is_doubtful;
            cluster.is_pierced |= crossing.is_piercing;
        }
        visit_pieces(e, [&](const Piece& piece, std::int32_t number) {
            cluster.lowest_start = std::max(cluster.lowest_start, -number);
            if (edge.never_seen) cluster.lowest_start_of_solid = std::max(cluster.lowest_start_of_solid, 1 - number);
            if (!edge.is_line) return;
            const double piece_length = length_of(task_.edges, piece);
            const bool better = task_.count_layers ? piece_length > cluster.best_length
                                                   : number < cluster.least || (number == cluster.least &&
                                                                                piece_length > cluster.best_length);
            if (better) {
                cluster.best = piece;
                cluster.best_length = piece_length;
                cluster.best_number = number;
            }
            cluster.least = std::min(cluster.least, number);
        });
    }

    const VisibilityTask& task_;
    CrossingsByEdge crossings_;
    std::vector<std::array<std::int16_t, 2>> ends_;
    std::vector<std::int32_t> first_number_;  // relative layers right after a, one an edge
    std::vector<std::uint32_t> cluster_of_;   // one an edge
    std::vector<std::int32_t> gain_;          // of all its crossings, one an edge
    std::vector<std::int32_t> base_;          // one an image vertex
    std::vector<Cluster> clusters_;
    std::vector<std::uint32_t> waiting_;
};

/// Finds a cluster's start value. True when the probe had to be asked.
bool settle(const VisibilityTask& task, const LayerProbe& probe, Cluster& cluster) {
    if (cluster.best_length < 0 || cluster.is_doubtful) return false;
    const ImageEdge& edge = task.edges.edges()[cluster.best.edge];
    const double middle = 0.5 * (cluster.best.from + cluster.best.to);
    if (task.count_layers) {
        const auto layers = static_cast<std::int32_t>(probe.layers(edge, middle, 0xffffffffu));
        cluster.start = layers - cluster.best_number;
        cluster.is_doubtful = cluster.start < cluster.bound();
        return true;
    }
    if (cluster.bound() + cluster.least >= 1) {
        cluster.is_hidden = true;
        return false;
    }
    cluster.is_hidden = probe.layers(edge, middle, 1) > 0;
    cluster.start = -cluster.least;
    return true;
}

std::uint32_t layers_of(const VisibilityTask& task, const Cluster& cluster, std::int32_t number) {
    if (task.count_layers) return static_cast<std::uint32_t>(std::max(cluster.start + number, 0));
    return cluster.is_hidden || number > cluster.least ? 1 : 0;
}

}  // namespace

VisibilityResult quantitative_invisibility(const VisibilityTask& task, const LayerProbe& start,
                                           const LayerProbe& robust) {
    Propagation propagation(task);
    propagation.run();
    std::vector<Cluster>& clusters = propagation.clusters();
    std::vector<std::uint8_t> asked(clusters.size(), 0);
    parallel_for(clusters.size(), 8, [&](std::size_t begin, std::size_t end) {
        for (std::size_t c = begin; c < end; ++c) asked[c] = settle(task, start, clusters[c]) ? 1 : 0;
    });
    VisibilityResult result;
    result.clusters = clusters.size();
    result.start_values = static_cast<std::size_t>(std::count(asked.begin(), asked.end(), 1));
    for (const Cluster& cluster : clusters) result.doubtful_clusters += cluster.is_doubtful ? 1 : 0;
    for (std::uint32_t e = 0; e < task.edges.edges().size(); ++e) {
        const ImageEdge& edge = task.edges.edges()[e];
        if (!edge.is_line) continue;
        const std::uint32_t number_of_cluster = propagation.cluster_of(e);
        if (number_of_cluster == no_cluster) {
            probe_edge(task, propagation.crossings(), robust, e, result.pieces);
            continue;
        }
        const Cluster& cluster = clusters[number_of_cluster];
        const std::size_t first = result.pieces.size();
        if (cluster.is_doubtful) {
            probe_edge(task, propagation.crossings(), robust, e, result.pieces);
        } else {
            propagation.visit_pieces(e, [&](Piece piece, std::int32_t number) {
                piece.layers = layers_of(task, cluster, number);
                append_piece(result.pieces, piece);
            });
        }
        // What is seen edge-on along its faces may count as seen, although its own body lies before it.
        if (!edge.never_seen || cluster.is_pierced) continue;
        for (std::size_t p = first; p < result.pieces.size(); ++p) {
            result.pieces[p].layers = std::max(result.pieces[p].layers, 1u);
        }
    }
    return result;
}

}  // namespace croquis::lines
