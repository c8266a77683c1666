#include "lines/drafter.h"

#include <algorithm>
#include <chrono>
#include <glm/geometric.hpp>
#include <utility>

#include "base/error.h"
#include "base/log.h"
#include "lines/chains.h"
#include "lines/cleaning.h"
#include "lines/contours.h"
#include "lines/crossings.h"
#include "lines/features.h"
#include "lines/image_edges.h"
#include "lines/piercings.h"
#include "lines/ray_caster.h"
#include "lines/silhouette_finder.h"
#include "lines/tracing.h"
#include "lines/visibility.h"
#include "lines/walk_probe.h"

namespace croquis::lines {
namespace {

/// Surfaces nearer to a line than this hide nothing of it where rays decide: coplanar faces, parts that touch.
constexpr double touching = 1e-6;

/// Measures stretches of time one after the other.
class StopWatch {
public:
    double milliseconds() {
        const auto now = std::chrono::steady_clock::now();
        const double passed = std::chrono::duration<double, std::milli>(now - since_).count();
        since_ = now;
        return passed;
    }

private:
    std::chrono::steady_clock::time_point since_ = std::chrono::steady_clock::now();
};

/// Walks find no intersections: they take it that no sheets pass through each other.
LineClasses findable(const Options& options) {
    LineClasses classes = options.classes;
    if (options.visibility == Visibility::walking) classes.remove(LineClass::intersection);
    return classes;
}

void check(const Viewpoint& view) {
    if (!(view.width > 0 && view.height > 0 && view.width <= 1e6 && view.height <= 1e6)) {
        fail("expected a frame of up to 1000000 x 1000000 pixels, found {} x {}", view.width, view.height);
    }
    if (!(view.scale > 0) || !(glm::dot(view.back, view.back) > 0.5) || !(glm::dot(view.eye, view.eye) < 1e300)) {
        fail("expected a viewpoint with a place, a direction and a field of view");
    }
}

/// How one view's surface is looked at; nothing where everything counts as visible.
struct Look {
    std::unique_ptr<Walker> walker;
    std::unique_ptr<LayerProbe> start, robust;
};

}  // namespace

struct Drafter::State {
    State(std::shared_ptr<const Surface> of, const Options& asked)
        : surface(std::move(of)),
          options(asked),
          finder(make_finder(options.finder, *surface, options.seed)),
          features(*surface, findable(options), options.crease_angle),
          edges(*surface) {
        if (features.cuts.is_tangle) {
            warn("too many faces lie close together to look for intersections; drawn without");
        }
        if (options.visibility == Visibility::none) return;
        if (options.visibility != Visibility::walking || options.clean) rays = std::make_unique<RayCaster>(*surface);
        if (options.visibility != Visibility::walking) {
            piercings = std::make_unique<PiercingFinder>(*surface, features.cuts, *rays);
        }
    }

    Drawing draw(const Viewpoint& view);
    std::vector<Crossing> find_crossings(const Viewpoint& view);
    Look look_at(const Viewpoint& view, std::span<const std::uint32_t> silhouettes);
    VisibilityResult decide(const VisibilityTask& task, const Look& look) const;
    std::vector<ChainKey> keys_of(const std::vector<Piece>& pieces, const Viewpoint& view) const;

