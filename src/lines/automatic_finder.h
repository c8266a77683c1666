// The fastest exact finder, chosen by what earlier views cost (SPEC row L5).
#pragma once

#include <memory>

#include "lines/silhouette_finder.h"

namespace croquis::lines {

/// Exhaustive at first. To build the hierarchy takes as long as some forty exhaustive views; so it is built when as
/// many have been asked for, and only for a large surface of which a view's silhouettes are a small part: elsewhere it
/// finds no faster.
[[nodiscard]] std::unique_ptr<SilhouetteFinder> make_automatic_finder(const Surface& surface);

}  // namespace croquis::lines
