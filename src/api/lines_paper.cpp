// Drawings in lines on paper: sheets, strokes, fills, and the files they come to.
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <utility>

#include "api/lines_state.h"
#include "base/error.h"
#include "base/files.h"
#include "base/names.h"
#include "framework/data_folders.h"
#include "lines/drafter.h"
#include "lines/stroke_styles.h"
#include "lines/strokes.h"
#include "output/lines_json.h"
#include "output/pdf.h"
#include "output/sheet.h"
#include "output/svg.h"
#include "output/vector_drawing.h"
#include "output/vector_fill.h"
#include "output/vector_regions.h"

namespace croquis {
namespace {

struct NamedPaper {
    const char* name;
    double width;
    double height;
};
constexpr double usual_margin = 10;
constexpr std::array<NamedPaper, 9> named_papers{{{"a0", 841, 1189},
                                                  {"a1", 594, 841},
                                                  {"a2", 420, 594},
                                                  {"a3", 297, 420},
                                                  {"a4", 210, 297},
                                                  {"a5", 148, 210},
                                                  {"a6", 105, 148},
                                                  {"letter", 215.9, 279.4},
                                                  {"legal", 215.9, 355.6}}};

// What a hidden line looks like by its layers, unless a style says it.
constexpr const char* style_with_hidden_lines = "technical";

void check(const Paper& paper) {
    constexpr double longest = 10'000;
    const auto is_side = [](double side) { return side > 0 && side <= longest; };
    const bool is_frame_sized = paper.width == 0 && paper.height == 0;
    if (!is_frame_sized && !(is_side(paper.width) && is_side(paper.height))) {
        fail("expected a sheet of up to {0:g} x {0:g} mm, found {1:g} x {2:g}", longest, paper.width, paper.height);
    }
    if (!(paper.margin >= 0 && paper.margin <= longest)) {
        fail("expected a margin of 0 to {:g} mm, found {:g}", longest, paper.margin);
    }
    if (!is_frame_sized && !(std::min(paper.width, paper.height) > 2 * paper.margin)) {
        fail("expected margins that leave something of the sheet of {:g} x {:g} mm, found {:g} mm", paper.width,
             paper.height, paper.margin);
    }
}

void check_width(const std::string& what, double width) {
    constexpr double widest = 100;
    if (!(width > 0 && width <= widest)) {
        fail("expected a width of {} above 0 and at most {:g} mm, found {:g}", what, widest, width);
    }
}

lines::StyleSet styles_of(const InkOptions& ink) {
    lines::StyleSet styles;
    const bool is_styled = ink.hidden == InkOptions::Hidden::styled;
    if (ink.stroke.empty() && !is_styled && ink.data_folders.empty()) return styles;
    std::vector<std::filesystem::path> folders;
    const auto found = framework::DataFolders::find({ink.data_folders.begin(), ink.data_folders.end()});
    for (const std::filesystem::path& folder : found.folders()) folders.push_back(folder / "strokes");
    const lines::StrokeStyles known(std::move(folders));
    if (!ink.stroke.empty()) styles = known.set(ink.stroke);
    if (ink.stroke.empty()) styles.hidden = known.set(style_with_hidden_lines).hidden;
    if (!is_styled) styles.hidden.fill(lines::dashed_style());
    return styles;
}

lines::Strokes strokes_of(const FoundLines& found, const InkOptions& ink, const output::Sheet& sheet) {
    lines::StrokeOptions options;
    options.styles = styles_of(ink);
    options.scale = output::mm_per_screen_pixel / sheet.mm_per_pixel;
    options.seed = found.seed;
    for (const auto& [name, width] : ink.widths) {
        const lines::LineClass line_class = lines::line_class_named(name);
        check_width(name + " lines", width);
        options.widths[std::size_t(line_class)] = width * lines::pixels_per_mm;
    }
    check_width("hidden lines", ink.hidden_width);
    options.hidden_width = ink.hidden_width * lines::pixels_per_mm;
    return lines::make_strokes(found.drawing, options);
}

output::VectorGroup label_of(const PlacedView& view, const output::Sheet& sheet, output::NameGiver& names) {
    output::VectorGroup group;
    group.id = names.name(view.name + "-label");
    group.ink = output::Ink{.kind = output::Ink::Kind::fill, .width = 0};
    group.texts.push_back({sheet.place(view.label_place), view.label_height * sheet.mm_per_pixel, view.name});
    return group;
}

void place(std::vector<output::Ring>& rings, const PlacedView& view, const output::Sheet& sheet) {
    for (output::Ring& ring : rings) {
        for (glm::dvec2& point : ring.points) point = sheet.place(point + view.corner);
    }
}

output::VectorGroup white_area(const FoundLines& found, const PlacedView& view, const output::Sheet& sheet,
                               const std::string& id) {
    output::VectorGroup group;
    group.id = id;
    group.ink = output::Ink{.kind = output::Ink::Kind::fill, .width = 0, .color = glm::vec4(1.0f)};
    std::vector<output::Ring> rings = output::covered_area(*found.surface, view.viewpoint);
    place(rings, view, sheet);
    if (!rings.empty()) group.paths.push_back({std::move(rings), {}, std::nullopt});
    return group;
}

// All that may part two meshes in the picture, exactly.
std::vector<output::BoundaryPiece> boundaries_of(const FoundLines& found, const PlacedView& view) {
    lines::Options options;
    options.classes = {lines::LineClass::contour, lines::LineClass::silhouette, lines::LineClass::border,
                       lines::LineClass::material, lines::LineClass::intersection};
    options.clean = false;
    const lines::Drawing drawing = lines::Drafter(found.surface, options).draw(view.viewpoint);
    std::vector<output::BoundaryPiece> pieces;
    for (const lines::Line& line : drawing.lines) {
        const std::span<const lines::LinePoint> points = drawing.points_of(line);
        for (std::size_t i = 1; i < points.size(); ++i) pieces.push_back({points[i - 1].position, points[i].position});
        if (line.closed && points.size() > 1) pieces.push_back({points.back().position, points.front().position});
    }
    return pieces;
}

// The diffuse colour of a mesh, with the mean of its texture or of its vertices' colours.
glm::vec4 color_of(const model::Model& model, const model::Mesh& mesh) {
    const model::Material& material = model.materials[mesh.material];
    const auto mean = [](const auto& texels) {
        glm::dvec3 sum(0.0);
        for (const auto& texel : texels) sum += glm::dvec3(texel.x, texel.y, texel.z);
        return glm::vec3(sum / (255.0 * double(std::max<std::size_t>(std::size(texels), 1))));
    };
    glm::vec3 color = material.diffuse;
    if (material.texture) color *= mean(material.texture->pixels());
    if (!mesh.colors.empty()) color *= mean(mesh.colors);
    return {glm::min(color, glm::vec3(1.0f)), 1.0f};
}

output::VectorGroup region_areas(const FoundLines& found, const PlacedView& view, const output::Sheet& sheet,
                                 output::NameGiver& names, const std::string& id) {
    const model::Model& model = found.surface->model();
    const output::MeshPicker picker(*found.surface, view.viewpoint);
    auto regions = output::regions_between(boundaries_of(found, view), view.viewpoint.width, view.viewpoint.height,
                                           std::uint32_t(model.meshes.size()),
                                           [&](const glm::dvec2& pixel) { return picker.mesh_at(pixel); });
    output::VectorGroup all;
    all.id = names.name(id);
    for (std::size_t mesh = 0; mesh < regions.size(); ++mesh) {
        if (regions[mesh].empty()) continue;
        output::VectorGroup group;
        group.id = names.name(id, found.mesh_names[mesh]);
        group.ink =
            output::Ink{.kind = output::Ink::Kind::fill, .width = 0, .color = color_of(model, model.meshes[mesh])};
        place(regions[mesh], view, sheet);
        group.paths.push_back({std::move(regions[mesh]), {}, std::nullopt});
        all.groups.push_back(std::move(group));
    }
    return all;
}

std::vector<output::VectorGroup> view_groups(const FoundLines& found, const output::DrawnLines& drawn,
                                             const InkOptions& ink, const output::Sheet& sheet,
                                             output::NameGiver& names, std::uint32_t number) {
    const PlacedView& view = found.views[number];
    const std::string fill_id = view.name.empty() ? "fill" : view.name + "-fill";
    std::vector<output::VectorGroup> groups;
    if (ink.fill == InkOptions::Fill::white) groups.push_back(white_area(found, view, sheet, names.name(fill_id)));
    if (ink.fill == InkOptions::Fill::regions) groups.push_back(region_areas(found, view, sheet, names, fill_id));
    for (output::VectorGroup& group : output::groups_of(drawn, number, sheet, names)) {
        groups.push_back(std::move(group));
    }
    if (!view.name.empty()) groups.push_back(label_of(view, sheet, names));
    return groups;
}

output::VectorPage page_of(const FoundLines& found, const InkOptions& ink) {
    check(ink.paper);
    const output::Sheet sheet = output::lay_out({ink.paper.width, ink.paper.height, ink.paper.margin},
                                                found.drawing.width, found.drawing.height);
    const lines::Strokes strokes = strokes_of(found, ink, sheet);
    const std::vector<std::string> views = found.view_names();
    const output::DrawnLines drawn{
        .drawing = found.drawing,
        .strokes = strokes,
        .meshes = found.mesh_names,
        .views = views,
        .view_of_line = found.view_of_line,
        .hidden = ink.hidden == InkOptions::Hidden::styled ? output::DrawnLines::Hidden::by_layers
                                                           : output::DrawnLines::Hidden::as_one,
        .spines = found.is_clean ? output::DrawnLines::Spines::curves : output::DrawnLines::Spines::polylines};
    output::VectorPage page;
    page.width = sheet.width;
    page.height = sheet.height;
    page.title = ink.title.empty() ? std::filesystem::path(found.surface->model().name).filename().string() : ink.title;
    page.description = ink.description;
    output::NameGiver names;
    if (ink.plotter) {
        if (ink.fill != InkOptions::Fill::none) fail("expected no fill for a plotter, which draws lines alone");
        page.groups = output::pens_of(drawn, sheet, names);
    } else if (views.empty()) {
        page.groups = view_groups(found, drawn, ink, sheet, names, 0);
    } else {
        for (std::uint32_t v = 0; v < found.views.size(); ++v) {
            output::VectorGroup group;
            group.id = names.name(found.views[v].name);
            group.groups = view_groups(found, drawn, ink, sheet, names, v);
            page.groups.push_back(std::move(group));
        }
    }
    return page;
}

std::string json_of(const FoundLines& found) {
    const std::vector<std::string> views = found.view_names();
    return output::lines_json(found.drawing, {.meshes = found.mesh_names,
                                              .views = views,
                                              .view_of_line = found.view_of_line,
                                              .file_units = found.file_units});
}

}  // namespace

Paper Paper::named(const std::string& name) {
    std::vector<std::string> names;
    for (const NamedPaper& paper : named_papers) {
        if (name == paper.name) return {paper.width, paper.height, usual_margin};
        names.emplace_back(paper.name);
    }
    fail("unknown paper \"{}\"{}", name, suggestion(name, names));
}

Paper Paper::landscape() const { return {std::max(width, height), std::min(width, height), margin}; }

std::array<int, 2> Paper::frame() const {
    check(*this);
    const auto pixels = [&](double side) {
        return std::max(1, int(std::lround((side - 2 * margin) / output::mm_per_screen_pixel)));
    };
    return {pixels(width), pixels(height)};
}

std::vector<std::string> LineDrawing::formats() { return {"svg", "pdf", "json"}; }

std::string LineDrawing::encode(const std::string& format, const InkOptions& ink) const {
    if (format == "svg") return output::svg_text(page_of(*state_, ink));
    if (format == "pdf") return output::pdf_bytes(page_of(*state_, ink));
    if (format == "json") return json_of(*state_);
    fail("expected a format of svg, pdf or json, found \"{}\"{}", format, suggestion(format, formats()));
}

void LineDrawing::save(const std::string& path, const InkOptions& ink) const {
    std::string ending = std::filesystem::path(path).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    const std::vector<std::string> known = formats();
    if (ending.empty() || std::find(known.begin(), known.end(), ending.substr(1)) == known.end()) {
        fail("{}: expected a path that ends in .svg, .pdf or .json", path);
    }
    write_file_whole(path, encode(ending.substr(1), ink));
}

}  // namespace croquis
