// Crumbs: short lines that tell nothing about the shape.
#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <numeric>

#include "base/parallel.h"
#include "lines/cleaning.h"
#include "lines/pieces.h"
#include "lines/segment_grid.h"

namespace croquis::lines {
namespace {

class DepthSteps {
public:
    DepthSteps(const VisibilityTask& task, const RayCaster& rays, const CleaningLimits& limits)
        : task_(task), rays_(rays), limits_(limits) {}

    /// True when nothing of the model lies close behind the outer side of a piece.
    [[nodiscard]] bool at(const Piece& piece) const {
        constexpr double aside = 0.25;  // pixels
        const ImageEdge& edge = task_.edges.edges()[piece.edge];
        if (edge.step == 0 || !(task_.edges.length_of(edge) > 0)) return false;
        const ImagePoint point = task_.edges.point_beside(edge, 0.5 * (piece.from + piece.to), aside);
        const glm::dvec3 from = task_.view.unproject(point);
        const glm::dvec3 away = -glm::normalize(task_.view.towards_eye(from));
        const double reach = limits_.depth_step * task_.view.units_a_pixel(point.nearness);
        const FacePair pair = task_.edges.faces_of(edge);
        return rays_.layers(from, from + reach * away, std::array{pair.first, pair.second}, 0.0, 1) == 0;
    }

private:
    const VisibilityTask& task_;
    const RayCaster& rays_;
    const CleaningLimits& limits_;
};

/// Chains that hang together at vertices, or where the class of a line changes: visible ones with visible ones, hidden
/// ones with hidden ones.
class Companies {
public:
    Companies(const VisibilityTask& task, const std::vector<Piece>& pieces, const Chains& chains)
        : parents_(chains.chains.size()) {
        for (std::uint32_t c = 0; c < parents_.size(); ++c) parents_[c] = c;
        std::vector<std::uint32_t> chain_of(pieces.size());
        for (std::uint32_t c = 0; c < parents_.size(); ++c) {
            for (const Link& link : chains.links_of(chains.chains[c])) chain_of[link.piece] = c;
        }
        // At each vertex, the first chain of visible lines and of hidden ones.
        std::array<std::vector<std::uint32_t>, 2> chain_at;
        for (auto& one : chain_at) one.assign(task.edges.vertices().size(), none);
        for (std::uint32_t p = 0; p < pieces.size(); ++p) {
            const Piece& piece = pieces[p];
            const ImageEdge& edge = task.edges.edges()[piece.edge];
            const bool is_hidden = piece.layers > 0;
            const auto meet = [&](std::uint32_t vertex) {
                std::uint32_t& first = chain_at[is_hidden ? 1 : 0][vertex];
                if (first == none) first = chain_of[p];
                join(first, chain_of[p]);
            };
            if (piece.from == 0) meet(edge.a);
            if (piece.to == 1) meet(edge.b);
            if (p == 0 || pieces[p - 1].edge != piece.edge || pieces[p - 1].to != piece.from) continue;
            if ((pieces[p - 1].layers > 0) == is_hidden) join(chain_of[p - 1], chain_of[p]);
        }
    }

    [[nodiscard]] std::uint32_t of(std::uint32_t chain) {
        while (parents_[chain] != chain) chain = parents_[chain] = parents_[parents_[chain]];
        return chain;
    }

private:
    static constexpr std::uint32_t none = 0xffffffffu;

    void join(std::uint32_t a, std::uint32_t b) {
        const auto [low, high] = std::minmax({of(a), of(b)});
        parents_[high] = low;
    }

    std::vector<std::uint32_t> parents_;
};

/// For each chain, the length of the lines that hang together with it, or that of its longest edge if a part of it is
/// hidden or outside of the frame.
std::vector<double> company_of(const VisibilityTask& task, const std::vector<Piece>& pieces, const Chains& chains,
                               const std::vector<double>& lengths) {
    Companies companies(task, pieces, chains);
    std::vector<double> total(lengths.size(), 0), company(lengths.size(), 0);
    for (std::uint32_t c = 0; c < lengths.size(); ++c) total[companies.of(c)] += lengths[c];
    for (std::uint32_t c = 0; c < lengths.size(); ++c) {
        company[c] = total[companies.of(c)];
        for (const Link& link : chains.links_of(chains.chains[c])) {
            company[c] = std::max(company[c], task.edges.length_of(task.edges.edges()[pieces[link.piece].edge]));
        }
    }
    return company;
}

}  // namespace

std::vector<Merit> merits_of(const VisibilityTask& task, const RayCaster& rays, const CleaningLimits& limits,
                             const std::vector<Piece>& pieces, const std::vector<ChainKey>& keys,
                             const Chains& chains) {
    std::vector<double> lengths(chains.chains.size(), 0);
    for (std::size_t c = 0; c < chains.chains.size(); ++c) {
        for (const Link& link : chains.links_of(chains.chains[c]))
            lengths[c] += length_of(task.edges, pieces[link.piece]);
    }
    const std::vector<double> company = company_of(task, pieces, chains, lengths);
    std::vector<Merit> merits(chains.chains.size());
    const DepthSteps steps(task, rays, limits);
    parallel_for(merits.size(), 8, [&](std::size_t begin, std::size_t end) {
        for (std::size_t c = begin; c < end; ++c) {
            merits[c] = {lengths[c], 0, 0, company[c]};
            const auto links = chains.links_of(chains.chains[c]);
            if (keys[links[0].piece].line_class == LineClass::contour) merits[c].length_with_step = lengths[c];
            if (keys[links[0].piece].line_class != LineClass::silhouette || lengths[c] >= limits.long_line) continue;
            for (const Link& link : links) {
                const Piece& piece = pieces[link.piece];
                if (steps.at(piece)) merits[c].length_with_step += length_of(task.edges, piece);
                if (task.edges.edges()[piece.edge].is_sharp) merits[c].sharp_length += length_of(task.edges, piece);
            }
        }
    });
    return merits;
}

namespace {

bool is_crumb(LineClass line_class, const Merit& merit, const CleaningLimits& limits) {
    if (merit.length >= limits.long_line) return false;
    switch (line_class) {
        case LineClass::contour:
            return merit.length < limits.crumb && merit.company < limits.crumb;
        case LineClass::silhouette:
            return std::max(merit.length_with_step, merit.sharp_length) < 0.5 * merit.length ||
                   merit.company < limits.crumb;
        case LineClass::tagged:
            return false;
        default:
            return merit.company < limits.crumb;
    }
}

/// The visible lines around a line.
class Neighbours {
public:
    Neighbours(const Drawing& drawing, double near) : drawing_(drawing), grid_(drawing, near), near_(near) {}

