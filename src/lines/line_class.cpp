#include "lines/line_class.h"

#include <string>

#include "base/error.h"
#include "base/names.h"

namespace croquis::lines {

const std::array<LineClassInfo, line_class_count>& line_class_infos() {
    static constexpr std::array<LineClassInfo, line_class_count> infos{{
        {LineClass::contour, "contour", 0.5, "the outline of the whole drawing: nothing of the model lies behind it"},
        {LineClass::silhouette, "silhouette", 0.35, "where the surface turns away from the eye"},
        {LineClass::border, "border", 0.35, "the rim of an open surface"},
        {LineClass::tagged, "tagged", 0.25, "edges that the model's author marked"},
        {LineClass::crease, "crease", 0.25, "where the surface bends by more than the crease angle"},
        {LineClass::intersection, "intersection", 0.25, "where parts pass through each other"},
        {LineClass::material, "material", 0.18, "between two meshes or materials"},
    }};
    return infos;
}

const LineClassInfo& info_of(LineClass line_class) { return line_class_infos()[static_cast<std::size_t>(line_class)]; }

LineClass line_class_named(std::string_view name) {
    std::vector<std::string> names;
    for (const LineClassInfo& info : line_class_infos()) {
        if (info.name == name) return info.line_class;
        names.emplace_back(info.name);
    }
    fail("expected a class of lines, found \"{}\"{}", name, suggestion(std::string(name), names));
}

}  // namespace croquis::lines
