// Time per pass: GPU timer queries where there are any, else the wall clock around a finished pass (row B3).
#pragma once

#include <chrono>
#include <cstddef>
#include <vector>

#include "gpu/context.h"

namespace croquis::gpu {

/// Measures stretches of drawing one after the other. A software renderer's queries do not see the work that it puts
/// off, so there the wall clock is read when the stretch has been drawn to its end.
class StretchTimer {
public:
    explicit StretchTimer(Context& context);
    ~StretchTimer();
    StretchTimer(const StretchTimer&) = delete;
    StretchTimer& operator=(const StretchTimer&) = delete;

    void begin();
    void end();

    /// Milliseconds of each stretch since the last call, in order. Waits for them.
    [[nodiscard]] std::vector<double> milliseconds();

    [[nodiscard]] bool uses_queries() const { return uses_queries_; }

private:
    Context* context_;
    bool uses_queries_;
    std::vector<unsigned> queries_;
    std::vector<double> finished_;
    std::chrono::steady_clock::time_point begun_;
};

}  // namespace croquis::gpu
