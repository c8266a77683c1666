#include "lines/chains.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace croquis::lines {
namespace {

constexpr std::uint32_t no_end = 0xffffffffu;
constexpr double straight_enough = 0.70710678;  // cosine of the largest turn through a junction

/// Ends of pieces: 2 p is the earlier end of piece p, 2 p + 1 the later one.
class Joining {
public:
    Joining(const ImageEdges& edges, std::span<const Piece> pieces, std::span<const ChainKey> keys)
        : edges_(edges), pieces_(pieces), keys_(keys), joined_(pieces.size() * 2, no_end) {
        first_piece_.assign(edges.edges().size() + 1, 0);
        for (const Piece& piece : pieces) ++first_piece_[piece.edge + 1];
        for (std::size_t e = 1; e < first_piece_.size(); ++e) first_piece_[e] += first_piece_[e - 1];
        for (std::uint32_t v = 0; v < edges.vertices().size(); ++v) join_at(v);
        join_within_edges();
    }

    [[nodiscard]] std::uint32_t joined(std::uint32_t end) const { return joined_[end]; }

private:
    struct Candidate {
        double cosine;
        std::uint32_t first, second;
    };

    void join_at(std::uint32_t vertex) {
        ends_.clear();
        for (const std::uint32_t e : edges_.edges_at(vertex)) {
            if (first_piece_[e] == first_piece_[e + 1]) continue;
            const bool at_a = edges_.edges()[e].a == vertex;
            const std::uint32_t piece = at_a ? first_piece_[e] : first_piece_[e + 1] - 1;
            if (at_a ? pieces_[piece].from == 0 : pieces_[piece].to == 1) ends_.push_back(2 * piece + (at_a ? 0 : 1));
        }
        if (ends_.size() < 2) return;
        candidates_.clear();
        for (std::size_t i = 0; i < ends_.size(); ++i) {
            std::size_t alike = 0;
            for (std::size_t k = 0; k < ends_.size(); ++k) alike += keys_[ends_[i] / 2] == keys_[ends_[k] / 2] ? 1 : 0;
            for (std::size_t k = i + 1; k < ends_.size(); ++k) {
                if (!(keys_[ends_[i] / 2] == keys_[ends_[k] / 2])) continue;
                const double cosine = -glm::dot(direction(ends_[i]), direction(ends_[k]));
                if (alike == 2 || cosine > straight_enough) candidates_.push_back({cosine, ends_[i], ends_[k]});
            }
        }
        std::stable_sort(candidates_.begin(), candidates_.end(),
                         [](const Candidate& x, const Candidate& y) { return x.cosine > y.cosine; });
        for (const Candidate& candidate : candidates_) join(candidate.first, candidate.second);
    }

    void join_within_edges() {
        for (std::uint32_t p = 1; p < pieces_.size(); ++p) {
            const Piece &before = pieces_[p - 1], &after = pieces_[p];
            if (before.edge == after.edge && before.to == after.from && keys_[p - 1] == keys_[p]) {
                join(2 * (p - 1) + 1, 2 * p);
            }
        }
    }

    void join(std::uint32_t first, std::uint32_t second) {
        if (joined_[first] != no_end || joined_[second] != no_end) return;
        joined_[first] = second;
        joined_[second] = first;
    }

    /// From an end into its piece, in the picture.
    [[nodiscard]] glm::dvec2 direction(std::uint32_t end) const {
        const ImageEdge& edge = edges_.edges()[pieces_[end / 2].edge];
        const glm::dvec2 along = edges_.vertices()[edge.b].position - edges_.vertices()[edge.a].position;
        const double length = glm::length(along);
        if (!(length > 0)) return glm::dvec2(0.0);
        return (end % 2 == 0 ? 1.0 : -1.0) / length * along;
    }

    const ImageEdges& edges_;
    std::span<const Piece> pieces_;
    std::span<const ChainKey> keys_;
    std::vector<std::uint32_t> joined_;
    std::vector<std::uint32_t> first_piece_;  // one an image edge
    std::vector<std::uint32_t> ends_;
    std::vector<Candidate> candidates_;
};

}  // namespace

Chains chain_pieces(const ImageEdges& edges, std::span<const Piece> pieces, std::span<const ChainKey> keys) {
    const Joining joining(edges, pieces, keys);
    Chains chains;
    chains.links.reserve(pieces.size());
    std::vector<bool> taken(pieces.size(), false);
    const auto follow = [&](std::uint32_t start, bool closed) {  // `start` is the end at which the chain begins
        Chains::Chain chain{static_cast<std::uint32_t>(chains.links.size()), 0, closed};
        std::uint32_t end = start;
        while (end != no_end && !taken[end / 2]) {
            taken[end / 2] = true;
            chains.links.push_back({end / 2, end % 2 == 1});
            end = joining.joined(end ^ 1u);
        }
        chain.link_count = static_cast<std::uint32_t>(chains.links.size()) - chain.first_link;
        chains.chains.push_back(chain);
    };
    for (std::uint32_t p = 0; p < pieces.size(); ++p) {
        if (taken[p]) continue;
        if (joining.joined(2 * p) == no_end) {
            follow(2 * p, false);
        } else if (joining.joined(2 * p + 1) == no_end) {
            follow(2 * p + 1, false);
        }
    }
    for (std::uint32_t p = 0; p < pieces.size(); ++p) {
        if (!taken[p]) follow(2 * p, true);
    }
    return chains;
}

}  // namespace croquis::lines
