// Models of any size for measuring, written as OBJ files.
#pragma once

#include <string>

namespace croquis::bench {

/// Writes a bumpy torus of close to `triangles` triangles, smooth normals left to the loader; returns its path in the
/// system's temporary folder.
[[nodiscard]] std::string write_bumpy_torus(int triangles);

}  // namespace croquis::bench
