// How well and how fast ways of telling which faces look at the eye do: seed A, tables 6 to 9.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "croquis/model.h"
#include "croquis/view.h"

namespace croquis {

/// What one way finds, as means over the views.
struct FaceOrientationResult {
    std::string method;
    double found = 0;  ///< faces taken for facing the eye
    double holes = 0;  ///< faces that do face it and were missed
    double microseconds = 0;
};

struct FaceOrientationOptions {
    View view{};           ///< its direction is the first of the views; its eye, where it has one, the only view
    int views = 64;        ///< directions spread evenly over the sphere
    double aspect = 1.24;  ///< of the frame that the view fits: 620 to 500, as in seed A's protocol
    std::uint64_t seed = 0;
};

/// Compares all ways. Throws Error for a view that cannot be placed or a number of views below 1.
[[nodiscard]] std::vector<FaceOrientationResult> compare_face_orientations(const Model& model,
                                                                           const FaceOrientationOptions& options);

}  // namespace croquis
