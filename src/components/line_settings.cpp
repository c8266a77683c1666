#include "components/line_settings.h"

#include <algorithm>
#include <glm/trigonometric.hpp>

#include "base/error.h"
#include "base/names.h"
#include "lines/silhouette_finder.h"
#include "lines/stroke_styles.h"

namespace croquis::components {
namespace {

using framework::Pass;

template <typename T>
const T& value(const Pass& pass, const std::string& name) {
    return pass.variable<T>(name).value();
}

lines::LineClasses classes_named(const std::string& words) {
    lines::LineClasses classes;
    for (const std::string& word : split(words, " \t\n,")) {
        if (word == "all") {
            classes = lines::LineClasses::all();
        } else {
            classes.add(lines::line_class_named(word));
        }
    }
    return classes;
}

lines::Visibility visibility_named(const std::string& word) {
    if (word == "quantitative") return lines::Visibility::quantitative;
    if (word == "walking") return lines::Visibility::walking;
    if (word == "ray_cast") return lines::Visibility::ray_cast;
    if (word == "none") return lines::Visibility::none;
    return lines::Visibility::automatic;
}

// A name that finds nothing is told when it is set and not in a frame.
std::string finder_named(const std::string& name) {
    std::vector<std::string> names{"automatic"};
    for (const lines::FinderInfo& finder : lines::finder_infos()) names.emplace_back(finder.name);
    if (std::find(names.begin(), names.end(), name) != names.end()) return name;
    fail("expected a finder of silhouettes, found \"{}\"{}", name, suggestion(name, names));
}

// Lines that lie on the surface, where the others bound it.
bool is_inner(lines::LineClass line_class) {
    using lines::LineClass;
    return line_class == LineClass::crease || line_class == LineClass::tagged ||
           line_class == LineClass::intersection || line_class == LineClass::material;
}

void paint(lines::StrokeStyle& style, const glm::vec4& color) {
    style.color = glm::vec3(color);
    style.opacity = color.a;
}

// Plain lines in the pass's own colours.
lines::StyleSet plain_styles(const Pass& pass) {
    lines::StyleSet styles;
    for (const lines::LineClassInfo& info : lines::line_class_infos()) {
        paint(styles.visible[std::size_t(info.line_class)],
              value<glm::vec4>(pass, is_inner(info.line_class) ? "inner_color" : "color"));
    }
    return styles;
}

lines::StyleSet named_styles(const Pass& pass, const std::string& name) {
    std::vector<std::filesystem::path> folders;
    for (const std::filesystem::path& folder : pass.resources().folders().folders()) {
        folders.push_back(folder / "strokes");
    }
    return lines::StrokeStyles(std::move(folders)).set(name);
}

lines::StyleSet styles_of(const Pass& pass) {
    const std::string& name = value<std::string>(pass, "style");
    lines::StyleSet styles = name.empty() ? plain_styles(pass) : named_styles(pass, name);
    if (name.empty() || value<std::string>(pass, "hidden") == "dashed") {
        styles.hidden.fill(lines::dashed_style());
        for (lines::StrokeStyle& style : styles.hidden) paint(style, value<glm::vec4>(pass, "hidden_color"));
    }
    const glm::vec2& by_light = value<glm::vec2>(pass, "width_by_light");
    const glm::vec2& by_depth = value<glm::vec2>(pass, "width_by_depth");
    constexpr glm::vec2 as_the_style_says{1.0f, 1.0f};
    for (lines::StrokeStyle& style : styles.visible) {
        if (by_light != as_the_style_says) style.width_by_light = lines::WidthRange{by_light.x, by_light.y};
        if (by_depth != as_the_style_says) style.width_by_depth = lines::WidthRange{by_depth.x, by_depth.y};
    }
    return styles;
}

}  // namespace

LineSettings LineSettings::of(const Pass& pass) {
    LineSettings settings;
    lines::Options& find = settings.find;
    find.classes = classes_named(value<std::string>(pass, "classes"));
    find.crease_angle = glm::radians(double(value<float>(pass, "crease_angle")));
    find.hidden = value<std::string>(pass, "hidden") != "none";
    find.visibility = visibility_named(value<std::string>(pass, "visibility"));
    find.finder = finder_named(value<std::string>(pass, "finder"));
    find.clean = value<bool>(pass, "clean");

    lines::StrokeOptions& strokes = settings.strokes;
    strokes.styles = styles_of(pass);
    strokes.hidden = find.hidden;
    const double factor = value<float>(pass, "width");
    for (const lines::LineClassInfo& info : lines::line_class_infos()) {
        const std::string name = std::string(info.name) + "_width";
        strokes.widths[std::size_t(info.line_class)] = factor * value<float>(pass, name);
    }
    strokes.hidden_width = factor * value<float>(pass, "hidden_width");
    return settings;
}

}  // namespace croquis::components
