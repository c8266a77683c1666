#include "output/sheet.h"

#include <algorithm>
#include <cmath>

namespace croquis::output {

namespace {

// Rounded down, as files have it: rounded up, a sheet would be rasterised with a pixel more than the frame has.
double in_thousandths(double length) { return std::floor(length * 1000 + 1e-6) / 1000; }

}  // namespace

Sheet lay_out(const Paper& paper, double frame_width, double frame_height) {
    Sheet sheet;
    if (paper.width > 0) {
        sheet.width = paper.width;
        sheet.height = paper.height;
        sheet.mm_per_pixel =
            std::min((paper.width - 2 * paper.margin) / frame_width, (paper.height - 2 * paper.margin) / frame_height);
    } else {
        sheet.width = in_thousandths(frame_width * sheet.mm_per_pixel + 2 * paper.margin);
        sheet.height = in_thousandths(frame_height * sheet.mm_per_pixel + 2 * paper.margin);
    }
    const glm::dvec2 frame(frame_width * sheet.mm_per_pixel, frame_height * sheet.mm_per_pixel);
    sheet.origin = 0.5 * (glm::dvec2(sheet.width, sheet.height) - frame);
    return sheet;
}

}  // namespace croquis::output
