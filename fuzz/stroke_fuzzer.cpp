// Stroke styles and offset files: any bytes give strokes of finite size, or an Error.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>

#include "base/error.h"
#include "lines/stroke_mesh.h"
#include "lines/strokes.h"

using namespace croquis;
using namespace croquis::lines;

namespace {

// A bent line, a closed one and a hidden one.
Drawing sample() {
    Drawing drawing{100, 100, {}, {}};
    const auto add = [&](std::initializer_list<glm::dvec2> points, bool closed, std::uint32_t layers) {
        drawing.lines.push_back({LineClass::silhouette, 0, layers, closed,
                                 static_cast<std::uint32_t>(drawing.points.size()),
                                 static_cast<std::uint32_t>(points.size())});
        for (const glm::dvec2& point : points) drawing.points.push_back({point, point.x, {0.6f, 0.0f, 0.8f}});
    };
    add({{5, 5}, {40, 9}, {41, 60}, {41.1, 60.2}}, false, 0);
    add({{50, 50}, {60, 50}, {55, 58}}, true, 0);
    add({{10, 70}, {40, 75}}, false, 1);
    return drawing;
}

void check(const Strokes& strokes) {
    for (const Stroke& stroke : strokes.strokes) {
        if (stroke.first_point + stroke.point_count > strokes.points.size()) std::abort();
        if (stroke.brush >= strokes.brushes.size()) std::abort();
        static_cast<void>(outline_of(strokes, stroke));
    }
    for (const StrokePoint& point : strokes.points) {
        if (!std::isfinite(point.position.x) || !std::isfinite(point.position.y)) std::abort();
        if (!(point.width >= 0) || !(point.color.a >= 0 && point.color.a <= 1)) std::abort();
    }
    const StrokeMesh mesh = make_stroke_mesh(strokes);
    for (const std::uint32_t index : mesh.indices) {
        if (index >= mesh.vertices.size()) std::abort();
    }
}

}  // namespace

// A line `---` separates the style from its offset file.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    const std::size_t cut = text.find("\n---\n");
    try {
        StrokeStyle style = read_stroke_style(text.substr(0, cut), "style");
        if (cut != std::string::npos) {
            style.pattern = std::make_shared<const OffsetPattern>(read_offsets(text.substr(cut + 5), "offsets"));
        }
        StrokeOptions options;
        options.styles.visible.fill(style);
        options.styles.hidden.fill(style);
        check(make_strokes(sample(), options));
    } catch (const Error& error) {
        if (std::string(error.what()).empty()) std::abort();
    }
    return 0;
}
