// Every edge, every view: the definition itself, in two passes over plain arrays (seed E, 10.3.2).
#pragma once

#include <memory>

#include "lines/silhouette_finder.h"

namespace croquis::lines {

[[nodiscard]] std::unique_ptr<SilhouetteFinder> make_exhaustive_finder(const Surface& surface);

}  // namespace croquis::lines
