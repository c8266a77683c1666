#include "lines/stroke_style.h"

#include <algorithm>

namespace croquis::lines {

double pixels_of(const Length& length, const LengthScale& scale) {
    switch (length.unit) {
        case Length::Unit::pixels:
            return length.value * scale.pixel;
        case Length::Unit::millimetres:
            return length.value * pixels_per_mm * scale.pixel;
        case Length::Unit::widths:
            return length.value * scale.width;
        case Length::Unit::share:
            return length.value * scale.line;
    }
    return 0;
}

StrokeStyle dashed_style() {
    StrokeStyle style;
    style.dash = {{12.0, Length::Unit::widths}, {3.0, Length::Unit::widths}};
    style.dash_fit = true;
    style.ends = StrokeEnds::butt;
    return style;
}

StyleSet::StyleSet() : StyleSet(StrokeStyle{}) {}

StyleSet::StyleSet(const StrokeStyle& style) {
    visible.fill(style);
    hidden.fill(dashed_style());
}

const StrokeStyle& StyleSet::style_of(const Line& line) const {
    if (line.visible()) return visible[static_cast<std::size_t>(line.line_class)];
    return hidden[std::min<std::size_t>(line.layers, hidden.size()) - 1];
}

}  // namespace croquis::lines
