// Pictures as a video's frames: fitted into its size, and in the pixel format that its codec takes.
#pragma once

#include <optional>

#include "video/encoder.h"
#include "video/ffmpeg.h"

namespace croquis::video {

/// Puts pictures on a sheet of RGBA. One of the video's size lies on it as it is; where the sheet is larger, for codecs
/// that want even sides, its last row and column are repeated. Any other is scaled to fit into the middle, on black.
class Fitting {
public:
    Fitting(int width, int height, bool has_even_sides);

    /// Valid until the next call.
    [[nodiscard]] const AVFrame& fitted(const VideoFrame& frame);
    [[nodiscard]] const AVFrame& sheet() const { return *sheet_; }

private:
    void lay(const VideoFrame& frame);
    void scale(const VideoFrame& frame);

    int width_, height_;
    Owned<AVFrame> sheet_;
    Owned<SwsContext> scaler_;  // for the size of the last frame that was scaled
    int scaled_width_ = 0, scaled_height_ = 0;
};

/// RGBA to a codec's pixel format. YUV is that of ITU-R BT.709 in limited range.
class Conversion {
public:
    Conversion(const AVFrame& from, AVPixelFormat format);
    /// A picture of its own: a codec may hold it for a while.
    [[nodiscard]] Owned<AVFrame> converted(const AVFrame& from) const;

private:
    AVPixelFormat format_;
    Owned<SwsContext> converter_;
};

}  // namespace croquis::video
