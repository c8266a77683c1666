// PNG files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

namespace croquis::output {

/// Writes 8-bit RGBA pixels, rows from top to bottom, as a PNG, whole or not at all; "-" is standard output. Alpha is
/// left out where all pixels are opaque. Throws Error.
void write_png(const std::filesystem::path& path, int width, int height, std::span<const std::uint8_t> pixels);

}  // namespace croquis::output
