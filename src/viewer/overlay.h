// What a frame costs: frames a second, milliseconds a pass, how much is drawn and by what; a plot of the last frames.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <optional>
#include <vector>

#include "croquis/renderer.h"
#include "viewer/session.h"

namespace croquis::viewer {

class Overlay {
public:
    /// A drawing was made and took so long.
    void add_frame(double milliseconds);

    /// True when pass times are those of an older drawing and may be measured anew: at most twice a second.
    [[nodiscard]] bool is_due() const;
    /// Shows the box above at the right, between `low` and `high` across. Measures first where that is
    /// due, in the detail that the window itself draws with; not where it draws nothing.
    void show(float low, float high, Session& session, const Renderer& renderer, FrameSize frame,
              std::optional<Detail> detail);

private:
    void measure_passes(Session& session, FrameSize frame, Detail detail);

    static constexpr std::size_t frames_kept = 120;
    std::array<float, frames_kept> milliseconds_{};
    std::size_t next_ = 0;
    long long drawn_ = 0, measured_ = -1;
    std::chrono::steady_clock::time_point measured_at_;
    std::vector<PassTime> passes_;
};

}  // namespace croquis::viewer
