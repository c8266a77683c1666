#include "output/line_plot.h"

#include <cairo-svg.h>
#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>

#include "base/error.h"
#include "output/svg.h"

namespace croquis::output {
namespace {

constexpr double width = 960, height = 640;
constexpr double left = 80, right = 730, top = 56, bottom = 572;  // of the plotted area
constexpr double label_place = 770;
constexpr double text_height = 14, title_height = 18;
constexpr double gap = 6;

struct Rgb {
    double red, green, blue;
};
// Okabe and Ito's colours, which the colour-blind tell apart, but for the yellow; dashes tell lines of one colour
// apart.
constexpr std::array<Rgb, 7> colors{{{0, 0, 0},
                                     {0, 0.447, 0.698},
                                     {0.835, 0.369, 0},
                                     {0, 0.620, 0.451},
                                     {0.8, 0.475, 0.655},
                                     {0.337, 0.706, 0.914},
                                     {0.902, 0.624, 0}}};
const std::array<std::vector<double>, 4> dashes{{{}, {7, 3}, {2, 3}, {10, 3, 2, 3}}};

struct DestroySurface {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
struct DestroyContext {
    void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using Surface = std::unique_ptr<cairo_surface_t, DestroySurface>;
using Cairo = std::unique_ptr<cairo_t, DestroyContext>;

cairo_status_t append(void* bytes, const unsigned char* data, unsigned length) {
    static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
}

/// A logarithmic axis from one place of the page to another.
class Axis {
public:
    Axis(double low, double high, double first, double last)
        : low_(std::log(low)), high_(std::log(high)), first_(first), last_(last) {}

