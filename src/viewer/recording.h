// One video of what the viewer shows, while it is being made.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "croquis/picture.h"
#include "video/encoder.h"

namespace croquis::viewer {

/// Takes pictures at the times at which they are first seen, and writes them at a constant rate, each repeated for as
/// long as it stood. A thread of its own encodes: whoever adds pictures never waits. Where it falls behind, pictures
/// are left out, the last one never, and those before them stand longer.
class Recording {
public:
    using Time = std::chrono::steady_clock::time_point;
    static constexpr int frame_rate = 30;

    /// Of pictures that wait for the encoder; two may wait in any case.
    static constexpr std::size_t most_bytes_waiting = std::size_t{96} << 20;

    /// Begins a video with a picture, which gives it its size. Its ending is one of video_endings.
    Recording(std::string path, Picture first, Time now, std::size_t most_bytes = most_bytes_waiting);
    /// Ends the video where nobody did, and waits until it is written.
    ~Recording();
    Recording(const Recording&) = delete;
    Recording& operator=(const Recording&) = delete;

    void add(Picture picture, Time now);
    /// What is seen last stands until now. Does not wait.
    void end(Time now);
    /// Until the file is there; `end` must have been called.
    void wait();

    [[nodiscard]] const std::string& path() const { return path_; }
    [[nodiscard]] double seconds(Time now) const { return std::chrono::duration<double>(now - begun_).count(); }

    /// The file is there, or `error` says why not.
    [[nodiscard]] bool is_over() const;
    [[nodiscard]] std::string error() const;

private:
    /// A picture from the frame on from which it is to be written. Without picture the last one stands on.
    struct Shown {
        std::unique_ptr<const Picture> picture;
        long long first_frame;
    };
    struct Standing {
        std::unique_ptr<const Picture> picture;
        long long frames;
    };
    [[nodiscard]] long long frame_at(Time time) const;
    [[nodiscard]] bool has_room(std::size_t bytes) const;
    void write();
    void write_pictures();
    /// The oldest picture and for how many frames it stands, or has stood by now; nothing once all are written.
    [[nodiscard]] std::optional<Standing> take();

    const std::string path_;
    const Time begun_;
    const std::size_t most_bytes_;
    const video::VideoOptions options_;
    mutable std::mutex mutex_;
    std::condition_variable has_news_;
    std::deque<Shown> waiting_;  // the newest stays: another may take its place before it is seen
    long long last_frame_ = -1;  // the end, once it is known
    bool is_over_ = false;
    std::string error_;
    std::thread thread_;  // begins when all else is there
};

}  // namespace croquis::viewer
