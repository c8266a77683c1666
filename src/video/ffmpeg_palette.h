// Pictures in 256 colours, for GIF.
#pragma once

#include "video/ffmpeg.h"

namespace croquis::video {

/// The picture (RGBA) in the 256 colours that serve it best: FFmpeg's filters palettegen (median cut) and paletteuse,
/// with an ordered dither that stays where it is from frame to frame. Throws Error.
[[nodiscard]] Owned<AVFrame> with_palette(const AVFrame& picture);

}  // namespace croquis::video
