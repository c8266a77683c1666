#include "video/video_formats.h"

#include <algorithm>
#include <cassert>

#include "video/video_writer.h"

namespace croquis::video {
namespace {

// H.264 and VP9 at a quality where flat colours and thin lines show no loss, as fast as they go: the drawing wants the
// processor. A constant quantiser spares H.264 looking ahead, half of what a frame that stands costs. FFV1's frames are
// all whole, which players need to jump.
constexpr std::array<VideoFormat, video_endings.size()> formats{{
    {".mp4",
     "mp4",
     "libx264",
     AV_PIX_FMT_YUV420P,
     true,
     {{{"preset", "ultrafast"}, {"qp", "18"}}},
     {"movflags", "+faststart"}},
    {".webm",
     "webm",
     "libvpx-vp9",
     AV_PIX_FMT_YUV420P,
     false,
     {{{"deadline", "realtime"},
       {"cpu-used", "8"},
       {"static-thresh", "1000"},
       {"lag-in-frames", "0"},
       {"aq-mode", "0"},
       {"crf", "16"},
       {"b", "0"}}},
     {}},
    {".mkv", "matroska", "ffv1", AV_PIX_FMT_0RGB32, false, {{{"level", "3"}, {"g", "1"}, {"slicecrc", "1"}}}, {}},
    {".gif", "gif", "gif", AV_PIX_FMT_PAL8, false, {}, {}},
}};

}  // namespace

const VideoFormat& video_format(std::string_view ending) {
    const auto found = std::find_if(formats.begin(), formats.end(),
                                    [&](const VideoFormat& format) { return format.ending == ending; });
    assert(found != formats.end());
    return *found;
}

}  // namespace croquis::video
