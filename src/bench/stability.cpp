#include "bench/stability.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "bench/framing.h"

namespace croquis::bench {
namespace {

constexpr int steps = 12;  // of a degree each
constexpr int sudden = 64;
constexpr int still = 8;

/// The largest change of the three channels of the pixel whose bytes start at `i`.
int change_at(const Picture& before, const Picture& after, std::size_t i) {
    int largest = 0;
    for (std::size_t c = i; c < i + 3; ++c) {
        largest = std::max(largest, std::abs(int(before.pixels()[c]) - int(after.pixels()[c])));
    }
    return largest;
}

std::vector<Picture> turning_pictures(Renderer& renderer, const Model& model, Technique& technique,
                                      const DrawOptions& options) {
    std::vector<Picture> pictures;
    DrawOptions view = options;
    for (int degrees = 0; degrees <= steps; ++degrees) {
        view.view = turned(options.view, degrees);
        pictures.push_back(renderer.draw(model, technique, view));
    }
    return pictures;
}

}  // namespace

double mean_change(const Picture& before, const Picture& after) {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < before.pixels().size(); i += 4) {
        for (std::size_t c = i; c < i + 3; ++c) {
            sum += std::abs(int(before.pixels()[c]) - int(after.pixels()[c]));
        }
    }
    return double(sum) / (3.0 * before.width() * before.height());
}

double popped_share(const Picture& before, const Picture& after, const Picture& default_before,
                    const Picture& default_after) {
    std::size_t popped = 0;
    for (std::size_t i = 0; i < before.pixels().size(); i += 4) {
        popped += change_at(before, after, i) > sudden && change_at(default_before, default_after, i) <= still;
    }
    return 100.0 * double(popped) / (double(before.width()) * before.height());
}

std::vector<TechniqueStability> measure_stability(Renderer& renderer, const Model& model,
                                                  std::vector<Technique>& techniques, const DrawOptions& options,
                                                  const Step& step) {
    std::vector<TechniqueStability> found;
    std::vector<Picture> of_default;
    for (Technique& technique : techniques) {
        step("turning: " + technique.name());
        const std::vector<Picture> pictures = turning_pictures(renderer, model, technique, options);
        if (of_default.empty()) of_default = pictures;
        TechniqueStability& one = found.emplace_back();
        one.technique = technique.name();
        for (std::size_t i = 0; i < steps; ++i) {
            one.change += mean_change(pictures[i], pictures[i + 1]) / steps;
            one.pops = std::max(one.pops, popped_share(pictures[i], pictures[i + 1], of_default[i], of_default[i + 1]));
        }
        one.ratio = found.front().change > 0 ? one.change / found.front().change : 1;
    }
    return found;
}

}  // namespace croquis::bench
