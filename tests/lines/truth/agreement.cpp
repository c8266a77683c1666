#include "truth/agreement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <string_view>

#include "base/random.h"
#include "truth/segment_index.h"

namespace croquis::lines::truth {
namespace {

/// Pixels within which a line counts as lying on an edge.
constexpr double on_line = 1e-4;
/// Pixels to an edge's end within which its neighbours' lines are as near.
constexpr double beside_vertex = 1e-3;
constexpr std::size_t most_examples = 12;

class Comparison {
public:
    Comparison(const ViewTruth& truth, const Drawing& drawing, bool hidden, const Sampling& sampling)
        : truth_(truth),
          drawing_(drawing),
          hidden_(hidden),
          sampling_(sampling),
          random_(sampling.seed, "samples"),
          drawn_(truth.view()),
          edges_(truth.view()) {
        for (std::uint32_t l = 0; l < drawing_.lines.size(); ++l) {
            for_each_piece(drawing_.lines[l],
                           [&](const ImagePoint& begin, const ImagePoint& end) { drawn_.add(l, begin, end); });
        }
        for (std::uint32_t e = 0; e < truth_.edges().size(); ++e) {
            edges_.add(e, truth_.edges()[e].begin, truth_.edges()[e].end);
        }
    }

    Agreement run() {
        for (const SeenEdge& edge : truth_.edges()) check_is_drawn(edge);
        for (const Line& line : drawing_.lines) check_is_true(line);
        return std::move(found_);
    }

private:
    [[nodiscard]] ImagePoint image_point(const LinePoint& point) const {
        const bool perspective = truth_.view().projection == model::Projection::perspective;
        return {point.position, perspective ? 1.0 / point.depth : -point.depth};
    }

    template <typename Use>
    void for_each_piece(const Line& line, const Use& use) const {
        const auto points = drawing_.points_of(line);
        for (std::size_t i = 0; i + 1 < points.size(); ++i) use(image_point(points[i]), image_point(points[i + 1]));
        if (line.closed && !points.empty()) use(image_point(points.back()), image_point(points.front()));
    }

    /// Calls `use(share)` for points at random on a piece, each of which stands for `Sampling::spacing` pixels; short
    /// pieces have one now and then.
    template <typename Use>
    void for_each_sample(double length, const Use& use) {
        const auto count = static_cast<std::size_t>(length / sampling_.spacing + random_.unit(next_++));
        for (std::size_t i = 0; i < count; ++i) {
            use((static_cast<double>(i) + random_.unit(next_++)) / static_cast<double>(count));
        }
    }

    void note(std::string_view kind, const ImagePoint& point, const std::string& text) {
        if (found_.examples.size() >= most_examples) return;
        found_.examples.push_back(fmt::format("{} at ({:.4f}, {:.4f}) depth {:.6f}: {}", kind, point.position.x,
                                              point.position.y, truth_.view().distance_of(point.nearness), text));
    }

    [[nodiscard]] std::string text_of(const SeenEdge& edge) const {
        const KnownEdge& known = truth_.surface().edges()[edge.known];
        std::string text = fmt::format("edge {} of", static_cast<std::int64_t>(static_cast<std::int32_t>(known.edge)));
        for (const LineClassInfo& info : line_class_infos()) {
            if (edge.classes.has(info.line_class)) text += fmt::format(" {}", info.name);
        }
        text += fmt::format(" faces {}", known.faces[0]);
        if (known.faces.size() > 1) text += fmt::format(",{}", known.faces[1]);
        return text;
    }

    // From the truth to the drawing.
    void check_is_drawn(const SeenEdge& edge) {
        if (!edge.required) return;
        for_each_sample(edge.length(), [&](double share) {
            const ImagePoint point = edge.at(share);
            const Sight sight = truth_.sight(edge, point);
            const double to_end = edge.length() * std::min(share, 1 - share);
            if (!sight.certain || to_end < beside_vertex) {
                found_.skipped += sampling_.spacing;
                return;
            }
            if (sight.layers > 0 && !hidden_) return;
            found_.expected += sampling_.spacing;
            check_line_at(edge, point, sight);
        });
    }

