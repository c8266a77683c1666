// What the variables of a `lines` pass ask for, in the terms of src/lines.
#pragma once

#include "framework/pass.h"
#include "lines/drafter.h"
#include "lines/strokes.h"

namespace croquis::components {

struct LineSettings {
    lines::Options find;
    lines::StrokeOptions strokes;  ///< but for light and seed, which a frame has

    /// Reads the pass's variables, and the files of the stroke style that they name. Throws Error for a class, finder
    /// or style that does not exist.
    [[nodiscard]] static LineSettings of(const framework::Pass& pass);
};

}  // namespace croquis::components
