// Silhouettes by chance and by memory: most of their length, from a small part of the edges (seed D, "Fast silhouette
// detection"; SPEC row L3).
#pragma once

#include <memory>

#include "lines/silhouette_finder.h"

namespace croquis::lines {

/// Looks at some edges only, drawn by chance, sharp ones more often, and at the silhouettes of the last view; where one
/// is a silhouette, follows its whole curve over the surface. Long curves are found almost surely, short ones perhaps.
/// The result depends on the seed and on the views since `reset`, and on nothing else. Edges looked at: in proportion
/// to the root of how many there are, and to those found.
[[nodiscard]] std::unique_ptr<SilhouetteFinder> make_randomised_finder(const Surface& surface, std::uint64_t seed);

}  // namespace croquis::lines
