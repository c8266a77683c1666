// FFmpeg's objects as values that release what they hold, and its error codes as errors.
#pragma once

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavfilter/avfilter.h>
#include <libavformat/avformat.h>
#include <libavutil/frame.h>
#include <libswscale/swscale.h>
}

#include <memory>
#include <new>
#include <string_view>

#include "base/error.h"

namespace croquis::video {

struct Release {
    void operator()(AVFormatContext* file) const;  // closes what it writes to
    void operator()(AVCodecContext* codec) const { avcodec_free_context(&codec); }
    void operator()(AVFilterGraph* graph) const { avfilter_graph_free(&graph); }
    void operator()(AVFrame* frame) const { av_frame_free(&frame); }
    void operator()(AVPacket* packet) const { av_packet_free(&packet); }
    void operator()(SwsContext* scaler) const { sws_freeContext(scaler); }
};

/// An object of FFmpeg's that is released with its owner.
template <typename T>
using Owned = std::unique_ptr<T, Release>;

/// What FFmpeg made. Throws where it is nothing: for want of memory.
template <typename T>
[[nodiscard]] Owned<T> owned(T* made) {
    if (made == nullptr) throw std::bad_alloc();
    return Owned<T>(made);
}

/// A code that says no error. Throws Error "what: why" for one that does.
int checked(int code, std::string_view what);

/// A picture to write to, of that size and format (AVPixelFormat).
[[nodiscard]] Owned<AVFrame> new_picture(int width, int height, AVPixelFormat format);

}  // namespace croquis::video
