// croquis lines: models to drawings in lines, as SVG, PDF or JSON.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/files.h"
#include "base/names.h"
#include "commands.h"
#include "parse.h"
#include "progress.h"
#include "shape_options.h"
#include "view_options.h"

namespace croquis::app {
namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

constexpr int most_repeats = 10'000;

struct LinesOptions {
    Common common;
    std::string command_line;
    std::string model;
    std::string output, format;
    std::string size, paper;
    bool landscape = false;
    double margin = 10;
    ViewOptions view;
    std::string views;
    std::string arrangement = "third";
    std::string classes;
    double crease_angle = 60;
    std::string hidden = "none";
    std::vector<std::string> widths;
    double hidden_width = 0.18;
    std::string fill = "none";
    std::string stroke;
    bool plotter = false;
    bool clean = false, exact = false;
    std::string visibility = "automatic", finder = "automatic";
    ShapeOptions shape;
    std::uint64_t seed = 0;
    bool timings = false;
    int repeat = 1;

    void add_to(CLI::App& command);
    void add_lines_to(CLI::App& command);
    void add_paper_to(CLI::App& command);
    [[nodiscard]] std::string output_path() const;
    [[nodiscard]] std::string output_format() const;
    [[nodiscard]] InkOptions ink() const;
    [[nodiscard]] LineOptions find() const;

private:
    void check_views() const;
    const CLI::App* command_ = nullptr;
    const CLI::Option* margin_ = nullptr;
};

// One of some words, as an index into them.
std::size_t choice(const std::string& word, const std::string& what, const std::vector<std::string>& words) {
    const auto found = std::find(words.begin(), words.end(), word);
    if (found == words.end()) {
        fail("{}: expected {} or {}, found \"{}\"{}", what, fmt::join(words.begin(), words.end() - 1, ", "),
             words.back(), word, suggestion(word, words));
    }
    return std::size_t(found - words.begin());
}

std::string class_names() {
    std::string names;
    for (const LineClass& one : line_classes()) names += (names.empty() ? "" : ", ") + one.name;
    return names;
}

void LinesOptions::add_to(CLI::App& command) {
    command_ = &command;
    command.add_option("model", model, "Model file")->required();
    command.add_option(
        "-o,--output", output,
        "SVG, PDF or JSON file to write, by its ending, or - for standard output; MODEL.svg where none is "
        "named");
    command.add_option("--format", format, "svg, pdf or json, whatever the file's ending");
    add_lines_to(command);
    view.add_to(command);
    add_paper_to(command);
    command.add_flag("--timings", timings, "Print what each step took, in milliseconds, as JSON on standard error");
    command.add_option("--repeat", repeat, "Draw so many times; --timings prints the medians")
        ->check(check_whole_number)
        ->capture_default_str();
    command.add_option("--data", common.data_folders, "A folder of your own stroke styles, in its folder strokes")
        ->allow_extra_args(false);
}

void LinesOptions::add_lines_to(CLI::App& command) {
    command.add_option("--classes", classes,
                       "Kinds of lines, A,B,... or changes to all of them, +A,-B (--classes=-B): " + class_names());
    command.add_option("--crease-angle", crease_angle, "Degrees by which the surface bends at a crease")
        ->check(check_number)
        ->capture_default_str();
    command.add_option("--hidden", hidden, "Hidden lines: none, dashed, or styled by how many layers hide them")
        ->capture_default_str();
    command.add_flag("--clean", clean, "Leave what an illustrator would draw: no crumbs, closed curves (the default)");
    command.add_flag("--exact", exact, "Exactly the visible edges");
    command
        .add_option("--visibility", visibility,
                    "How it is decided what is seen: automatic, quantitative, walking, ray_cast, or none")
        ->capture_default_str();
    command
        .add_option("--finder", finder,
                    "Of silhouettes: automatic, exhaustive, hierarchy, randomised, gauss_map, gauss_map_overlapping")
        ->capture_default_str();
    shape.add_subdivision_to(command);
    command.add_option("--seed", seed, "Seed of everything random")->check(check_whole_number)->capture_default_str();
}

void LinesOptions::add_paper_to(CLI::App& command) {
    command.add_option("--size", size,
                       "The frame in pixels, WIDTHxHEIGHT; 1024x768, or what fills the paper at 96 pixels to the inch");
    command.add_option(
        "--paper", paper,
        "a0 to a6, letter, legal, or millimetres as WIDTHxHEIGHT; as large as the frame at 96 pixels to the "
        "inch where none is named");
    command.add_flag("--landscape", landscape, "Lay the paper on its long side");
    margin_ =
        command
            .add_option("--margin", margin, "Millimetres left free on all sides; where not given none without --paper")
            ->check(check_number)
            ->capture_default_str();
    command.add_option("--views", views,
                       "Several parallel views of one scale on one sheet: front,top,right,iso, back, left, bottom");
    command.add_option("--arrangement", arrangement, "Of the views: third or first angle")->capture_default_str();
    command.add_option("--width", widths, "CLASS=MM: the width of a kind of lines in millimetres; as often as needed")
        ->allow_extra_args(false);
    command.add_option("--hidden-width", hidden_width, "Of hidden lines, millimetres")
        ->check(check_number)
        ->capture_default_str();
    command.add_option("--stroke", stroke, "Name of a stroke style; even lines where none is named");
    command
        .add_option("--fill", fill,
                    "none; white: the model covers what lies behind it; regions: its visible parts in their colours")
        ->capture_default_str();
    command.add_flag("--plotter", plotter, "Paths joined and ordered for a pen plotter, a layer for each width of pen");
}

// "+material,-crease" changes the whole set; names alone are the set.
std::vector<std::string> parse_classes(const std::string& text) {
    std::vector<std::string> set, known;
    for (const LineClass& one : line_classes()) known.push_back(one.name);
    const std::vector<std::string> words = split(text, ", ");
    const auto changes = [](const std::string& word) { return word[0] == '+' || word[0] == '-'; };
    const auto change_count = std::count_if(words.begin(), words.end(), changes);
    if (words.empty() || (change_count != 0 && change_count != std::ptrdiff_t(words.size()))) {
        fail("--classes: expected names, or +NAME and -NAME, found \"{}\"", text);
    }
    if (change_count != 0) set = known;
    for (const std::string& word : words) {
        const std::string name = changes(word) ? word.substr(1) : word;
        if (std::find(known.begin(), known.end(), name) == known.end()) {
            fail("--classes: expected {}, found \"{}\"{}", class_names(), name, suggestion(name, known));
        }
        std::erase(set, name);
        if (word[0] != '-') set.push_back(name);
    }
    if (set.empty()) fail("--classes: expected at least one kind of lines, found \"{}\"", text);
    return set;
}

std::pair<std::string, double> parse_width(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || !check_number(text.substr(equals + 1)).empty()) {
        fail("--width: expected CLASS=MM, found \"{}\"", text);
    }
    std::vector<std::string> known;
    for (const LineClass& one : line_classes()) known.push_back(one.name);
    const std::string name = text.substr(0, equals);
    if (std::find(known.begin(), known.end(), name) == known.end()) {
        fail("--width: expected {}, found \"{}\"{}", class_names(), name, suggestion(name, known));
    }
    return {name, std::stod(text.substr(equals + 1))};
}

