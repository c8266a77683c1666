// Whether a mesh's texture coordinates can carry strokes, and how large the image lies on the surface.
#pragma once

#include "model/model.h"

namespace croquis::model {

/// How many images lie along a unit of the mesh at rest, as the root of the ratio of areas. Zero where texture
/// coordinates would draw strokes out or squeeze them: where there are none, or where a tenth of the surface or more is
/// stretched to more than three times its width, or in another scale than the rest by more than three.
[[nodiscard]] double texcoord_scale(const Mesh& mesh);

}  // namespace croquis::model
