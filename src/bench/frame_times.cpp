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

/// Milliseconds a frame, over frames from the view of `options` on, each turned further. Their views are made some at a
/// time, between the times that are taken.
double time_turning(Renderer& renderer, const Model& model, Technique& technique, const DrawOptions& options,
                    double turn, int count) {
    constexpr int most_views = 1024;
    double sum = 0;
    for (int first = 0; first < count; first += most_views) {
        std::vector<DrawOptions> frames(std::size_t(std::min(most_views, count - first)), options);
        for (std::size_t i = 0; i < frames.size(); ++i) {
            frames[i].view = turned(options.view, (first + double(i)) * turn);
        }
        sum += double(frames.size()) * renderer.time_frames(model, technique, frames);
    }
    return sum / count;
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
    const auto time = [&](Technique& technique, int frames) {
        return time_turning(renderer, model, technique, options, protocol.turn, frames);
    };
    std::vector<int> frames;  // of a batch of each technique
    for (Technique& technique : techniques) {
        (void)time(technique, warm_up_frames);  // compiles and uploads
        frames.push_back(batch_size(time(technique, warm_up_frames), protocol));
    }
    std::vector<std::vector<double>> batches(techniques.size());
    for (int round = 0; round < batches_of_each; ++round) {
        next_round();
        for (std::size_t t = 0; t < techniques.size(); ++t) {
            batches[t].push_back(time(techniques[t], frames[t]));
        }
    }
    std::vector<TechniqueTime> times;
    for (std::size_t t = 0; t < techniques.size(); ++t) {
        TechniqueTime& one = times.emplace_back();
        one.technique = techniques[t].name();
        one.milliseconds = median(batches[t]);
        one.ratio = one.milliseconds / times.front().milliseconds;
        one.frames = frames[t] * batches_of_each;
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