    void check_line_at(const SeenEdge& edge, const ImagePoint& point, const Sight& sight) {
        const double length = sampling_.spacing;
        const std::vector<SegmentIndex::Found> lines = drawn_.at(point, on_line);
        if (lines.empty()) {
            found_.missing += length;
            note("missing", point, fmt::format("{}, {} layers", text_of(edge), sight.layers));
            return;
        }
        if (lines.size() > 1) {
            found_.doubled += length;
            std::string text = text_of(edge);
            for (const auto& line : lines) text += fmt::format(" line {}", line.id);
            note("doubled", point, text);
            return;
        }
        const LineClass drawn_as = drawing_.lines[lines[0].id].line_class;
        const bool is_outline = edge.classes.has(LineClass::silhouette) || edge.classes.has(LineClass::border);
        if (is_outline && (drawn_as == LineClass::contour || edge.classes.has(drawn_as))) {
            // Only what is seen is part of the outline; hidden lines may be called either.
            if (sight.layers > 0) return;
            const Verdict contour = truth_.is_contour(edge, point);
            if (contour == Verdict::doubtful || (contour == Verdict::yes) == (drawn_as == LineClass::contour)) return;
            found_.wrong_contour += length;
            note("wrong contour", point, fmt::format("{}, drawn as {}", text_of(edge), info_of(drawn_as).name));
        } else if (!edge.classes.has(drawn_as)) {
            found_.wrong_class += length;
            note("wrong class", point, fmt::format("{}, drawn as {}", text_of(edge), info_of(drawn_as).name));
        }
    }

    // From the drawing to the truth.
    void check_is_true(const Line& line) {
        for (const LinePoint& point : drawing_.points_of(line)) {
            const auto near = edges_.at(image_point(point), on_line);
            if (!near.empty()) found_.farthest = std::max(found_.farthest, near[0].pixels);
        }
        for_each_piece(line, [&](const ImagePoint& begin, const ImagePoint& end) {
            const double whole = glm::distance(begin.position, end.position);
            for_each_sample(whole, [&](double share) {
                check_point(line, {begin.position + (end.position - begin.position) * share,
                                   begin.nearness + (end.nearness - begin.nearness) * share});
            });
        });
    }

    void check_point(const Line& line, const ImagePoint& point) {
        const double length = sampling_.spacing;
        found_.drawn += length;
        const std::vector<SegmentIndex::Found> near = edges_.at(point, on_line);
        if (near.empty()) {
            found_.stray += length;
            note("stray", point, fmt::format("{}, {} layers", info_of(line.line_class).name, line.layers));
            return;
        }
        const SeenEdge& edge = truth_.edges()[near[0].id];
        const Sight sight = truth_.sight(edge, point);
        if (!sight.certain) {
            found_.skipped += length;
        } else if (sight.layers != line.layers) {
            (line.visible() ? found_.falsely_visible : found_.wrong_layers) += length;
            note(line.visible() ? "falsely visible" : "wrong layers", point,
                 fmt::format("{}, {} layers, drawn with {}", text_of(edge), sight.layers, line.layers));
        }
    }

    const ViewTruth& truth_;
    const Drawing& drawing_;
    bool hidden_;
    Sampling sampling_;
    Random random_;
    std::uint64_t next_ = 0;
    SegmentIndex drawn_, edges_;
    Agreement found_;
};

}  // namespace

double Agreement::disagreeing() const {
    return missing + doubled + wrong_class + wrong_contour + stray + falsely_visible + wrong_layers;
}

double Agreement::share() const {
    const double whole = std::max(expected, drawn);
    return whole > 0 ? 1 - disagreeing() / whole : 1.0;
}

std::string Agreement::summary() const {
    std::string text = fmt::format(
        "{:.5f} % of {:.0f} px expected, {:.0f} drawn, {:.1f} skipped; missing {:.1f}, doubled {:.1f}, wrong class "
        "{:.1f}, "
        "wrong contour {:.1f}, stray {:.1f}, falsely visible {:.1f}, wrong layers {:.1f}; farthest {:.1e} px",
        100 * share(), expected, drawn, skipped, missing, doubled, wrong_class, wrong_contour, stray, falsely_visible,
        wrong_layers, farthest);
    for (const std::string& example : examples) text += "\n  " + example;
    return text;
}

Agreement& Agreement::operator+=(const Agreement& other) {
    expected += other.expected;
    drawn += other.drawn;
    skipped += other.skipped;
    missing += other.missing;
    doubled += other.doubled;
    wrong_class += other.wrong_class;
    wrong_contour += other.wrong_contour;
    stray += other.stray;
    falsely_visible += other.falsely_visible;
    wrong_layers += other.wrong_layers;
    farthest = std::max(farthest, other.farthest);
    for (const std::string& example : other.examples) {
        if (examples.size() < most_examples) examples.push_back(example);
    }
    return *this;
}

Agreement compare(const ViewTruth& truth, const Drawing& drawing, bool hidden, const Sampling& sampling) {
    return Comparison(truth, drawing, hidden, sampling).run();
}

}  // namespace croquis::lines::truth