    /// True for a line that runs, over all its length, beside those of the chosen lines that are of its class or of one
    /// that comes before it.
    [[nodiscard]] bool cover(std::uint32_t line, const std::vector<bool>& chosen) const {
        const auto points = drawing_.points_of(drawing_.lines[line]);
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            const glm::dvec2 &from = points[i].position, &to = points[i + 1].position;
            const int samples = 1 + static_cast<int>(glm::distance(from, to) / near_);
            for (int k = 0; k <= samples; ++k) {
                if (!cover(glm::mix(from, to, double(k) / samples), line, chosen)) return false;
            }
        }
        return true;
    }

    /// True for a line that leads from one to another, or to the same.
    [[nodiscard]] bool hold_both_ends(std::uint32_t line) const {
        const auto points = drawing_.points_of(drawing_.lines[line]);
        return holds(points.front().position, line) && holds(points.back().position, line);
    }

private:
    [[nodiscard]] bool cover(const glm::dvec2& point, std::uint32_t line, const std::vector<bool>& chosen) const {
        bool covered = false;
        grid_.visit_near(point, near_, [&](const SegmentGrid::Nearest& nearest) {
            if (nearest.line == line || !chosen[nearest.line] || nearest.distance > near_) return;
            // What runs on beyond the end of another would leave a gap.
            if (is_at_end(nearest) && nearest.distance > touching) return;
            covered = covered || drawing_.lines[nearest.line].line_class <= drawing_.lines[line].line_class;
        });
        return covered;
    }

    [[nodiscard]] bool is_at_end(const SegmentGrid::Nearest& nearest) const {
        const Line& line = drawing_.lines[nearest.line];
        if (line.closed) return false;
        return (nearest.segment == 0 && nearest.share <= 0) ||
               (nearest.segment + 2 == line.point_count && nearest.share >= 1);
    }

    [[nodiscard]] bool holds(const glm::dvec2& end, std::uint32_t line) const {
        bool held = false;
        grid_.visit_near(end, touching, [&](const SegmentGrid::Nearest& nearest) {
            held = held || (nearest.line != line && nearest.distance <= touching);
        });
        return held;
    }

    static constexpr double touching = 0.75;  // pixels: ends have been moved by the joining of others

    const Drawing& drawing_;
    SegmentGrid grid_;
    double near_;
};

/// Which lines to keep: from long ones to short ones, those that are no crumbs and run beside none that is kept.
std::vector<bool> kept_lines(const Drawing& drawing, const CleaningLimits& limits, const std::vector<Merit>& merits) {
    const Neighbours neighbours(drawing, limits.shadow);
    std::vector<std::uint32_t> order(drawing.lines.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t x, std::uint32_t y) { return merits[x].length > merits[y].length; });
    std::vector<bool> kept(drawing.lines.size(), false);
    for (const std::uint32_t l : order) {
        const Line& line = drawing.lines[l];
        if (!line.visible()) {
            kept[l] = merits[l].length >= limits.crumb || merits[l].company >= limits.crumb;
            continue;
        }
        const bool connects = line.line_class > LineClass::silhouette && neighbours.hold_both_ends(l);
        if (is_crumb(line.line_class, merits[l], limits) && !connects) continue;
        kept[l] = merits[l].length >= limits.long_line || !neighbours.cover(l, kept);
    }
    return kept;
}

}  // namespace

Drawing without_crumbs(const Drawing& drawing, const CleaningLimits& limits, const std::vector<Merit>& merits) {
    const std::vector<bool> kept = kept_lines(drawing, limits, merits);
    Drawing result{drawing.width, drawing.height, {}, {}};
    for (std::uint32_t l = 0; l < drawing.lines.size(); ++l) {
        if (!kept[l]) continue;
        Line line = drawing.lines[l];
        const std::span<const LinePoint> points = drawing.points_of(line);
        line.first_point = static_cast<std::uint32_t>(result.points.size());
        result.points.insert(result.points.end(), points.begin(), points.end());
        result.lines.push_back(line);
    }
    return result;
}

}  // namespace croquis::lines
