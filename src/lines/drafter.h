// From a surface and a viewpoint to a drawing: find, decide visibility, chain (seed D, sections 3 to 5).
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "lines/drawing.h"
#include "lines/surface.h"
#include "lines/viewpoint.h"

namespace croquis::lines {

/// How it is decided which parts of a line are seen.
enum class Visibility : std::uint8_t {
    automatic,     ///< quantitative invisibility, with ray casts where a model or view is no case for it
    quantitative,  ///< quantitative invisibility after Appel, as seed D refines it; start values by ray casts
    walking,       ///< the same, its start values by walking over the surface; sheets must not pass through each other
    ray_cast,      ///< a ray for each piece of each line
    none,          ///< everything counts as visible
};

/// What to draw.
struct Options {
    LineClasses classes{LineClass::contour, LineClass::silhouette, LineClass::border,      LineClass::tagged,
                        LineClass::crease,  LineClass::material,   LineClass::intersection};
    double crease_angle = 1.0471976;  ///< radians; 60 degrees. 0 is a flat surface, pi a fold
    bool hidden = false;              ///< hidden lines too, each with the number of layers that hide it
    Visibility visibility = Visibility::automatic;
    std::string finder = "automatic";  ///< a name of finder_infos()
    /// Leaves what an illustrator would draw (docs/lines.md): crumbs without a depth step go, interrupted curves close,
    /// zigzags smooth out within half a pixel. Off: exactly the visible edges.
    bool clean = true;
    std::uint64_t seed = 0;

    bool operator==(const Options&) const = default;
};

/// How long the last drawing took, in milliseconds, and what it met.
struct Report {
    double find = 0;
    double visibility = 0;
    double chain = 0;
    std::size_t silhouette_edges = 0;
    std::size_t line_edges = 0;  ///< edges of all classes that were tested for visibility
    std::size_t occluding_edges = 0;
    std::size_t crossings = 0;          ///< of lines with occluding edges, in the picture
    std::size_t clusters = 0;           ///< connected sets of line edges
    std::size_t start_values = 0;       ///< clusters whose start value had to be asked for by ray or walk
    std::size_t doubtful_clusters = 0;  ///< whose values contradicted each other and were decided by ray casts
};

/// Draws one surface, view after view. Keeps what helps from one view to the next. Not to be shared between threads;
/// uses several itself. The result does not depend on how many.
class Drafter {
public:
    Drafter(std::shared_ptr<const Surface> surface, const Options& options);
    Drafter(Drafter&&) noexcept;
    Drafter& operator=(Drafter&&) noexcept;
    ~Drafter();

    /// The lines of a view. Throws Error for a viewpoint without size or direction.
    [[nodiscard]] Drawing draw(const Viewpoint& view);

    [[nodiscard]] const Report& report() const;
    [[nodiscard]] const Surface& surface() const;
    [[nodiscard]] const Options& options() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace croquis::lines