Paper parse_paper(const std::string& text) {
    const std::vector<std::string> sides = split(text, "xX");
    if (sides.size() == 2 && check_number(sides[0]).empty() && check_number(sides[1]).empty()) {
        Paper paper = Paper::named("a4");
        paper.width = std::stod(sides[0]);
        paper.height = std::stod(sides[1]);
        if (!(paper.width > 0 && paper.height > 0)) {
            fail("--paper: expected millimetres above 0 as WIDTHxHEIGHT, found \"{}\"", text);
        }
        return paper;
    }
    return Paper::named(text);
}

InkOptions LinesOptions::ink() const {
    InkOptions ink;
    if (!paper.empty()) ink.paper = parse_paper(paper);
    if (landscape && paper.empty()) fail("--landscape: expected --paper with it, found none");
    if (landscape) ink.paper = ink.paper.landscape();
    if (margin_->count() > 0) ink.paper.margin = margin;
    for (const std::string& width : widths)
        ink.widths.insert_or_assign(parse_width(width).first, parse_width(width).second);
    ink.hidden_width = hidden_width;
    const std::size_t chosen = choice(hidden, "--hidden", {"none", "dashed", "styled"});
    ink.hidden = chosen == 2 ? InkOptions::Hidden::styled : InkOptions::Hidden::dashed;
    ink.fill = InkOptions::Fill(choice(fill, "--fill", {"none", "white", "regions"}));
    ink.stroke = stroke;
    ink.data_folders = common.data_folders;
    ink.plotter = plotter;
    ink.description = command_line;
    return ink;
}

void LinesOptions::check_views() const {
    if (split(views, ", ").empty()) fail("--views: expected names of views, found \"{}\"", views);
    for (const char* other : {"--view", "--fit", "--eye", "--target", "--up", "--fov", "--projection"}) {
        if (command_->count(other) > 0) {
            fail("--views are parallel views along the axes: they do not go with {}", other);
        }
    }
}

