#include "orientation_table.h"

#include <fmt/format.h>

namespace croquis::app {

void print_orientation_table(const Model& model, const FaceOrientationOptions& options) {
    const double faces = double(model.triangle_count());
    fmt::print("{} triangles, means over {} views\n", model.triangle_count(), options.views);
    fmt::print("{:22} {:>10} {:>7} {:>9} {:>12}\n", "method", "faces", "share", "holes", "us a view");
    for (const FaceOrientationResult& result : compare_face_orientations(model, options)) {
        fmt::print("{:22} {:10.1f} {:6.1f}% {:9.2f} {:12.1f}\n", result.method, result.found,
                   100.0 * result.found / faces, result.holes, result.microseconds);
    }
}

}  // namespace croquis::app
