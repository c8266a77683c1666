// What stands behind a LineDrawing.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "api/lines_views.h"
#include "croquis/lines.h"
#include "lines/drawing.h"
#include "lines/surface.h"

namespace croquis {

struct FoundLines {
    lines::Drawing drawing;  ///< of all views, in the pixels of the whole frame
    std::vector<std::uint32_t> view_of_line;
    std::vector<PlacedView> views;
    std::shared_ptr<const lines::Surface> surface;
    std::vector<std::string> mesh_names;
    double file_units = 1;  ///< to a scene unit
    std::uint64_t seed = 0;
    bool is_clean = true;  ///< as an illustrator would draw it; else exactly the visible edges
    LineReport report;

    /// The names of the views of a sheet; empty for one view.
    [[nodiscard]] std::vector<std::string> view_names() const {
        std::vector<std::string> names;
        for (const PlacedView& view : views) {
            if (!view.name.empty()) names.push_back(view.name);
        }
        return names;
    }
};

struct LineDrawing::State : FoundLines {};

}  // namespace croquis
