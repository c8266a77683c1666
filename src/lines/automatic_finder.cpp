#include "lines/automatic_finder.h"

#include "lines/exhaustive_finder.h"
#include "lines/hierarchy_finder.h"

namespace croquis::lines {
namespace {

// Measured (bench/finders_bench.cpp): below either bound the exhaustive finder is as fast.
constexpr std::size_t fewest_edges = 100'000;
constexpr std::size_t fewest_edges_a_silhouette = 100;
constexpr int views_before_hierarchy = 40;

class AutomaticFinder final : public SilhouetteFinder {
public:
    explicit AutomaticFinder(const Surface& surface)
        : surface_(surface), exhaustive_(make_exhaustive_finder(surface)) {}

    const std::vector<std::uint32_t>& find(const Viewpoint& view) override {
        const bool suits =
            surface_.edge_count() >= fewest_edges && surface_.edge_count() >= fewest_edges_a_silhouette * last_found_;
        if (suits && !hierarchy_ && views_ >= views_before_hierarchy) {
            hierarchy_ = make_hierarchy_finder(surface_);
        }
        if (views_ < views_before_hierarchy) ++views_;
        const std::vector<std::uint32_t>& found =
            suits && hierarchy_ ? hierarchy_->find(view) : exhaustive_->find(view);
        last_found_ = found.size();
        return found;
    }

private:
    const Surface& surface_;
    std::unique_ptr<SilhouetteFinder> exhaustive_, hierarchy_;
    std::size_t last_found_ = 0;
    int views_ = 0;
};

}  // namespace

std::unique_ptr<SilhouetteFinder> make_automatic_finder(const Surface& surface) {
    return std::make_unique<AutomaticFinder>(surface);
}

}  // namespace croquis::lines
