// Closing gaps: from each open end of a visible piece, the shortest way through hidden pieces to another one.
#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "lines/cleaning.h"
#include "lines/pieces.h"

namespace croquis::lines {
namespace {

constexpr std::uint32_t none = 0xffffffffu;

/// The pieces as a graph: an end of a piece meets the ends of others at a vertex, or at the cut between two pieces of
/// one edge. End 2 p is the earlier one of piece p, 2 p + 1 the later one.
class PieceGraph {
public:
    PieceGraph(const ImageEdges& edges, const std::vector<Piece>& pieces) : edges_(edges), pieces_(pieces) {
        first_piece_.assign(edges.edges().size() + 1, 0);
        for (const Piece& piece : pieces) ++first_piece_[piece.edge + 1];
        for (std::size_t e = 1; e < first_piece_.size(); ++e) first_piece_[e] += first_piece_[e - 1];
    }

    /// Calls visit(end) for every other end that meets this one.
    template <typename Visit>
    void visit_meeting(std::uint32_t end, const Visit& visit) const {
        const Piece& piece = pieces_[end / 2];
        const bool at_start = end % 2 == 0;
        const ImageEdge& edge = edges_.edges()[piece.edge];
        if (at_start ? piece.from > 0 : piece.to < 1) {
            const std::uint32_t other = at_start ? end / 2 - 1 : end / 2 + 1;
            if (other >= pieces_.size() || pieces_[other].edge != piece.edge) return;
            if (at_start ? pieces_[other].to == piece.from : pieces_[other].from == piece.to) {
                visit(2 * other + (at_start ? 1 : 0));
            }
            return;
        }
        const std::uint32_t vertex = at_start ? edge.a : edge.b;
        for (const std::uint32_t e : edges_.edges_at(vertex)) {
            if (first_piece_[e] == first_piece_[e + 1]) continue;
            const bool other_at_start = edges_.edges()[e].a == vertex;
            const std::uint32_t other = other_at_start ? first_piece_[e] : first_piece_[e + 1] - 1;
            if (other_at_start ? pieces_[other].from > 0 : pieces_[other].to < 1) continue;
            const std::uint32_t other_end = 2 * other + (other_at_start ? 0 : 1);
            if (other_end != end) visit(other_end);
        }
    }

    [[nodiscard]] LineClass class_of(std::uint32_t piece) const {
        return edges_.edges()[pieces_[piece].edge].line_class;
    }
    [[nodiscard]] double length_of(std::uint32_t piece) const { return lines::length_of(edges_, pieces_[piece]); }

    /// True when no visible piece of the class goes on from a visible end.
    [[nodiscard]] bool is_open(std::uint32_t end) const {
        bool open = true;
        visit_meeting(end, [&](std::uint32_t other) {
            if (pieces_[other / 2].layers == 0 && class_of(other / 2) == class_of(end / 2)) open = false;
        });
        return open;
    }

private:
    const ImageEdges& edges_;
    const std::vector<Piece>& pieces_;
    std::vector<std::uint32_t> first_piece_;
};

class GapCloser {
public:
    GapCloser(const VisibilityTask& task, const RayCaster& rays, const CleaningLimits& limits,
              std::vector<Piece>& pieces)
        : task_(task), rays_(rays), limits_(limits), pieces_(pieces), graph_(task.edges, pieces) {}

    void run() {
        for (std::uint32_t end = 0; end < 2 * pieces_.size(); ++end) {
            if (pieces_[end / 2].layers != 0 || !graph_.is_open(end)) continue;
            for (const std::uint32_t piece : way_from(end)) pieces_[piece].layers = 0;
        }
    }

private:
    struct Step {
        std::uint32_t end;   // at which the way leaves its piece
        std::uint32_t from;  // index of the step before
        double length;
    };

    /// The hidden pieces of the shortest way to another open end, if there is one that is short enough.
    std::vector<std::uint32_t> way_from(std::uint32_t start) {
        std::vector<Step> steps{{start, none, 0}};
        std::optional<std::size_t> best;
        double best_length = limits_.longest_gap;
        for (std::size_t i = 0; i < steps.size() && steps.size() < 64; ++i) {
            const Step step = steps[i];
            bool arrives = false;
            graph_.visit_meeting(step.end, [&](std::uint32_t end) {
                if (end / 2 == start / 2 || graph_.class_of(end / 2) != graph_.class_of(start / 2)) return;
                if (pieces_[end / 2].layers == 0) {
                    arrives = arrives || i > 0;
                    return;
                }
                const double length = step.length + graph_.length_of(end / 2);
                if (length < best_length && !is_on_way(steps, i, end / 2) && is_hidden_by_own_fold(end / 2)) {
                    steps.push_back({end ^ 1u, static_cast<std::uint32_t>(i), length});
                }
            });
            if (arrives && step.length < best_length) {
                best = i;
                best_length = step.length;
            }
        }
        std::vector<std::uint32_t> way;
        if (best) {
            for (std::uint32_t i = static_cast<std::uint32_t>(*best); i != 0; i = steps[i].from) {
                way.push_back(steps[i].end / 2);
            }
        }
        return way;
    }

    static bool is_on_way(const std::vector<Step>& steps, std::size_t i, std::uint32_t piece) {
        for (std::uint32_t k = static_cast<std::uint32_t>(i); k != none; k = steps[k].from) {
            if (steps[k].end / 2 == piece) return true;
        }
        return false;
    }

    [[nodiscard]] bool is_hidden_by_own_fold(std::uint32_t piece) const {
        const ImageEdge& edge = task_.edges.edges()[pieces_[piece].edge];
        const ImagePoint image = task_.edges.point_at(edge, 0.5 * (pieces_[piece].from + pieces_[piece].to));
        const glm::dvec3 point = task_.view.unproject(image);
        const glm::dvec3 towards = task_.view.towards_eye(point);
        const bool perspective = task_.view.projection == model::Projection::perspective;
        const FacePair pair = task_.edges.faces_of(edge);
        return rays_.layers(point, point + towards * (perspective ? 1.0 : 4.0), std::array{pair.first, pair.second},
                            limits_.longest_gap * task_.view.units_a_pixel(image.nearness), 1) == 0;
    }

    const VisibilityTask& task_;
    const RayCaster& rays_;
    const CleaningLimits& limits_;
    std::vector<Piece>& pieces_;
    PieceGraph graph_;
};

}  // namespace

CleaningLimits::CleaningLimits(double frame) {
    const double factor = std::max(1.0, frame / 1024);
    for (double* length :
         {&longest_gap, &crumb, &long_line, &depth_step, &reach, &longest_spur, &joint_depth, &shadow}) {
        *length *= factor;
    }
}

void close_gaps(const VisibilityTask& task, const RayCaster& rays, const CleaningLimits& limits,
                std::vector<Piece>& pieces) {
    GapCloser(task, rays, limits, pieces).run();
}

}  // namespace croquis::lines
