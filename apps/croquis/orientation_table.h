// How ways of telling which faces look at the eye compare on a model: seed A, tables 6 to 9.
#pragma once

#include "croquis/croquis.h"

namespace croquis::app {

/// Prints one line a way: faces found, their share, holes and time, as means over the views.
void print_orientation_table(const Model& model, const FaceOrientationOptions& options);

}  // namespace croquis::app
