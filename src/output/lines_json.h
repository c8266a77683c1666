// Drawings in lines as JSON, for other programs to check and use (docs/lines-format.md).
#pragma once

#include <span>
#include <string>

#include "lines/drawing.h"

namespace croquis::output {

/// What the numbers of a drawing stand for.
struct LineNames {
    std::span<const std::string> meshes;  ///< by the lines' mesh
    std::span<const std::string> views;   ///< of a sheet of several views; empty for one
    std::span<const std::uint32_t> view_of_line;
    double file_units = 1;  ///< of the model's file to a scene unit: for depths
};

[[nodiscard]] std::string lines_json(const lines::Drawing& drawing, const LineNames& names);

}  // namespace croquis::output
