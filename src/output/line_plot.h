// Plots of lines over two logarithmic axes, each line labelled at its end.
#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <vector>

namespace croquis::output {

struct PlotLine {
    std::string label;
    std::vector<glm::dvec2> points;  ///< above 0
};

struct LinePlot {
    std::string title;
    std::string x_label;
    std::string y_label;
    std::vector<PlotLine> lines;
};

/// The endings that `line_plot_bytes` knows: svg, png.
[[nodiscard]] std::vector<std::string> line_plot_formats();

/// The bytes of a file. Labels stand beside the right-most points, moved apart where they would overlap. Throws Error.
[[nodiscard]] std::string line_plot_bytes(const LinePlot& plot, const std::string& format);

/// Places for labels of one height, as near as can be to where they are wanted (least squares), in the order of the
/// wanted places, none closer to the next than `spacing`. `wanted` is ascending.
[[nodiscard]] std::vector<double> spread_labels(const std::vector<double>& wanted, double spacing);

}  // namespace croquis::output
