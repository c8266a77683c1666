// Writing videos: pictures go in, a file comes out, whole or not at all.
//
//     VideoWriter video("turn.mp4", {.width = 620, .height = 500, .frame_rate = 30});
//     for (const Picture& picture : pictures) video.add({picture.width(), picture.height(), picture.pixels()});
//     video.finish();
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>

#include "base/files.h"
#include "video/encoder.h"

namespace croquis::video {

/// What a file's ending may be, and so what is in it:
///   .mp4   H.264, what every player shows; sides are made even by repeating the last row or column
///   .webm  VP9, what every browser shows
///   .mkv   FFV1, without any loss
///   .gif   256 colours, chosen for each picture; each frame stands a whole number of hundredths of a second
/// Colours of .mp4 and .webm are stored as ITU-R BT.709 has it, limited range, and say so in the stream.
constexpr std::array<const char*, 4> video_endings{".mp4", ".webm", ".mkv", ".gif"};

class VideoWriter {
public:
    /// Throws Error for another ending, a size or rate that cannot be, or where no file can be written.
    VideoWriter(const std::filesystem::path& path, const VideoOptions& options);

    /// The next frame. One of another size than the video is scaled to fit into its middle, on black. Throws Error.
    void add(const VideoFrame& frame);

    /// The last frame stands so many frames longer: cheaper than to add it again. Throws Error.
    void repeat(long long times);

    /// Ends the video: the file is there now. A writer that is destroyed before leaves none. Throws Error, also where
    /// no frame was added.
    void finish();

private:
    std::optional<PartialFile> file_;
    std::unique_ptr<Encoder> encoder_;  // ends before its file goes
    std::filesystem::path path_;
    bool has_frames_ = false;
};

}  // namespace croquis::video
