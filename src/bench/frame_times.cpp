#include "bench/frame_times.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "bench/framing.h"

namespace croquis::bench {
namespace {

constexpr int warm_up_frames = 3;

/// How many frames make a batch, so that all batches come to the asked frames or seconds, whichever is less.
int batch_size(double milliseconds, const Protocol& protocol) {
    const double in_time = 1000.0 * protocol.seconds / std::max(milliseconds, 1e-3);
    const double frames = std::min(in_time, double(protocol.frames)) / batches_of_each;
    return std::max(1, int(std::ceil(frames)));
}

/// Frames from the view of `options` on, each turned further.
std::vector<DrawOptions> frames_of(const DrawOptions& options, double turn, int count) {
    std::vector<DrawOptions> frames(std::size_t(count), options);
    for (int i = 0; i < count; ++i) frames[std::size_t(i)].view = turned(options.view, i * turn);
    return frames;
}

}  // namespace

double median(std::vector<double> values) {
    assert(!values.empty());
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 != 0) return *middle;
    return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

std::vector<TechniqueTime> time_interleaved(Renderer& renderer, const Model& model, std::vector<Technique>& techniques,
                                            const DrawOptions& options, const Protocol& protocol,
                                            const std::function<void()>& next_round) {
    std::vector<std::vector<DrawOptions>> frames;
    const std::vector<DrawOptions> first = frames_of(options, protocol.turn, warm_up_frames);
    for (Technique& technique : techniques) {
        (void)renderer.time_frames(model, technique, first);  // compiles and uploads
        const double milliseconds = renderer.time_frames(model, technique, first);
        frames.push_back(frames_of(options, protocol.turn, batch_size(milliseconds, protocol)));
    }
    std::vector<std::vector<double>> batches(techniques.size());
    for (int round = 0; round < batches_of_each; ++round) {
        next_round();
        for (std::size_t t = 0; t < techniques.size(); ++t) {
            batches[t].push_back(renderer.time_frames(model, techniques[t], frames[t]));
        }
    }
    std::vector<TechniqueTime> times;
    for (std::size_t t = 0; t < techniques.size(); ++t) {
        TechniqueTime& time = times.emplace_back();
        time.technique = techniques[t].name();
        time.milliseconds = median(batches[t]);
        time.ratio = time.milliseconds / times.front().milliseconds;
        time.frames = int(frames[t].size()) * batches_of_each;
    }
    return times;
}

void add_passes(Renderer& renderer, const Model& model, std::vector<Technique>& techniques, const DrawOptions& options,
                std::vector<TechniqueTime>& times) {
    std::vector<std::vector<std::vector<double>>> frames(techniques.size());  // of techniques, of passes
    for (int round = 0; round < batches_of_each; ++round) {
        for (std::size_t t = 0; t < techniques.size(); ++t) {
            const std::vector<PassTime> passes = renderer.time_passes(model, techniques[t], options);
            frames[t].resize(passes.size());
            for (std::size_t p = 0; p < passes.size(); ++p) frames[t][p].push_back(passes[p].milliseconds);
        }
    }
    for (std::size_t t = 0; t < techniques.size(); ++t) {
        const std::vector<std::string> names = techniques[t].pass_names();
        for (std::size_t p = 0; p < names.size(); ++p) times[t].passes.push_back({names[p], median(frames[t][p])});
    }
}

}  // namespace croquis::bench
