#include "output/lines_json.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "output/svg.h"
#include "output/vector_page.h"

namespace croquis::output {
namespace {

// Thousandths of a pixel, where rounding is finer than any screen; six digits that count of a depth.
void append_points(std::string& text, std::span<const lines::LinePoint> points, double file_units) {
    text += '[';
    for (std::size_t i = 0; i < points.size(); ++i) {
        text += i == 0 ? "[" : ",[";
        append_number(text, points[i].position.x);
        text += ',';
        append_number(text, points[i].position.y);
        fmt::format_to(std::back_inserter(text), ",{:.7g}]", points[i].depth * file_units);
    }
    text += ']';
}

std::string quoted(const std::string& name) { return nlohmann::json(clean_text(name)).dump(); }

}  // namespace

std::string lines_json(const lines::Drawing& drawing, const LineNames& names) {
    std::string text = fmt::format("{{\"width\": {}, \"height\": {}, \"paths\": [", number_text(drawing.width),
                                   number_text(drawing.height));
    for (std::size_t l = 0; l < drawing.lines.size(); ++l) {
        const lines::Line& line = drawing.lines[l];
        text += l == 0 ? "\n" : ",\n";
        text += fmt::format("{{\"class\": \"{}\", \"mesh\": {}, ", lines::info_of(line.line_class).name,
                            quoted(names.meshes[line.mesh]));
        if (!names.views.empty()) text += fmt::format("\"view\": {}, ", quoted(names.views[names.view_of_line[l]]));
        text += fmt::format("\"visible\": {}, \"layers\": {}, \"closed\": {}, \"points\": ", line.visible(),
                            line.layers, line.closed);
        append_points(text, drawing.points_of(line), names.file_units);
        text += '}';
    }
    text += "\n]}\n";
    return text;
}

}  // namespace croquis::output
