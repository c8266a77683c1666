// Seed A's protocol for measuring renderers (2.4): a fixed window and view, a series of levels of detail of one model,
// every renderer against the default one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "croquis/croquis.h"

namespace croquis::bench {

/// The technique that all others are compared with (seed A, 2.4.3).
constexpr const char* default_renderer = "phong";

/// What is measured, and how. The defaults are seed A's where it gives any.
struct Protocol {
    int width = 620;
    int height = 500;
    Vector3 direction{12.73, 17.85, 12.52};  ///< from the model to the eye: its table 2
    double coverage = 15;                    ///< percent of the frame's pixels that the model covers: its table 3
    double turn = 0;                         ///< degrees by which the eye goes around the model from frame to frame
    std::int64_t levels = 1;                 ///< of detail; each has half the faces of the one before
    std::vector<std::size_t> triangles{};    ///< of each level, in place of `levels`
    std::int64_t frames = 1000;              ///< of each technique at each level, unless `seconds` are over before
    double seconds = 1;
    /// Names, or paths of .technique files. The default renderer is measured first in any case.
    std::vector<std::string> techniques{};
    bool passes = false;     ///< time each pass as well
    bool stability = false;  ///< see stability.h
};

/// How a technique did at one level of detail.
struct TechniqueTime {
    std::string technique;
    double milliseconds = 0;  ///< a frame: the median of the batches' means
    double ratio = 1;         ///< to the default renderer's, of the same run
    int frames = 0;           ///< that were measured
    std::vector<PassTime> passes{};

    [[nodiscard]] double frames_a_second() const { return 1000.0 / milliseconds; }
};

struct LevelTimes {
    std::size_t triangles = 0;
    double coverage = 0;  ///< percent
    std::vector<TechniqueTime> techniques;
};

/// How quietly a technique draws a turning model.
struct TechniqueStability {
    std::string technique;
    double change = 0;  ///< mean change of a pixel's channels for each degree of turning, in levels of 0 to 255
    double ratio = 1;   ///< to the default renderer's
    double pops = 0;    ///< percent of the frame's pixels, in the worst step
};

struct Benchmark {
    RendererInfo machine;
    std::string model;
    int width = 0;
    int height = 0;
    std::vector<LevelTimes> levels;  ///< the whole model first
    std::vector<TechniqueStability> stabilities{};
};

/// Told what is worked on now, `step_count(protocol)` times.
using Step = std::function<void(const std::string&)>;

[[nodiscard]] std::size_t step_count(const Protocol& protocol);

/// Measures. `name` stands for the model in the result. Throws Error for techniques that do not exist, and for a model
/// that has not the asked levels of detail.
[[nodiscard]] Benchmark measure(Renderer& renderer, const Model& model, const std::string& name,
                                const Protocol& protocol, const Step& step);

}  // namespace croquis::bench
