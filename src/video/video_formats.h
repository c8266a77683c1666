// What each ending of a video file stands for.
#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "video/ffmpeg.h"

namespace croquis::video {

struct VideoFormat {
    const char* ending;
    const char* container;  // as FFmpeg names it
    const char* codec;
    AVPixelFormat pixels;
    bool has_even_sides;
    std::array<std::pair<const char*, const char*>, 7> codec_options;  // a name that is null ends them
    std::pair<const char*, const char*> container_option;

    /// Stored as brightness and two colour differences, not as red, green and blue.
    [[nodiscard]] bool is_yuv() const { return pixels == AV_PIX_FMT_YUV420P; }
    /// The same picture gives the same bytes wherever it stands: they are written again, and not made again.
    [[nodiscard]] bool has_whole_frames() const { return pixels == AV_PIX_FMT_0RGB32; }
    [[nodiscard]] bool has_palette() const { return pixels == AV_PIX_FMT_PAL8; }
};

/// `ending` must be one of video_endings.
[[nodiscard]] const VideoFormat& video_format(std::string_view ending);

}  // namespace croquis::video
