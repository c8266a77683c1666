// Finding the edges between faces that are turned to the eye and faces that are turned away: one interface, several
// algorithms, chosen by name (SPEC rows L2 to L5).
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lines/surface.h"
#include "lines/viewpoint.h"

namespace croquis::lines {

/// Finds silhouettes of one surface, view after view. Not to be shared between threads; uses several itself.
class SilhouetteFinder {
public:
    virtual ~SilhouetteFinder() = default;
    SilhouetteFinder(const SilhouetteFinder&) = delete;
    SilhouetteFinder& operator=(const SilhouetteFinder&) = delete;

    /// The regular edges (Surface::pairs) of which one face is front facing and the other is not, in ascending order.
    /// The result stands until the next call.
    [[nodiscard]] virtual const std::vector<std::uint32_t>& find(const Viewpoint& view) = 0;

    /// Forgets what earlier views left behind.
    virtual void reset() {}

protected:
    SilhouetteFinder() = default;
};

/// What a finder is, for lists and for choosing.
struct FinderInfo {
    std::string_view name;
    bool exact = true;        ///< finds every silhouette, in every view it serves
    bool perspective = true;  ///< serves perspective; else parallel projections only
    std::string_view help;
};

/// All finders: "exhaustive", "randomised", "gauss_map", "gauss_map_overlapping", "hierarchy".
[[nodiscard]] const std::vector<FinderInfo>& finder_infos();

/// Makes a finder by name; "automatic" takes the fastest exact one for the surface's size, and for how many views it
/// has found before. The surface must live as long. `seed` is for the randomised one. Throws Error with the nearest
/// name.
[[nodiscard]] std::unique_ptr<SilhouetteFinder> make_finder(std::string_view name, const Surface& surface,
                                                            std::uint64_t seed = 0);

}  // namespace croquis::lines
