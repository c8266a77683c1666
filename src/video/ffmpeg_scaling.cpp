#include "video/ffmpeg_scaling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace croquis::video {
namespace {

constexpr int bytes_a_pixel = 4;
constexpr std::array<std::uint8_t, bytes_a_pixel> black{0, 0, 0, 255};

// Full resolution of colours at both ends, and no shortcuts in rounding.
constexpr int exact = SWS_ACCURATE_RND | SWS_FULL_CHR_H_INP | SWS_FULL_CHR_H_INT;

std::uint8_t* pixel_of(const AVFrame& picture, int x, int y) {
    return picture.data[0] + std::ptrdiff_t(y) * picture.linesize[0] + std::ptrdiff_t(x) * bytes_a_pixel;
}

void fill_black(const AVFrame& picture) {
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) std::copy(black.begin(), black.end(), pixel_of(picture, x, y));
    }
}

int even(int side) { return side + side % 2; }

}  // namespace

Fitting::Fitting(int width, int height, bool has_even_sides)
    : width_(width),
      height_(height),
      sheet_(
          new_picture(has_even_sides ? even(width) : width, has_even_sides ? even(height) : height, AV_PIX_FMT_RGBA)) {}

const AVFrame& Fitting::fitted(const VideoFrame& frame) {
    if (frame.width == width_ && frame.height == height_)
        lay(frame);
    else
        scale(frame);
    return *sheet_;
}

void Fitting::lay(const VideoFrame& frame) {
    const std::size_t row = std::size_t(width_) * bytes_a_pixel;
    for (int y = 0; y < sheet_->height; ++y) {
        const std::uint8_t* from = frame.pixels.data() + row * std::size_t(std::min(y, height_ - 1));
        std::memcpy(pixel_of(*sheet_, 0, y), from, row);
        if (sheet_->width > width_) {
            std::memcpy(pixel_of(*sheet_, width_, y), from + row - bytes_a_pixel, bytes_a_pixel);
        }
    }
}

void Fitting::scale(const VideoFrame& frame) {
    const double factor = std::min(double(width_) / frame.width, double(height_) / frame.height);
    const int width = std::clamp(int(std::lround(frame.width * factor)), 1, width_);
    const int height = std::clamp(int(std::lround(frame.height * factor)), 1, height_);
    if (!scaler_ || frame.width != scaled_width_ || frame.height != scaled_height_) {
        const int method = factor < 1 ? SWS_AREA : SWS_BICUBIC;
        scaler_ = owned(sws_getContext(frame.width, frame.height, AV_PIX_FMT_RGBA, width, height, AV_PIX_FMT_RGBA,
                                       method | exact, nullptr, nullptr, nullptr));
        scaled_width_ = frame.width;
        scaled_height_ = frame.height;
    }
    fill_black(*sheet_);
    const std::uint8_t* const from[] = {frame.pixels.data()};
    const int from_row[] = {frame.width * bytes_a_pixel};
    std::uint8_t* const to[] = {pixel_of(*sheet_, (width_ - width) / 2, (height_ - height) / 2)};
    checked(sws_scale(scaler_.get(), from, from_row, 0, frame.height, to, sheet_->linesize), "cannot scale a picture");
}

Conversion::Conversion(const AVFrame& from, AVPixelFormat format)
    : format_(format),
      converter_(owned(sws_getContext(from.width, from.height, AV_PIX_FMT_RGBA, from.width, from.height, format,
                                      SWS_BICUBIC | exact, nullptr, nullptr, nullptr))) {
    const int* const bt709 = sws_getCoefficients(SWS_CS_ITU709);
    constexpr int full_range = 1, limited_range = 0, same = 1 << 16;
    sws_setColorspaceDetails(converter_.get(), bt709, full_range, bt709, limited_range, 0, same, same);
}

Owned<AVFrame> Conversion::converted(const AVFrame& from) const {
    auto picture = new_picture(from.width, from.height, format_);
    checked(sws_scale(converter_.get(), from.data, from.linesize, 0, from.height, picture->data, picture->linesize),
            "cannot convert a picture");
    return picture;
}

}  // namespace croquis::video
