// The table of silhouette finders.
#include "lines/exhaustive_finder.h"
#include "lines/hierarchy_finder.h"
#include "lines/randomised_finder.h"
#include "lines/silhouette_finder.h"

namespace croquis::lines {

std::unique_ptr<SilhouetteFinder> make_finder(std::string_view name, const Surface& surface, std::uint64_t seed) {
    if (name == "hierarchy") return make_hierarchy_finder(surface);
    if (name == "randomised") return make_randomised_finder(surface, seed);
    return make_exhaustive_finder(surface);
}

}  // namespace croquis::lines
