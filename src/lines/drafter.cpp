#include "lines/drafter.h"

#include <utility>

#include "lines/silhouette_finder.h"

namespace croquis::lines {

struct Drafter::State {
    std::shared_ptr<const Surface> surface;
    Options options;
    std::unique_ptr<SilhouetteFinder> finder;
    Report report;
};

Drafter::Drafter(std::shared_ptr<const Surface> surface, const Options& options)
    : state_(std::make_unique<State>(State{std::move(surface), options, nullptr, {}})) {
    state_->finder = make_finder(options.finder, *state_->surface, options.seed);
}

Drafter::Drafter(Drafter&&) noexcept = default;
Drafter& Drafter::operator=(Drafter&&) noexcept = default;
Drafter::~Drafter() = default;

// A first version without visibility and chains: each silhouette edge is a line.
Drawing Drafter::draw(const Viewpoint& view) {
    Drawing drawing{view.width, view.height, {}, {}};
    const Surface& surface = *state_->surface;
    for (const std::uint32_t e : state_->finder->find(view)) {
        const auto& ends = surface.topology().edges[e].vertices;
        Line line;
        line.first_point = static_cast<std::uint32_t>(drawing.points.size());
        line.point_count = 2;
        for (const std::uint32_t v : ends) {
            const glm::dvec3 point = surface.point(v);
            drawing.points.push_back({view.project(point).position, view.eye_distance(point),
                                      glm::vec3(surface.planes()[surface.pairs()[e].first])});
        }
        drawing.lines.push_back(line);
    }
    return drawing;
}

const Report& Drafter::report() const { return state_->report; }
const Surface& Drafter::surface() const { return *state_->surface; }
const Options& Drafter::options() const { return state_->options; }

}  // namespace croquis::lines
