// The materials of an OBJ file (Wavefront MTL).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/textures.h"

namespace croquis::model {

/// Reads a material file and appends its materials; a name that stands already keeps its first meaning. Lines that
/// make no sense are skipped with a warning: a damaged material is no reason to refuse a surface.
///
/// Ka, Kd, Ks, Ns, d, Tr, map_Kd (and map_Ka for want of it) are used.
void read_mtl(const std::filesystem::path& path, TextureFinder& textures, std::vector<Material>& materials);

}  // namespace croquis::model
