// A drawing against the truth, point by point: what is drawn must be there, and what is there must be drawn, once.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lines/drawing.h"
#include "truth/view_truth.h"

namespace croquis::lines::truth {

/// Lengths in pixels. Those that disagree tell of what kind they are.
struct Agreement {
    double expected = 0;  ///< what must be drawn
    double drawn = 0;
    double skipped = 0;  ///< of both, where the truth is not certain

    double missing = 0;          ///< expected, and no line is there
    double doubled = 0;          ///< expected, and several lines are there
    double wrong_class = 0;      ///< expected, and the line there has another class
    double wrong_contour = 0;    ///< the same, when only contour is taken for silhouette or border, or they for it
    double stray = 0;            ///< drawn where no feature edge is
    double falsely_visible = 0;  ///< drawn as visible, but hidden
    double wrong_layers = 0;     ///< drawn as hidden, but visible or by another number of layers
    double farthest = 0;         ///< from a drawn point to the edge that it stands for; no length that disagrees

    std::vector<std::string> examples;  ///< a few disagreements in words

    /// The share of the length that agrees.
    [[nodiscard]] double share() const;
    [[nodiscard]] double disagreeing() const;
    [[nodiscard]] std::string summary() const;
    Agreement& operator+=(const Agreement& other);
};

struct Sampling {
    double spacing = 4;  ///< pixels, in the mean
    std::uint64_t seed = 0;
};

/// Compares an exact drawing (Options::clean off) of all classes. With `hidden`, hidden lines are expected too.
[[nodiscard]] Agreement compare(const ViewTruth& truth, const Drawing& drawing, bool hidden,
                                const Sampling& sampling = {});

}  // namespace croquis::lines::truth
