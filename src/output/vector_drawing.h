// From a drawing in lines to a page: strokes on the sheet, in groups by view, visibility, class and mesh.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "lines/drawing.h"
#include "lines/stroke.h"
#include "output/sheet.h"
#include "output/vector_page.h"

namespace croquis::output {

/// What is put on the sheet, all in pixels of the drawing's frame.
struct DrawnLines {
    const lines::Drawing& drawing;
    const lines::Strokes& strokes;
    std::span<const std::string> meshes;          ///< names, by the lines' mesh
    std::span<const std::string> views;           ///< names of a sheet of several views; empty for one
    std::span<const std::uint32_t> view_of_line;  ///< used where there are views
    enum class Hidden : std::uint8_t {
        as_one,    ///< one group for all hidden lines
        by_layers  ///< a group each for lines behind 1, 2 and more layers
    };
    Hidden hidden = Hidden::as_one;
    enum class Spines : std::uint8_t {
        polylines,  ///< exactly the points of the strokes
        curves      ///< cubics through them where the lines are smooth
    };
    Spines spines = Spines::polylines;
};

/// The groups of one view (`view` 0 where there is one): hidden lines under visible ones, outlines on top. A line is
/// one path. Strokes of one width and colour are plain paths of that width, others are filled outlines; images that run
/// along strokes are left out.
[[nodiscard]] std::vector<VectorGroup> groups_of(const DrawnLines& drawn, std::uint32_t view, const Sheet& sheet,
                                                 NameGiver& names);

/// The same lines for a plotter: a layer for each width of pen, the widest first, each planned by `plan_pen`.
[[nodiscard]] std::vector<VectorGroup> pens_of(const DrawnLines& drawn, const Sheet& sheet, NameGiver& names);

}  // namespace croquis::output
