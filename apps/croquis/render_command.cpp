// croquis render: models to pictures.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "base/error.h"
#include "base/names.h"
#include "built_in_model.h"
#include "commands.h"
#include "parse.h"
#include "progress.h"
#include "shape_options.h"
#include "view_options.h"

namespace croquis::app {
namespace {

namespace fs = std::filesystem;

constexpr int exit_different = 1;

struct RenderOptions {
    Common common;
    std::string model;
    std::string input_folder;
    std::string technique = "cartoon";
    std::vector<std::string> settings;
    std::string size = "1024x768";
    ViewOptions view;
    std::string light;
    std::string light_color = "white";
    std::string background;
    int samples = 1;
    std::string texture;
    ShapeOptions shape;
    std::uint64_t seed = 0;
    std::string output;
    std::string reference;
    std::string threshold = "0.5";
    bool list_passes = false;

    void add_to(CLI::App& command);
    [[nodiscard]] DrawOptions draw_options() const;
};

void RenderOptions::add_to(CLI::App& command) {
    command.add_option("model", model, "Model file; a built-in teapot where none is named");
    command.add_option(
        "-o,--output", output,
        "PNG to write, - for standard output; MODEL.png where none is named. With --input-dir: a folder");
    command.add_option("-t,--technique", technique, "Name of a technique, or path of a .technique file")
        ->capture_default_str();
    command.add_option("--set", settings,
                       "pass.variable=value, as often as needed; croquis describe TECHNIQUE lists them");
    command.add_option("--input-dir", input_folder, "Draw every model file of a folder");
    command.add_option("--size", size, "Pixels, WIDTHxHEIGHT")->capture_default_str();
    view.add_to(command);
    command.add_option("--light", light,
                       "Direction to the light X,Y,Z in the world; viewer:X,Y,Z along the camera's right, up, back; "
                       "point:X,Y,Z a position");
    command.add_option("--light-color", light_color, "R,G,B, #RRGGBB or a name")->capture_default_str();
    command.add_option("--background", background,
                       "R,G,B, #RRGGBB, a name, transparent, or an image as directory:image (paper:plain)");
    command.add_option("--samples", samples, "Samples a pixel: 1, 4, 9 or 16")
        ->check(check_whole_number)
        ->capture_default_str();
    command.add_option("--texture", texture, "Image for all surfaces in place of the materials' own");
    shape.add_simplification_to(command);
    shape.add_subdivision_to(command);
    command.add_option("--seed", seed, "Seed of everything random")->check(check_whole_number)->capture_default_str();
    command.add_option("--reference", reference, "Picture to compare with; exit status 1 when it differs");
    command.add_option("--threshold", threshold, "Largest mean difference, or MEAN,MAXIMUM, in levels of 0 to 255")
        ->capture_default_str();
    command.add_flag("--list-passes", list_passes, "Print the passes, each with its time");
    common.add_to(command);
}

DrawOptions RenderOptions::draw_options() const {
    DrawOptions options;
    const Size pixels = parse_size(size, "--size");
    options.width = pixels.width;
    options.height = pixels.height;
    options.samples = samples;
    options.view = view.view();
    if (!light.empty()) options.light = parse_light(light);
    options.light.color = parse_color(light_color, "--light-color");
    if (!background.empty()) options.background = parse_background(background);
    options.animation = view.animation;
    options.time = view.time;
    options.seed = seed;
    return options;
}

// One model to draw and where its picture goes; no output where it is only compared.
struct Job {
    std::string model;
    std::string output;
};

std::vector<Job> single_job(const RenderOptions& options) {
    Job job{options.model.empty() ? built_in_model_path(options.common) : options.model, options.output};
    const bool only_compares = !options.reference.empty() || options.list_passes;
    if (job.output.empty() && !only_compares) job.output = fs::path(job.model).stem().string() + ".png";
    return {job};
}

bool is_readable(const fs::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    const std::vector<std::string> endings = Model::readable_endings();
    return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

std::vector<Job> folder_jobs(const RenderOptions& options) {
    if (!options.model.empty()) fail("expected a model or --input-dir, found both");
    if (!options.reference.empty()) fail("--reference compares one picture: it does not go with --input-dir");
    std::error_code error;
    if (!fs::is_directory(options.input_folder, error)) fail("{}: no such folder", options.input_folder);
    const fs::path output = options.output.empty() ? fs::path(".") : fs::path(options.output);
    if (!fs::is_directory(output, error))
        fail("{}: expected a folder for the pictures of --input-dir", output.string());
    std::vector<fs::path> models;
    for (const fs::directory_entry& entry : fs::directory_iterator(options.input_folder, error)) {
        if (entry.is_regular_file(error) && is_readable(entry.path())) models.push_back(entry.path());
    }
    if (models.empty()) fail("{}: no model file in this folder", options.input_folder);
    std::sort(models.begin(), models.end());
    std::vector<Job> jobs;
    for (const fs::path& model : models) {
        // Two models of one stem keep their endings, so that neither picture replaces the other.
        const auto same_stem = std::count_if(models.begin(), models.end(),
                                             [&](const fs::path& other) { return other.stem() == model.stem(); });
        const fs::path name = same_stem > 1 ? model.filename() : model.stem();
        jobs.push_back({model.string(), (output / name).string() + ".png"});
    }
    return jobs;
}

void print_passes(Renderer& renderer, const Model& model, Technique& technique, const DrawOptions& draw) {
    (void)renderer.time_passes(model, technique, draw);  // the first frame compiles and uploads
    double sum = 0;
    for (const PassTime& time : renderer.time_passes(model, technique, draw)) {
        fmt::print("{:9.3f} ms  {}\n", time.milliseconds, time.pass);
        sum += time.milliseconds;
    }
    fmt::print("{:9.3f} ms  all passes\n", sum);
}

// True when the picture is within the threshold of the reference.
bool matches_reference(const Picture& picture, const RenderOptions& options) {
    const Picture::Difference allowed = parse_threshold(options.threshold);
    const Picture::Difference found = picture.difference_from(Picture::read(options.reference));
    if (found.mean <= allowed.mean && found.maximum <= allowed.maximum) return true;
    complain(fmt::format("{}: the picture differs: mean {:.3f}, maximum {} (allowed: mean {}, maximum {})",
                         options.reference, found.mean, found.maximum, allowed.mean, allowed.maximum));
    return false;
}

int run(const RenderOptions& options) {
    const DrawOptions draw = options.draw_options();
    (void)parse_threshold(options.threshold);
    const std::vector<Job> jobs = options.input_folder.empty() ? single_job(options) : folder_jobs(options);
    Renderer renderer = Renderer::headless(options.common.choice());
    Technique technique = renderer.open_technique(options.technique, options.settings);
    Progress progress(jobs.size());
    int failures = 0;
    bool all_match = true;
    for (const Job& job : jobs) {
        progress.next(job.model);
        try {
            const Model model = options.shape.applied_to(Model::load(job.model, options.texture));
            const Picture picture = renderer.draw(model, technique, draw);
            if (!options.reference.empty()) all_match = matches_reference(picture, options) && all_match;
            if (!job.output.empty()) picture.save(job.output);
            if (!job.output.empty() && job.output != "-") report("wrote " + job.output);
            if (options.list_passes) print_passes(renderer, model, technique, draw);
        } catch (const Error& error) {
            if (jobs.size() == 1) throw;
            complain(error.what());  // the other models are drawn all the same
            ++failures;
        }
    }
    if (failures > 0) fail("{} of {} models could not be drawn", failures, jobs.size());
    return all_match ? 0 : exit_different;
}

}  // namespace

void add_render_command(CLI::App& program, Commands& commands) {
    CLI::App* command = program.add_subcommand("render", "Draws models to PNG pictures");
    const auto options = std::make_shared<RenderOptions>();
    options->add_to(*command);
    commands[command] = [options] { return run(*options); };
}

}  // namespace croquis::app
