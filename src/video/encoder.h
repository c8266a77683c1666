// What makes a video file out of pictures, without a word of the library that does it.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace croquis::video {

struct VideoOptions {
    int width = 0;
    int height = 0;
    int frame_rate = 30;  ///< frames a second, 1 to 240; a GIF has at most 50
};

/// A picture: RGBA, 4 bytes a pixel, rows from top to bottom. Its alpha is passed over.
struct VideoFrame {
    int width = 0;
    int height = 0;
    std::span<const std::uint8_t> pixels;
};

class Encoder {
public:
    Encoder() = default;
    virtual ~Encoder() = default;
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;

    virtual void add(const VideoFrame& frame) = 0;
    virtual void repeat(long long times) = 0;
    virtual void finish() = 0;
};

/// Where an encoder writes, as what, and how the file is called in errors.
struct EncoderTarget {
    std::string file;
    std::string ending;  ///< one of `video_endings`
    std::string name;
};

/// Makes an encoder: the one function that the library with FFmpeg offers. Throws Error.
using MakeEncoder = void(const EncoderTarget& target, const VideoOptions& options, std::unique_ptr<Encoder>& encoder);

/// That function, from the library, which is loaded when this is called first. Throws Error where it is not there.
[[nodiscard]] MakeEncoder& encoder_maker();

}  // namespace croquis::video
