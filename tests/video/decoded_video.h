// A video as its viewer gets it: every frame with its time, colours by the equations of ITU-R BT.709 in double
// precision.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace croquis::test_support {

struct DecodedFrame {
    double seconds = 0;                // when it appears
    std::vector<std::uint8_t> pixels;  // RGBA, rows from top to bottom

    bool operator==(const DecodedFrame&) const = default;
};

struct DecodedVideo {
    int width = 0;
    int height = 0;
    double frame_rate = 0;
    double seconds = 0;  // as the container says
    std::string codec;
    bool is_bt709_limited = false;  // what the stream says of its colours
    std::vector<DecodedFrame> frames;

    [[nodiscard]] std::array<int, 3> color(std::size_t frame, int x, int y) const;
};

/// Throws std::runtime_error for what is no video.
[[nodiscard]] DecodedVideo decode_video(const std::filesystem::path& path);

}  // namespace croquis::test_support