LineOptions LinesOptions::find() const {
    LineOptions find;
    if (!size.empty()) {
        const Size pixels = parse_size(size, "--size");
        find.width = pixels.width;
        find.height = pixels.height;
    } else if (!paper.empty()) {
        const std::array<int, 2> frame = ink().paper.frame();
        find.width = frame[0];
        find.height = frame[1];
    }
    find.view = view.view();
    find.views = split(views, ", ");
    if (command_->count("--views") > 0) check_views();
    find.arrangement = LineOptions::Arrangement(choice(arrangement, "--arrangement", {"third", "first"}));
    find.animation = view.animation;
    find.time = view.time;
    if (command_->count("--classes") > 0) find.classes = parse_classes(classes);
    find.crease_angle = crease_angle;
    find.hidden = hidden != "none";
    if (clean && exact) fail("expected --clean or --exact, found both");
    find.clean = !exact;
    find.visibility = visibility;
    find.finder = finder;
    find.seed = seed;
    return find;
}

std::string LinesOptions::output_path() const {
    return output.empty() ? std::filesystem::path(model).stem().string() + "." + output_format() : output;
}

std::string LinesOptions::output_format() const {
    const std::vector<std::string> known = LineDrawing::formats();
    if (!format.empty()) return known[choice(format, "--format", known)];
    if (output.empty()) return known.front();
    if (output == "-") fail("expected --format svg, pdf or json for standard output");
    std::string ending = std::filesystem::path(output).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    if (ending.empty() || std::find(known.begin(), known.end(), ending.substr(1)) == known.end()) {
        fail("{}: expected a path that ends in .svg, .pdf or .json, or --format", output);
    }
    return ending.substr(1);
}

double milliseconds_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// The times of every run by the names of the steps, in their order.
class Timings {
public:
    void add(double load, double write, const LineReport& report) {
        const std::pair<const char*, double> times[] = {
            {"load", load},        {"adjacency", report.adjacency},   {"prepare", report.prepare},
            {"find", report.find}, {"visibility", report.visibility}, {"chain", report.chain},
            {"write", write}};
        steps_.resize(std::size(times));
        for (std::size_t i = 0; i < steps_.size(); ++i) {
            steps_[i].first = times[i].first;
            steps_[i].second.push_back(times[i].second);
        }
    }

    [[nodiscard]] Json medians() const {
        Json json;
        for (const auto& [name, times] : steps_) {
            std::vector<double> sorted = times;
            std::sort(sorted.begin(), sorted.end());
            const std::size_t half = sorted.size() / 2;
            const double median = sorted.size() % 2 == 1 ? sorted[half] : 0.5 * (sorted[half - 1] + sorted[half]);
            json[name] = std::round(median * 1000) / 1000;
        }
        return json;
    }

private:
    std::vector<std::pair<std::string, std::vector<double>>> steps_;
};

// Each run starts from the file, so that nothing is found twice for the price of one.
int run(const LinesOptions& options) {
    const LineOptions find = options.find();
    const InkOptions ink = options.ink();
    const std::string format = options.output_format(), path = options.output_path();
    if (options.repeat < 1 || options.repeat > most_repeats) {
        fail("--repeat: expected 1 to {}, found {}", most_repeats, options.repeat);
    }
    Timings timings;
    LineReport report;
    std::string bytes;
    for (int i = 0; i < options.repeat; ++i) {
        const Clock::time_point start = Clock::now();
        const Model model = options.shape.applied_to(Model::load(options.model));
        const double load_time = milliseconds_since(start);
        const LineDrawing drawing = draw_lines(model, find);
        const Clock::time_point before_write = Clock::now();
        bytes = drawing.encode(format, ink);
        report = drawing.report();
        timings.add(load_time, milliseconds_since(before_write), report);
    }
    write_file_whole(path, bytes);
    if (path != "-") app::report("wrote " + path);
    if (options.timings) {
        Json json = timings.medians();
        json.update({{"lines", report.lines},
                     {"points", report.points},
                     {"silhouette_edges", report.silhouette_edges},
                     {"clusters", report.clusters},
                     {"triangles", report.triangles}});
        fmt::print(stderr, "{}\n", json.dump());
    }
    return 0;
}

}  // namespace

void add_lines_command(CLI::App& program, Commands& commands, const std::string& command_line) {
    CLI::App* command =
        program.add_subcommand("lines", "Draws models in lines, to SVG, PDF or JSON: what is seen, what is hidden");
    const auto options = std::make_shared<LinesOptions>();
    options->command_line = command_line;
    options->add_to(*command);
    commands[command] = [options] { return run(*options); };
}

}  // namespace croquis::app
