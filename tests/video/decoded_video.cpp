#include "video/decoded_video.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
}

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace croquis::test_support {
namespace {

struct Release {
    void operator()(AVFormatContext* file) const { avformat_close_input(&file); }
    void operator()(AVCodecContext* codec) const { avcodec_free_context(&codec); }
    void operator()(AVFrame* frame) const { av_frame_free(&frame); }
    void operator()(AVPacket* packet) const { av_packet_free(&packet); }
};
template <typename T>
using Owned = std::unique_ptr<T, Release>;

void require(bool is_well, const std::string& what) {
    if (!is_well) throw std::runtime_error(what);
}

// Rec. ITU-R BT.709-6, 3.2 to 3.5: Y' = 0.2126 R' + 0.7152 G' + 0.0722 B', and Y', Cb, Cr in 219 and 224 levels.
std::array<double, 3> rgb_of(double luma, double blue, double red) {
    const double y = (luma - 16) / 219, cb = (blue - 128) / 224, cr = (red - 128) / 224;
    const double r = y + 1.5748 * cr, b = y + 1.8556 * cb;
    return {255 * r, 255 * (y - 0.2126 * r - 0.0722 * b) / 0.7152, 255 * b};
}

std::array<double, 3> color_at(const AVFrame& frame, int x, int y) {
    const auto byte = [&](int plane, int column, int row) {
        return double(frame.data[plane][std::ptrdiff_t(row) * frame.linesize[plane] + column]);
    };
    switch (frame.format) {
        case AV_PIX_FMT_YUV420P:
            return rgb_of(byte(0, x, y), byte(1, x / 2, y / 2), byte(2, x / 2, y / 2));
        case AV_PIX_FMT_BGR0:
        case AV_PIX_FMT_BGRA:
            return {byte(0, 4 * x + 2, y), byte(0, 4 * x + 1, y), byte(0, 4 * x, y)};
        default:
            throw std::runtime_error("a pixel format that is not expected");
    }
}

std::vector<std::uint8_t> pixels_of(const AVFrame& frame) {
    std::vector<std::uint8_t> pixels;
    for (int y = 0; y < frame.height; ++y) {
        for (int x = 0; x < frame.width; ++x) {
            for (const double value : color_at(frame, x, y)) {
                pixels.push_back(std::uint8_t(std::clamp(std::lround(value), 0L, 255L)));
            }
            pixels.push_back(255);
        }
    }
    return pixels;
}

class Decoder {
public:
    explicit Decoder(const std::filesystem::path& path) {
        AVFormatContext* opened = nullptr;
        require(avformat_open_input(&opened, path.c_str(), nullptr, nullptr) == 0, path.string() + " cannot be opened");
        file_.reset(opened);
        require(avformat_find_stream_info(opened, nullptr) >= 0 && opened->nb_streams == 1, "expected one stream");
        stream_ = opened->streams[0];
        codec_.reset(avcodec_alloc_context3(avcodec_find_decoder(stream_->codecpar->codec_id)));
        avcodec_parameters_to_context(codec_.get(), stream_->codecpar);
        require(avcodec_open2(codec_.get(), nullptr, nullptr) == 0, "no decoder");
        video_.width = codec_->width;
        video_.height = codec_->height;
        video_.frame_rate = av_q2d(stream_->avg_frame_rate);
        video_.seconds = double(opened->duration) / AV_TIME_BASE;
        video_.codec = avcodec_get_name(codec_->codec_id);
    }

    DecodedVideo decode() {
        const Owned<AVPacket> packet(av_packet_alloc());
        while (av_read_frame(file_.get(), packet.get()) == 0) {
            require(avcodec_send_packet(codec_.get(), packet.get()) == 0, "a packet that cannot be decoded");
            av_packet_unref(packet.get());
            take_frames();
        }
        avcodec_send_packet(codec_.get(), nullptr);
        take_frames();
        return std::move(video_);
    }

private:
    void take_frames() {
        while (avcodec_receive_frame(codec_.get(), frame_.get()) == 0) {
            video_.is_bt709_limited = frame_->colorspace == AVCOL_SPC_BT709 && frame_->color_range == AVCOL_RANGE_MPEG;
            video_.frames.push_back(
                {double(frame_->best_effort_timestamp) * av_q2d(stream_->time_base), pixels_of(*frame_)});
        }
    }

    Owned<AVFormatContext> file_;
    Owned<AVCodecContext> codec_;
    Owned<AVFrame> frame_{av_frame_alloc()};
    AVStream* stream_ = nullptr;
    DecodedVideo video_;
};

}  // namespace

std::array<int, 3> DecodedVideo::color(std::size_t frame, int x, int y) const {
    const std::uint8_t* pixel =
        frames.at(frame).pixels.data() + (std::size_t(y) * std::size_t(width) + std::size_t(x)) * 4;
    return {pixel[0], pixel[1], pixel[2]};
}

DecodedVideo decode_video(const std::filesystem::path& path) {
    av_log_set_level(AV_LOG_ERROR);
    return Decoder(path).decode();
}

}  // namespace croquis::test_support
