// The table of silhouette finders.
#include "lines/exhaustive_finder.h"
#include "lines/silhouette_finder.h"

namespace croquis::lines {

std::unique_ptr<SilhouetteFinder> make_finder(std::string_view /*name*/, const Surface& surface,
                                              std::uint64_t /*seed*/) {
    return make_exhaustive_finder(surface);
}

}  // namespace croquis::lines