    std::shared_ptr<const Surface> surface;
    Options options;
    std::unique_ptr<SilhouetteFinder> finder;
    Features features;
    std::unique_ptr<RayCaster> rays;
    std::unique_ptr<PiercingFinder> piercings;
    ImageEdges edges;
    CrossingFinder crossing_finder;
    Report report;
};

std::vector<Crossing> Drafter::State::find_crossings(const Viewpoint& view) {
    crossing_finder.find(edges);
    std::vector<Crossing> crossings = crossing_finder.crossings();
    report.crossings = crossings.size();
    if (!piercings) return crossings;
    const std::vector<Crossing> pierced = piercings->find(edges, view);
    if (pierced.empty()) return crossings;
    crossings.insert(crossings.end(), pierced.begin(), pierced.end());
    std::stable_sort(crossings.begin(), crossings.end(), [](const Crossing& x, const Crossing& y) {
        return x.edge != y.edge ? x.edge < y.edge : x.share < y.share;
    });
    return crossings;
}

Look Drafter::State::look_at(const Viewpoint& view, std::span<const std::uint32_t> silhouettes) {
    Look look;
    if (options.visibility == Visibility::none) return look;
    if (options.visibility == Visibility::walking && Walker::serves(*surface, view)) {
        look.walker = std::make_unique<Walker>(*surface, view, edges, silhouettes);
        look.start = std::make_unique<WalkProbe>(*look.walker, *surface, edges, view, touching);
        look.robust = std::make_unique<WalkProbe>(*look.walker, *surface, edges, view, touching);
        return look;
    }
    if (!rays) rays = std::make_unique<RayCaster>(*surface);
    look.start = std::make_unique<RayProbe>(*rays, *surface, edges, view, touching);
    look.robust = std::make_unique<RayProbe>(*rays, *surface, edges, view, touching);
    return look;
}

VisibilityResult Drafter::State::decide(const VisibilityTask& task, const Look& look) const {
    switch (options.visibility) {
        case Visibility::none:
            return all_visible(task);
        case Visibility::ray_cast:
            return probed_visibility(task, *look.robust);
        default:
            return quantitative_invisibility(task, *look.start, *look.robust);
    }
}

std::vector<ChainKey> Drafter::State::keys_of(const std::vector<Piece>& pieces, const Viewpoint& view) const {
    std::vector<ChainKey> keys;
    keys.reserve(pieces.size());
    const std::vector<model::Face>& faces = surface->topology().faces;
    for (const Piece& piece : pieces) {
        const ImageEdge& edge = edges.edges()[piece.edge];
        const FacePair pair = edges.faces_of(edge);
        const bool takes_second = pair.first != pair.second && faces[pair.first].mesh != faces[pair.second].mesh &&
                                  !surface->front_facing(pair.first, view);
        keys.push_back({edge.line_class, faces[takes_second ? pair.second : pair.first].mesh, piece.layers});
    }
    return keys;
}

Drawing Drafter::State::draw(const Viewpoint& view) {
    check(view);
    report = {};
    const CleaningLimits limits(std::min(view.width, view.height));
    StopWatch watch;
    const std::vector<std::uint32_t>& silhouettes = finder->find(view);
    edges.gather(view, features, silhouettes, options.classes);
    report.find = watch.milliseconds();
    report.silhouette_edges = silhouettes.size();
    for (const ImageEdge& edge : edges.edges()) {
        report.line_edges += edge.is_line ? 1 : 0;
        report.occluding_edges += edge.step != 0 ? 1 : 0;
    }

    const std::vector<Crossing> crossings = find_crossings(view);
    const VisibilityTask task{*surface, view, edges, crossings, options.hidden};
    const Look look = look_at(view, silhouettes);
    VisibilityResult result = decide(task, look);
    report.clusters = result.clusters;
    report.start_values = result.start_values;
    report.doubtful_clusters = result.doubtful_clusters;
    const bool cleans = options.clean && options.visibility != Visibility::none;
    if (cleans) close_gaps(task, *rays, limits, result.pieces);
    if (!options.hidden) std::erase_if(result.pieces, [](const Piece& piece) { return piece.layers > 0; });
    report.visibility = watch.milliseconds();

    std::vector<ChainKey> keys = keys_of(result.pieces, view);
    if (look.start && options.classes.has(LineClass::contour)) find_contours(task, *look.start, result.pieces, keys);
    const Chains chains = chain_pieces(edges, result.pieces, keys);
    Drawing drawing = trace(task, chains, result.pieces, keys);
    if (cleans) {
        std::vector<Merit> merits = merits_of(task, *rays, limits, result.pieces, keys, chains);
        drawing = join_lines(drawing, view, limits, merits);
        drawing = smoothed(without_crumbs(drawing, limits, merits), limits);
    }
    drop_points(drawing);
    report.chain = watch.milliseconds();
    return drawing;
}

Drafter::Drafter(std::shared_ptr<const Surface> surface, const Options& options)
    : state_(std::make_unique<State>(std::move(surface), options)) {}

Drafter::Drafter(Drafter&&) noexcept = default;
Drafter& Drafter::operator=(Drafter&&) noexcept = default;
Drafter::~Drafter() = default;

Drawing Drafter::draw(const Viewpoint& view) { return state_->draw(view); }
const Report& Drafter::report() const { return state_->report; }
const Surface& Drafter::surface() const { return *state_->surface; }
const Options& Drafter::options() const { return state_->options; }

}  // namespace croquis::lines
