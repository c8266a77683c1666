// The table of silhouette finders.
#include "base/error.h"
#include "base/names.h"
#include "lines/automatic_finder.h"
#include "lines/exhaustive_finder.h"
#include "lines/gauss_map_finder.h"
#include "lines/hierarchy_finder.h"
#include "lines/randomised_finder.h"
#include "lines/silhouette_finder.h"

namespace croquis::lines {

const std::vector<FinderInfo>& finder_infos() {
    static const std::vector<FinderInfo> infos{
        {"exhaustive", true, true, "tests every edge; needs no preparation"},
        {"hierarchy", true, true, "a tree over the faces' planes; for many views of large smooth models"},
        {"gauss_map", true, false, "a tree over the faces' directions, in bins that do not overlap"},
        {"gauss_map_overlapping", true, false, "the same, in bins that overlap"},
        {"randomised", false, true, "tries some edges and follows what it finds; misses short curves"},
    };
    return infos;
}

std::unique_ptr<SilhouetteFinder> make_finder(std::string_view name, const Surface& surface, std::uint64_t seed) {
    if (name == "automatic") return make_automatic_finder(surface);
    if (name == "exhaustive") return make_exhaustive_finder(surface);
    if (name == "hierarchy") return make_hierarchy_finder(surface);
    if (name == "gauss_map") return make_gauss_map_finder(surface, GaussBins::separate);
    if (name == "gauss_map_overlapping") return make_gauss_map_finder(surface, GaussBins::overlapping);
    if (name == "randomised") return make_randomised_finder(surface, seed);
    std::vector<std::string> names{"automatic"};
    for (const FinderInfo& info : finder_infos()) names.emplace_back(info.name);
    fail("expected a finder of silhouettes, found \"{}\"{}", name, suggestion(std::string(name), names));
}

}  // namespace croquis::lines
