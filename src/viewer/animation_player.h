// Playing a model's animations: which clip, at what moment, how fast.
#pragma once

#include <string>
#include <vector>

#include "croquis/model.h"

namespace croquis::viewer {

class AnimationPlayer {
public:
    /// Takes a model's clips; the model is at rest.
    void take(std::vector<Animation> clips);

    [[nodiscard]] bool has_clips() const { return !clips_.empty(); }
    [[nodiscard]] bool is_playing() const { return is_playing_; }
    void set_playing(bool on);
    /// The clip's name; empty at rest.
    [[nodiscard]] std::string clip() const { return chosen_ < 0 ? "" : clips_[std::size_t(chosen_)].name; }
    [[nodiscard]] double seconds() const { return seconds_; }

    /// Goes on in time where it plays. A clip begins again at its end.
    void advance(double seconds);
    void choose(const std::string& clip);
    void set_seconds(double seconds) { seconds_ = seconds; }
    void set_speed(double speed) { speed_ = speed; }

    /// Shows the controls in the window. True when the moment is another than before.
    bool show();

private:
    std::vector<Animation> clips_;
    int chosen_ = -1;
    bool is_playing_ = false;
    double seconds_ = 0;
    double speed_ = 1;
};

}  // namespace croquis::viewer
