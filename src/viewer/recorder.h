// Recording what the viewer shows: begins and ends videos, and says so in the window.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/recording.h"

namespace croquis::viewer {

class Recorder {
public:
    Recorder() = default;
    ~Recorder();
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    /// Begins a video with the picture that is seen. None must be recorded.
    void start(const std::string& path, Picture picture);
    void stop();
    /// Stops, and waits until all videos are written; what went wrong is a warning, for nobody looks at the window any
    /// more.
    void finish();
    [[nodiscard]] bool is_recording() const { return recording_ != nullptr; }
    /// Whether a video of that path is recorded, or still written.
    [[nodiscard]] bool is_writing(const std::string& path) const;

    /// Another picture is seen from now on. None is needed while nothing is recorded.
    void add(Picture picture);

    /// A video that is done, once: written where `error` is empty.
    struct Outcome {
        std::string path;
        std::string error;
    };
    [[nodiscard]] std::optional<Outcome> take();

    /// Shows a red dot and the time, its upper left corner at (x, y), while recording.
    void show(float x, float y);
    /// The time that is shown is no longer so.
    [[nodiscard]] bool wants_frame() const;

private:
    [[nodiscard]] long long seconds() const;

    std::unique_ptr<Recording> recording_;
    std::vector<std::unique_ptr<Recording>> ended_;  // until they are written
    long long shown_seconds_ = 0;
};

}  // namespace croquis::viewer
