#include "video/ffmpeg.h"

#include <array>

namespace croquis::video {

void Release::operator()(AVFormatContext* file) const {
    avio_closep(&file->pb);
    avformat_free_context(file);
}

int checked(int code, std::string_view what) {
    if (code >= 0) return code;
    std::array<char, AV_ERROR_MAX_STRING_SIZE> reason{};
    av_strerror(code, reason.data(), reason.size());
    fail("{}: {}", what, reason.data());
}

Owned<AVFrame> new_picture(int width, int height, AVPixelFormat format) {
    auto picture = owned(av_frame_alloc());
    picture->width = width;
    picture->height = height;
    picture->format = format;
    checked(av_frame_get_buffer(picture.get(), 0), "no memory for a picture");
    return picture;
}

}  // namespace croquis::video