    [[nodiscard]] double place(double value) const {
        return first_ + (std::log(value) - low_) / (high_ - low_) * (last_ - first_);
    }

private:
    double low_, high_, first_, last_;
};

struct Range {
    double low = std::numeric_limits<double>::max();
    double high = 0;
};

/// What the points span along a coordinate, with some room around.
Range range_of(const LinePlot& plot, int coordinate, double room) {
    Range range;
    for (const PlotLine& line : plot.lines) {
        for (const glm::dvec2& point : line.points) {
            range.low = std::min(range.low, point[coordinate]);
            range.high = std::max(range.high, point[coordinate]);
        }
    }
    return {range.low / room, range.high * room};
}

/// 1, 2 and 5 times powers of ten within a range.
std::vector<double> round_values(const Range& range) {
    std::vector<double> values;
    for (double power = std::pow(10.0, std::floor(std::log10(range.low))); power <= range.high; power *= 10) {
        for (const double digit : {1.0, 2.0, 5.0}) {
            if (digit * power >= range.low && digit * power <= range.high) values.push_back(digit * power);
        }
    }
    return values;
}

/// The lines' own values along x: they are few, and say more than round ones.
std::vector<double> own_values(const LinePlot& plot) {
    std::vector<double> values;
    for (const PlotLine& line : plot.lines) {
        for (const glm::dvec2& point : line.points) values.push_back(point.x);
    }
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

enum class Align { start, middle, end };

void write(cairo_t* cairo, const std::string& text, const glm::dvec2& place, Align align, double size = text_height) {
    cairo_set_font_size(cairo, size);
    const std::string clean = clean_text(text);
    cairo_text_extents_t extents;
    cairo_text_extents(cairo, clean.c_str(), &extents);
    const double share = align == Align::start ? 0.0 : align == Align::middle ? 0.5 : 1.0;
    cairo_move_to(cairo, place.x - share * extents.x_advance, place.y);
    cairo_show_text(cairo, clean.c_str());
}

void write_upwards(cairo_t* cairo, const std::string& text, const glm::dvec2& place) {
    cairo_save(cairo);
    cairo_translate(cairo, place.x, place.y);
    cairo_rotate(cairo, -1.570796326794897);
    write(cairo, text, {0, 0}, Align::middle);
    cairo_restore(cairo);
}

void segment(cairo_t* cairo, const glm::dvec2& a, const glm::dvec2& b) {
    cairo_move_to(cairo, a.x, a.y);
    cairo_line_to(cairo, b.x, b.y);
    cairo_stroke(cairo);
}

void draw_axes(cairo_t* cairo, const LinePlot& plot, const Axis& x, const Axis& y, const Range& y_range) {
    cairo_set_line_width(cairo, 1);
    for (const double value : round_values(y_range)) {
        cairo_set_source_rgb(cairo, 0.85, 0.85, 0.85);
        segment(cairo, {left, y.place(value)}, {right, y.place(value)});
        cairo_set_source_rgb(cairo, 0, 0, 0);
        write(cairo, fmt::format("{:g}", value), {left - gap, y.place(value) + 0.35 * text_height}, Align::end);
    }
    double free_from = 0;
    for (const double value : own_values(plot)) {
        const double place = x.place(value);
        cairo_set_source_rgb(cairo, 0.85, 0.85, 0.85);
        segment(cairo, {place, top}, {place, bottom});
        cairo_set_source_rgb(cairo, 0, 0, 0);
        if (place < free_from) continue;
        write(cairo, fmt::format("{:g}", value), {place, bottom + gap + text_height}, Align::middle);
        free_from = place + 4 * text_height;
    }
    write(cairo, plot.title, {left, top - 2 * gap - gap}, Align::start, title_height);
    write(cairo, plot.x_label, {0.5 * (left + right), height - 2 * gap}, Align::middle);
    write_upwards(cairo, plot.y_label, {2 * gap + text_height, 0.5 * (top + bottom)});
}

void choose_ink(cairo_t* cairo, std::size_t line) {
    const Rgb& color = colors[line % colors.size()];
    const std::vector<double>& dash = dashes[line / colors.size() % dashes.size()];
    cairo_set_source_rgb(cairo, color.red, color.green, color.blue);
    cairo_set_dash(cairo, dash.data(), int(dash.size()), 0);
}

void draw_line(cairo_t* cairo, const PlotLine& line, const Axis& x, const Axis& y) {
    cairo_set_line_width(cairo, 2);
    cairo_new_path(cairo);  // text leaves its end behind
    for (const glm::dvec2& point : line.points) cairo_line_to(cairo, x.place(point.x), y.place(point.y));
    cairo_stroke(cairo);
    for (const glm::dvec2& point : line.points) {
        cairo_arc(cairo, x.place(point.x), y.place(point.y), 3, 0, 6.283185307179586);
        cairo_fill(cairo);
    }
}

glm::dvec2 right_end(const PlotLine& line) {
    return *std::max_element(line.points.begin(), line.points.end(),
                             [](const glm::dvec2& a, const glm::dvec2& b) { return a.x < b.x; });
}

/// Labels in the order of the lines' ends from top to bottom, each led to from its line's end.
void draw_labels(cairo_t* cairo, const LinePlot& plot, const Axis& x, const Axis& y) {
    const auto end = [&](std::size_t line) {
        const glm::dvec2 point = right_end(plot.lines[line]);
        return glm::dvec2(x.place(point.x), y.place(point.y));
    };
    std::vector<std::size_t> order(plot.lines.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return end(a).y < end(b).y; });
    std::vector<double> wanted;
    for (const std::size_t line : order) wanted.push_back(end(line).y);
    const double spacing = std::min(1.15 * text_height, (height - 2 * text_height) / double(order.size()));
    std::vector<double> places = spread_labels(wanted, spacing);
    const double highest = std::max(0.0, text_height - places.front());
    const double lowest = std::max(0.0, places.back() + text_height - height);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const double place = places[i] + highest - lowest;
        choose_ink(cairo, order[i]);
        cairo_set_line_width(cairo, 0.75);
        segment(cairo, end(order[i]) + glm::dvec2(gap, 0), {label_place - gap, place});
        write(cairo, plot.lines[order[i]].label, {label_place, place + 0.35 * text_height}, Align::start,
              std::min(text_height, spacing));
    }
}

void draw(cairo_t* cairo, const LinePlot& plot) {
    const Range x_range = range_of(plot, 0, 1.05), y_range = range_of(plot, 1, 1.15);
    const Axis x(x_range.low, x_range.high, left, right), y(y_range.low, y_range.high, bottom, top);
    cairo_set_source_rgb(cairo, 1, 1, 1);
    cairo_paint(cairo);
    cairo_select_font_face(cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    draw_axes(cairo, plot, x, y, y_range);
    for (std::size_t line = 0; line < plot.lines.size(); ++line) {
        choose_ink(cairo, line);
        draw_line(cairo, plot.lines[line], x, y);
    }
    draw_labels(cairo, plot, x, y);
}

}  // namespace

std::vector<std::string> line_plot_formats() { return {"svg", "png"}; }

// Pool adjacent violators: with i times the spacing taken off, the places must ascend.
std::vector<double> spread_labels(const std::vector<double>& wanted, double spacing) {
    struct Block {
        double sum = 0;
        std::size_t count = 0;
        [[nodiscard]] double mean() const { return sum / double(count); }
    };
    std::vector<Block> blocks;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        blocks.push_back({wanted[i] - double(i) * spacing, 1});
        while (blocks.size() > 1 && blocks[blocks.size() - 2].mean() > blocks.back().mean()) {
            const Block last = blocks.back();
            blocks.pop_back();
            blocks.back().sum += last.sum;
            blocks.back().count += last.count;
        }
    }
    std::vector<double> places;
    for (const Block& block : blocks) {
        for (std::size_t k = 0; k < block.count; ++k) places.push_back(block.mean() + double(places.size()) * spacing);
    }
    return places;
}

std::string line_plot_bytes(const LinePlot& plot, const std::string& format) {
    const bool is_svg = format == "svg";
    if (!is_svg && format != "png") fail("expected a plot as svg or png, found \"{}\"", format);
    std::string bytes;
    const Surface surface(is_svg ? cairo_svg_surface_create_for_stream(append, &bytes, width, height)
                                 : cairo_image_surface_create(CAIRO_FORMAT_RGB24, int(width), int(height)));
    draw(Cairo(cairo_create(surface.get())).get(), plot);
    cairo_status_t status = cairo_surface_status(surface.get());
    if (is_svg) {
        cairo_surface_finish(surface.get());
        status = cairo_surface_status(surface.get());
    } else if (status == CAIRO_STATUS_SUCCESS) {
        status = cairo_surface_write_to_png_stream(surface.get(), append, &bytes);
    }
    if (status != CAIRO_STATUS_SUCCESS) fail("cannot draw the plot: {}", cairo_status_to_string(status));
    return bytes;
}

}  // namespace croquis::output
