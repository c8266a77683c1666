// MD2, the key-framed models of Quake II.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "model/load.h"

namespace croquis::model {

/// Parses an MD2 file in memory. Its skins are not looked for: the one material's texture_name holds the first skin's
/// name. Throws Error, naming `name`.
///
/// Frames are grouped into clips by their names without the digits at the end (`run01` … `run06` are "run"), at 10
/// frames a second; a clip ends by blending back to its first frame. The z axis, up in the file, becomes y.
[[nodiscard]] RawModel read_md2(std::span<const std::byte> bytes, const std::string& name,
                                const Progress& progress = {});

}  // namespace croquis::model
