// A video file by FFmpeg's libraries: pictures through a codec into a container.
extern "C" {
#include <libavutil/opt.h>
}

#include <optional>

#include "video/encoder.h"
#include "video/ffmpeg_palette.h"
#include "video/ffmpeg_scaling.h"
#include "video/video_formats.h"

namespace croquis::video {
namespace {

class FileEncoder final : public Encoder {
public:
    FileEncoder(const EncoderTarget& target, const VideoOptions& options);
    ~FileEncoder() override;

    void add(const VideoFrame& frame) override;
    void repeat(long long times) override;
    void finish() override;

private:
    void open_codec(const VideoOptions& options);
    void open_file(const std::string& path);
    void encode(AVFrame* picture);
    void write_packet();

    const VideoFormat& format_;
    std::string name_;
    Fitting fitting_;
    std::optional<Conversion> conversion_;  // none to a palette
    Owned<AVFormatContext> file_;
    Owned<AVCodecContext> codec_;
    Owned<AVPacket> received_;
    Owned<AVPacket> packet_;  // the last one
    Owned<AVFrame> picture_;  // the last one, as the codec takes it
    AVStream* stream_ = nullptr;
    long long frames_ = 0;
    bool is_begun_ = false;  // the file, and not ended
};

// A name with a colon would be taken for a protocol.
std::string url_of(const std::string& file) { return "file:" + file; }

Owned<AVFormatContext> new_file(const EncoderTarget& target, const char* container) {
    AVFormatContext* file = nullptr;
    checked(avformat_alloc_output_context2(&file, nullptr, container, url_of(target.file).c_str()),
            fmt::format("{}: cannot write {}", target.name, container));
    return owned(file);
}

const AVCodec* codec_of(const VideoFormat& format, const std::string& name) {
    const AVCodec* const codec = avcodec_find_encoder_by_name(format.codec);
    if (codec == nullptr) fail("{}: expected an FFmpeg with the encoder {}, found one without", name, format.codec);
    return codec;
}

FileEncoder::FileEncoder(const EncoderTarget& target, const VideoOptions& options)
    : format_(video_format(target.ending)),
      name_(target.name),
      fitting_(options.width, options.height, format_.has_even_sides),
      file_(new_file(target, format_.container)),
      codec_(owned(avcodec_alloc_context3(codec_of(format_, name_)))),
      received_(owned(av_packet_alloc())),
      packet_(owned(av_packet_alloc())) {
    if (!format_.has_palette()) conversion_.emplace(fitting_.sheet(), format_.pixels);
    open_codec(options);
    open_file(target.file);
}

// One thread: the drawing that is recorded wants the others.
void FileEncoder::open_codec(const VideoOptions& options) {
    codec_->width = fitting_.sheet().width;
    codec_->height = fitting_.sheet().height;
    codec_->pix_fmt = format_.pixels;
    codec_->time_base = {1, options.frame_rate};
    codec_->framerate = {options.frame_rate, 1};
    codec_->thread_count = 1;
    if (format_.is_yuv()) {
        codec_->color_range = AVCOL_RANGE_MPEG;
        codec_->colorspace = AVCOL_SPC_BT709;
        codec_->color_primaries = AVCOL_PRI_BT709;
        codec_->color_trc = AVCOL_TRC_IEC61966_2_1;
        codec_->chroma_sample_location = AVCHROMA_LOC_LEFT;
    }
    if ((file_->oformat->flags & AVFMT_GLOBALHEADER) != 0) codec_->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    for (const auto& [option, value] : format_.codec_options) {
        if (option == nullptr) break;
        checked(av_opt_set(codec_.get(), option, value, AV_OPT_SEARCH_CHILDREN),
                fmt::format("{}: {} does not take {} {}", name_, format_.codec, option, value));
    }
    checked(avcodec_open2(codec_.get(), nullptr, nullptr),
            fmt::format("{}: {} cannot encode {}x{} pixels", name_, format_.codec, codec_->width, codec_->height));
}

void FileEncoder::open_file(const std::string& path) {
    stream_ = avformat_new_stream(file_.get(), nullptr);
    if (stream_ == nullptr) throw std::bad_alloc();
    stream_->time_base = codec_->time_base;
    stream_->avg_frame_rate = codec_->framerate;
    checked(avcodec_parameters_from_context(stream_->codecpar, codec_.get()), name_);
    if (const auto& [option, value] = format_.container_option; option != nullptr) {
        checked(av_opt_set(file_->priv_data, option, value, 0), name_);
    }
    checked(avio_open(&file_->pb, url_of(path).c_str(), AVIO_FLAG_WRITE), name_);
    checked(avformat_write_header(file_.get(), nullptr), name_);
    is_begun_ = true;
}

// A container lets go of some of what it holds only at its end, as the GIF does.
FileEncoder::~FileEncoder() {
    if (is_begun_) av_write_trailer(file_.get());
}

void FileEncoder::add(const VideoFrame& frame) {
    const AVFrame& sheet = fitting_.fitted(frame);
    picture_ = conversion_ ? conversion_->converted(sheet) : with_palette(sheet);
    av_packet_unref(packet_.get());
    repeat(1);
}

void FileEncoder::repeat(long long times) {
    for (; times > 0; --times) {
        if (format_.has_whole_frames() && packet_->data != nullptr) {
            packet_->pts = packet_->dts = frames_++;
            write_packet();
        } else {
            picture_->pts = frames_++;
            encode(picture_.get());
        }
    }
}

void FileEncoder::finish() {
    encode(nullptr);
    is_begun_ = false;
    checked(av_write_trailer(file_.get()), name_);
    checked(avio_closep(&file_->pb), name_);
}

// No picture: there are no more.
void FileEncoder::encode(AVFrame* picture) {
    checked(avcodec_send_frame(codec_.get(), picture), name_);
    for (;;) {
        const int code = avcodec_receive_packet(codec_.get(), received_.get());
        if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) return;
        checked(code, name_);
        std::swap(packet_, received_);
        write_packet();
    }
}

// The container takes a copy's reference: the packet stays, in frames.
void FileEncoder::write_packet() {
    const auto written = owned(av_packet_clone(packet_.get()));
    written->duration = 1;
    av_packet_rescale_ts(written.get(), codec_->time_base, stream_->time_base);
    written->stream_index = stream_->index;
    checked(av_interleaved_write_frame(file_.get(), written.get()), name_);
}

}  // namespace
}  // namespace croquis::video

// Loaded by encoder_library.cpp. What goes wrong is told by errors, not by FFmpeg on standard error.
extern "C" __attribute__((visibility("default"))) void croquis_make_encoder(
    const croquis::video::EncoderTarget& target, const croquis::video::VideoOptions& options,
    std::unique_ptr<croquis::video::Encoder>& encoder) {
    av_log_set_level(AV_LOG_QUIET);
    encoder = std::make_unique<croquis::video::FileEncoder>(target, options);
}
