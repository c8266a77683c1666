#include "video/video_writer.h"

#include <algorithm>
#include <cassert>
#include <cctype>

#include "base/error.h"

namespace croquis::video {
namespace {

constexpr int longest_side = 16384;
constexpr int most_frames_a_second = 240;
// A GIF counts hundredths of a second, and viewers take a single one for ten.
constexpr int most_frames_a_second_of_gif = 50;

std::string ending_of(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    if (std::find(video_endings.begin(), video_endings.end(), ending) == video_endings.end()) {
        fail("{}: expected a video ending in {}, found \"{}\"", path.string(), fmt::join(video_endings, ", "), ending);
    }
    return ending;
}

void check(const std::filesystem::path& path, const std::string& ending, const VideoOptions& options) {
    const auto is_side = [](int side) { return side >= 1 && side <= longest_side; };
    if (!is_side(options.width) || !is_side(options.height)) {
        fail("{}: expected a video of 1 to {} pixels a side, found {}x{}", path.string(), longest_side, options.width,
             options.height);
    }
    const int most = ending == ".gif" ? most_frames_a_second_of_gif : most_frames_a_second;
    if (options.frame_rate < 1 || options.frame_rate > most) {
        fail("{}: expected 1 to {} frames a second, found {}", path.string(), most, options.frame_rate);
    }
}

}  // namespace

VideoWriter::VideoWriter(const std::filesystem::path& path, const VideoOptions& options) : path_(path) {
    const std::string ending = ending_of(path);
    check(path, ending, options);
    check_writable(path);
    file_.emplace(path);
    encoder_maker()({.file = file_->written().string(), .ending = ending, .name = path.string()}, options, encoder_);
}

void VideoWriter::add(const VideoFrame& frame) {
    assert(frame.width >= 1 && frame.height >= 1);
    assert(frame.pixels.size() == std::size_t(frame.width) * std::size_t(frame.height) * 4);
    encoder_->add(frame);
    has_frames_ = true;
}

void VideoWriter::repeat(long long times) {
    assert(has_frames_);
    encoder_->repeat(times);
}

void VideoWriter::finish() {
    if (!has_frames_) fail("{}: expected at least one frame, found none", path_.string());
    encoder_->finish();
    encoder_.reset();
    file_->keep();
}

}  // namespace croquis::video
