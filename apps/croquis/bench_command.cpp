// croquis bench: what techniques cost, as ratios to the default renderer of the same run.
#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <limits>
#include <system_error>

#include "base/error.h"
#include "base/files.h"
#include "base/names.h"
#include "bench/benchmark.h"
#include "bench/reports.h"
#include "built_in_model.h"
#include "commands.h"
#include "orientation_table.h"
#include "parse.h"
#include "progress.h"
#include "shape_options.h"

namespace croquis::app {
namespace {

namespace fs = std::filesystem;

struct BenchOptions {
    Common common;
    std::string model;
    std::string texture;
    ShapeOptions shape;
    std::string techniques =
        "base,cel,comic,comic_extended,outline_stencil,outline_front_face,hatching_simple,hatching_fine,cartoon";
    std::string size = "620x500";
    std::string direction = "12.73,17.85,12.52";
    bench::Protocol protocol;
    std::string triangles;
    std::string json, plot;
    bool orientation = false;

    void add_to(CLI::App& command);
};

void BenchOptions::add_to(CLI::App& command) {
    command.add_option("model", model, "Model file; a built-in teapot where none is named");
    command.add_option("--texture", texture, "Image for all surfaces in place of the materials' own");
    shape.add_subdivision_to(command);
    command
        .add_option("-t,--techniques", techniques,
                    "Names or .technique files, A,B,..., or all; phong, the default renderer, is always measured")
        ->capture_default_str();
    command.add_option("--size", size, "Pixels, WIDTHxHEIGHT")->capture_default_str();
    command.add_option("--view", direction, "Direction from the box's centre to the eye, X,Y,Z, or a named view")
        ->capture_default_str();
    command.add_option("--coverage", protocol.coverage, "Percent of the pixels that the whole model covers")
        ->check(check_number)
        ->capture_default_str();
    command.add_option("--turn", protocol.turn, "Degrees by which the eye goes around the model from frame to frame")
        ->check(check_number)
        ->capture_default_str();
    command.add_option("--levels", protocol.levels, "Levels of detail, each of half the faces of the one before")
        ->check(check_whole_number)
        ->capture_default_str();
    command.add_option("--triangles", triangles, "Levels of detail of N,N,... triangles, in place of --levels");
    command
        .add_option("--frames", protocol.frames,
                    "Frames of each technique at each level, unless --seconds end first; at least 11")
        ->check(check_whole_number)
        ->capture_default_str();
    command.add_option("--seconds", protocol.seconds, "Seconds for each technique at each level")
        ->check(check_number)
        ->capture_default_str();
    command.add_flag("--passes", protocol.passes, "The time of each pass as well");
    command.add_flag("--stability", protocol.stability, "How much the pictures change while the model turns");
    command.add_flag("--orientation", orientation,
                     "In place of techniques: how ways to tell which faces look at the eye compare");
    command.add_option("--json", json, "JSON file to write, - for standard output");
    command.add_option("--plot", plot, "SVG or PNG file with the ratios over the number of triangles");
    common.add_to(command);
}

std::vector<std::string> techniques_of(const BenchOptions& options, const Renderer& renderer) {
    const std::vector<std::string> names = split(options.techniques, ",");
    if (names.empty()) fail("--techniques: expected names, found \"{}\"", options.techniques);
    return names == std::vector<std::string>{"all"} ? renderer.technique_names() : names;
}

std::vector<std::size_t> parse_triangles(const std::string& text) {
    constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max();  // as meshes count them
    std::vector<std::size_t> counts;
    for (const std::string& word : split(text, ",")) {
        std::size_t count = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), count);
        if (error != std::errc() || end != word.data() + word.size() || count == 0 || count > most) {
            fail("--triangles: expected whole numbers of 1 to {}, found \"{}\"", most, text);
        }
        counts.push_back(count);
    }
    return counts;
}

std::string plot_format(const std::string& path) {
    const std::string ending = fs::path(path).extension().string();
    if (ending != ".svg" && ending != ".png")
        fail("--plot: expected a file that ends in .svg or .png, found \"{}\"", path);
    return ending.substr(1);
}

// What has no meaning in place of techniques.
void check_orientation(const CLI::App& command) {
    for (const char* option : {"--techniques", "--json", "--plot", "--levels", "--passes", "--stability"}) {
        if (command.count(option) > 0) fail("--orientation compares no techniques: it does not go with {}", option);
    }
}

// Seed A's tables 6 to 9: of the model, or of its levels of detail of so many triangles.
int compare_orientations(const BenchOptions& options) {
    const std::string path = options.model.empty() ? built_in_model_path(options.common) : options.model;
    const Model model = options.shape.applied_to(Model::load(path));
    FaceOrientationOptions views;
    views.view.direction = parse_view(options.direction);
    std::vector<std::size_t> counts = parse_triangles(options.triangles);
    if (counts.empty()) counts.push_back(model.triangle_count());
    for (const std::size_t count : counts) {
        print_orientation_table(count < model.triangle_count() ? model.simplified(count) : model, views);
    }
    return 0;
}

int run(const BenchOptions& options) {
    bench::Protocol protocol = options.protocol;
    const Size pixels = parse_size(options.size, "--size");
    protocol.width = pixels.width;
    protocol.height = pixels.height;
    protocol.direction = parse_view(options.direction);
    protocol.triangles = parse_triangles(options.triangles);
    if (!options.plot.empty()) (void)plot_format(options.plot);
    // Refused before anything is measured: what could not be written after it.
    for (const std::string& path : {options.json, options.plot}) {
        if (!path.empty()) check_writable(path);
    }
    Renderer renderer = Renderer::headless(options.common.choice());
    protocol.techniques = techniques_of(options, renderer);
    const std::string path = options.model.empty() ? built_in_model_path(options.common) : options.model;
    const Model model = options.shape.applied_to(Model::load(path, options.texture));
    Progress progress(bench::step_count(protocol));
    const bench::Benchmark result = bench::measure(renderer, model, fs::path(path).filename().string(), protocol,
                                                   [&](const std::string& what) { progress.next(what); });
    progress.clear();
    if (options.json != "-") fmt::print("{}", bench::table(result));
    if (!options.json.empty()) write_file_whole(options.json, bench::json(result));
    if (!options.plot.empty()) write_file_whole(options.plot, bench::ratio_plot(result, plot_format(options.plot)));
    return 0;
}

}  // namespace

void add_bench_command(CLI::App& program, Commands& commands) {
    CLI::App* command = program.add_subcommand("bench", "Measures techniques against the default renderer");
    const auto options = std::make_shared<BenchOptions>();
    options->add_to(*command);
    commands[command] = [options, command] {
        if (!options->orientation) return run(*options);
        check_orientation(*command);
        return compare_orientations(*options);
    };
}

}  // namespace croquis::app
