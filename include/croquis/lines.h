// Drawings in lines: outlines, creases and borders found on the model itself, each part of them known to be seen or
// hidden, for the screen, for paper and for pen plotters.
//
//     const croquis::Model model = croquis::Model::load("bracket.obj");
//     croquis::InkOptions ink;
//     ink.paper = croquis::Paper::named("a4").landscape();
//     croquis::draw_lines(model).save("bracket.svg", ink);
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "croquis/model.h"
#include "croquis/view.h"

namespace croquis {

/// A kind of line.
struct LineClass {
    std::string name;
    double width_mm = 0;  ///< unless someone says otherwise
    std::string help;
};

/// All kinds: contour, silhouette, border, tagged, crease, intersection and material. Where a line is several of them
/// at once, the first names it.
[[nodiscard]] std::vector<LineClass> line_classes();

/// Which lines to find, and how. Names that do not exist throw Error with the nearest one.
struct LineOptions {
    int width = 1024;  ///< of the frame, pixels
    int height = 768;
    View view{};

    /// Several parallel views of one scale in one frame, in place of `view`: names that View::named takes. They stand
    /// as a technical drawing arranges them: views from the side in line with the front view, iso in the corner.
    std::vector<std::string> views{};
    enum class Arrangement {
        third_angle,  ///< the view from the right stands on the right, that from the top above
        first_angle,  ///< the view from the right stands on the left, that from the top below
    };
    Arrangement arrangement = Arrangement::third_angle;

    std::string animation{};  ///< name of the model's animation; at rest when empty
    double time = 0;          ///< seconds into the animation

    std::vector<std::string> classes{};  ///< kinds of lines; all when empty
    double crease_angle = 60;            ///< degrees, from 0 of a flat surface to 180 of a fold
    bool hidden = false;                 ///< hidden lines too, each with the number of layers that hide it
    /// automatic, quantitative (quantitative invisibility after Appel), walking (the same without any ray), ray_cast,
    /// or none: everything counts as visible.
    std::string visibility = "automatic";
    std::string finder = "automatic";  ///< of silhouettes; croquis lines --help names them
    /// Leaves what an illustrator would draw: crumbs go, interrupted curves close. Off: exactly the visible edges.
    bool clean = true;
    std::uint64_t seed = 0;  ///< of everything random
};

/// A sheet of paper, in millimetres.
struct Paper {
    double width = 0;  ///< 0: as large as the frame at 96 pixels to the inch
    double height = 0;
    double margin = 0;  ///< left free on all sides

    /// a0 to a6, letter or legal, upright, with a margin of 10 mm. Throws Error with the nearest name.
    [[nodiscard]] static Paper named(const std::string& name);
    /// The same, lying on its long side.
    [[nodiscard]] Paper landscape() const;
    /// The pixels of a frame that fills the sheet within its margins, at 96 to the inch. Throws Error where the margins
    /// leave nothing.
    [[nodiscard]] std::array<int, 2> frame() const;
};

/// How lines are put on paper. JSON knows nothing of it.
struct InkOptions {
    Paper paper{};
    std::map<std::string, double> widths{};  ///< of classes, millimetres, where they are not LineClass::width_mm
    double hidden_width = 0.18;              ///< millimetres

    /// What hidden lines look like, where the drawing has them.
    enum class Hidden {
        dashed,  ///< all alike
        styled,  ///< by how many layers hide them, as the stroke style says
    };
    Hidden hidden = Hidden::dashed;

    /// What the surface looks like.
    enum class Fill {
        none,
        white,    ///< covers what lies behind the drawing
        regions,  ///< each mesh's visible part in its material's colour
    };
    Fill fill = Fill::none;

    std::string stroke{};  ///< a style of the data folders' strokes; even lines when empty
    std::vector<std::string> data_folders{};

    /// For a machine with pens: spines of strokes alone, joined and ordered, a layer for each width.
    bool plotter = false;

    std::string title{};        ///< of the file; the name of the model's file when empty
    std::string description{};  ///< of the file: the command that made it, for one
};

/// A point of a line.
struct LinePoint {
    double x = 0;  ///< pixels, from the frame's upper left corner; y points down
    double y = 0;
    double depth = 0;  ///< distance from the eye along the direction of looking, in the file's units
};

/// A line: a long curve wherever the model has one.
struct LinePath {
    std::string line_class;
    std::string mesh;
    std::string view;     ///< empty where there is but one
    int layers = 0;       ///< how many layers of surface hide it; 0: visible
    bool closed = false;  ///< the last point is joined to the first, which is not repeated
    std::vector<LinePoint> points;
};

/// What drawing took and met. Times are milliseconds.
struct LineReport {
    double adjacency = 0;  ///< who touches whom on the surface; next to nothing where the model knows it already
    double prepare = 0;    ///< what the finder of silhouettes computes once for a model
    double find = 0;
    double visibility = 0;
    double chain = 0;
    std::size_t triangles = 0;
    std::size_t silhouette_edges = 0;
    std::size_t clusters = 0;  ///< connected sets of edges
    std::size_t lines = 0;
    std::size_t points = 0;
};

/// A finished drawing in lines. It does not change; copies share it.
class LineDrawing {
public:
    [[nodiscard]] int width() const;
    [[nodiscard]] int height() const;
    [[nodiscard]] std::vector<LinePath> paths() const;
    [[nodiscard]] const LineReport& report() const;

    /// The endings that `save` knows, which are the formats that `encode` knows: svg, pdf, json.
    [[nodiscard]] static std::vector<std::string> formats();

    /// The bytes of a file. docs/lines-format.md says what is in it. Throws Error.
    [[nodiscard]] std::string encode(const std::string& format, const InkOptions& ink = {}) const;

    /// Writes an SVG, PDF or JSON file by the path's ending, whole or not at all. Throws Error.
    void save(const std::string& path, const InkOptions& ink = {}) const;

private:
    friend LineDrawing draw_lines(const Model& model, const LineOptions& options);
    struct State;
    explicit LineDrawing(std::shared_ptr<const State> state) : state_(std::move(state)) {}
    std::shared_ptr<const State> state_;
};

/// Finds the lines of a model in a view. The same options give the same lines, on any number of threads. Warns when
/// nothing of the model lies in the frame. Throws Error for options that make no sense.
[[nodiscard]] LineDrawing draw_lines(const Model& model, const LineOptions& options = {});

}  // namespace croquis
