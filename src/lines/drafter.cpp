#include "lines/drafter.h"

#include <algorithm>
#include <chrono>
#include <glm/geometric.hpp>
#include <utility>

#include "base/error.h"
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

void check(const Viewpoint& view) {
    if (!(view.width > 0 && view.height > 0 && view.width <= 1e6 && view.height <= 1e6)) {
        fail("expected a frame of up to 1000000 x 1000000 pixels, found {} x {}", view.width, view.height);
    }
    if (!(view.scale > 0) || !(glm::dot(view.back, view.back) > 0.5)) {
        fail("expected a viewpoint with a direction and a field of view");
    }
}

}  // namespace

struct Drafter::State {
    State(std::shared_ptr<const Surface> of, const Options& asked)
        : surface(std::move(of)),
          options(asked),
          finder(make_finder(options.finder, *surface, options.seed)),
          features(*surface, options.classes, options.crease_angle),
          edges(*surface) {
        if (options.visibility == Visibility::none || options.visibility == Visibility::walking) return;
        rays = std::make_unique<RayCaster>(*surface);
        piercings = std::make_unique<PiercingFinder>(*surface, *rays);
    }

    Drawing draw(const Viewpoint& view);
    std::vector<Crossing> find_crossings(const Viewpoint& view);
    VisibilityResult decide(const VisibilityTask& task) const;
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

VisibilityResult Drafter::State::decide(const VisibilityTask& task) const {
    if (options.visibility == Visibility::none || !rays) return all_visible(task);
    const RayProbe robust(*rays, *surface, edges, task.view, touching);
    if (options.visibility == Visibility::ray_cast) return probed_visibility(task, robust);
    const RayProbe start(*rays, *surface, edges, task.view, 0.0);
    return quantitative_invisibility(task, start, robust);
}

std::vector<ChainKey> Drafter::State::keys_of(const std::vector<Piece>& pieces, const Viewpoint& view) const {
    std::vector<ChainKey> keys;
    keys.reserve(pieces.size());
    const std::vector<model::Face>& faces = surface->topology().faces;
    for (const Piece& piece : pieces) {
        const ImageEdge& edge = edges.edges()[piece.edge];
        const FacePair pair = surface->pairs()[edge.edge];
        const bool takes_second = pair.first != pair.second && faces[pair.first].mesh != faces[pair.second].mesh &&
                                  !surface->front_facing(pair.first, view);
        keys.push_back({edge.line_class, faces[takes_second ? pair.second : pair.first].mesh, piece.layers});
    }
    return keys;
}

Drawing Drafter::State::draw(const Viewpoint& view) {
    check(view);
    report = {};
    const CleaningLimits limits;
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
    VisibilityResult result = decide(task);
    report.clusters = result.clusters;
    report.start_values = result.start_values;
    report.doubtful_clusters = result.doubtful_clusters;
    const bool cleans = options.clean && rays;
    if (cleans) close_gaps(task, *rays, limits, result.pieces);
    if (!options.hidden) std::erase_if(result.pieces, [](const Piece& piece) { return piece.layers > 0; });
    report.visibility = watch.milliseconds();

    std::vector<ChainKey> keys = keys_of(result.pieces, view);
    if (rays && options.classes.has(LineClass::contour)) find_contours(task, *rays, result.pieces, keys);
    const Chains chains = chain_pieces(edges, result.pieces, keys);
    Drawing drawing = trace(task, chains, result.pieces, keys);
    if (cleans) {
        std::vector<Merit> merits = merits_of(task, *rays, limits, result.pieces, keys, chains);
        drawing = join_lines(drawing, view, limits, merits);
        drawing = smoothed(without_crumbs(drawing, limits, merits), limits);
    }
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
