#include "croquis/renderer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

#include "api/frame.h"
#include "api/handles.h"
#include "api/view_request.h"
#include "base/error.h"
#include "components/register.h"
#include "gpu/state.h"
#include "model/animation.h"

namespace croquis {
namespace {

framework::Light light_in_scene(const Light& light, const model::Model& model) {
    using Scene = framework::Light;
    Scene scene;
    scene.bound = light.bound == Light::Bound::viewer ? Scene::Bound::viewer : Scene::Bound::world;
    scene.kind = light.bound == Light::Bound::point ? Scene::Kind::point : Scene::Kind::direction;
    if (scene.kind == Scene::Kind::point) {
        scene.place = model::SceneSpace::of(model).from_file(finite(light.place, "the light at a finite distance"));
    } else {
        scene.place = finite(light.place, "the light to have a direction");
        if (!(glm::length(scene.place) > 0)) fail("expected the light to have a direction, found 0,0,0");
    }
    scene.color = glm::vec3(finite(light.color, "the light to have a finite colour"));
    return scene;
}

// Pixels along one pixel of the picture for so many samples of it.
int pixel_scale(int samples) {
    for (int side = 1; side <= 4; ++side) {
        if (side * side == samples) return side;
    }
    fail("expected 1, 4, 9 or 16 samples a pixel, found {}", samples);
}

framework::DataFolders find_folders(const std::vector<std::string>& users_own) {
    return framework::DataFolders::find({users_own.begin(), users_own.end()});
}

}  // namespace

struct Renderer::State {
    State(std::unique_ptr<gpu::Context> made, framework::DataFolders folders)
        : context(std::move(made)),
          library(std::make_shared<const framework::Library>(folders)),
          resources(*context, std::move(folders)),
          components(components::core_components()),
          frame(resources) {}
    ~State() { context->make_current(); }  // what the members free is this context's
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    struct Uploaded {
        std::weak_ptr<const model::Model> model;
        std::unique_ptr<framework::Scene> scene;
        std::string animation;
        double time = 0;
    };
    Uploaded& upload(const std::shared_ptr<const model::Model>& model);
    static void pose(Uploaded& uploaded, const DrawOptions& options);

    std::unique_ptr<Technique::Opened> open(const framework::TechniqueDefinition& definition);

    struct Tile {
        std::string name;
        std::shared_ptr<const gpu::Texture> image;
        std::shared_ptr<const gpu::Program> program;
    };
    const Tile& background_tile(const std::string& name);
    framework::Background background(const Background& asked);

    void draw_frame(const std::shared_ptr<const model::Model>& model, framework::Technique& technique,
                    const DrawOptions& options, gpu::StretchTimer* timer);

    std::unique_ptr<gpu::Context> context;
    std::shared_ptr<const framework::Library> library;
    framework::Resources resources;
    framework::ComponentTable components;
    Frame frame;
    std::map<const model::Model*, Uploaded> scenes;
    Tile tile;  // of the last background, for resources forget what nobody holds
};

// Models that nobody but their scene holds any more are dropped from the GPU.
Renderer::State::Uploaded& Renderer::State::upload(const std::shared_ptr<const model::Model>& model) {
    std::erase_if(scenes,
                  [&](const auto& entry) { return entry.first != model.get() && entry.second.model.use_count() <= 1; });
    Uploaded& uploaded = scenes[model.get()];
    if (!uploaded.scene) {
        uploaded.scene = std::make_unique<framework::Scene>(resources, model);
        uploaded.model = model;
    }
    return uploaded;
}

// Vertices are moved only when another moment is asked for.
void Renderer::State::pose(Uploaded& uploaded, const DrawOptions& options) {
    if (uploaded.animation == options.animation && uploaded.time == options.time) return;
    if (options.animation.empty()) {
        uploaded.scene->clear_pose();
    } else {
        const model::Model& model = uploaded.scene->model();
        uploaded.scene->set_pose(model::pose_at(model, model::find_clip(model, options.animation), options.time));
    }
    uploaded.animation = options.animation;
    uploaded.time = options.time;
}

const Renderer::State::Tile& Renderer::State::background_tile(const std::string& name) {
    if (tile.name == name) return tile;
    const framework::TextureName parsed = framework::TextureName::parse(name);
    if (parsed.is_generated) fail("expected an image as the background's texture, found \"{}\"", name);
    tile = {name, resources.image(parsed), resources.program("image:full_screen", "image:tiled")};
    return tile;
}

framework::Background Renderer::State::background(const Background& asked) {
    framework::Background background;
    background.color = glm::vec4(glm::vec3(as_vector(asked.color)), asked.transparent ? 0 : 1);
    if (!asked.texture.empty()) {
        const Tile& known = background_tile(asked.texture);
        background.image = known.image;
        background.tiled = known.program;
    }
    return background;
}

void Renderer::State::draw_frame(const std::shared_ptr<const model::Model>& model, framework::Technique& technique,
                                 const DrawOptions& options, gpu::StretchTimer* timer) {
    const int scale = pixel_scale(options.samples);
    const int longest = context->longest_side() / scale;
    if (options.width < 1 || options.height < 1 || options.width > longest || options.height > longest) {
        fail("expected a size of 1x1 to {}x{} pixels, found {}x{}", longest, longest, options.width, options.height);
    }
    context->make_current();
    Uploaded& uploaded = upload(model);
    pose(uploaded, options);
    framework::Scene& scene = *uploaded.scene;
    frame.resize(options.width, options.height, scale);
    const model::Camera camera = model::place_camera(*model, scene.pose(), view_request(options.view),
                                                     double(options.width) / double(options.height));
    const framework::Light light = light_in_scene(options.light, *model);
    framework::RenderContext render{.resources = resources,
                                    .scene = scene,
                                    .camera = camera,
                                    .light = light,
                                    .frame = frame.target(),
                                    .background = std::nullopt,
                                    .pixel_scale = scale,
                                    .seed = options.seed,
                                    .time = options.time};
    if (options.background) render.background = background(*options.background);
    render.clear_frame(glm::vec3(1.0f));
    render.frame.clear_depth();
    technique.draw(render, timer);
}

Renderer::Renderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

Renderer Renderer::headless(const Choice& choice) {
    framework::DataFolders folders = find_folders(choice.data_folders);
    gpu::ContextOptions options = gpu::ContextOptions::from_environment();
    if (!choice.api.empty()) options.api = gpu::api_named(choice.api);
    if (!choice.device.empty()) options.device = gpu::device_named(choice.device);
    return Renderer(std::make_unique<State>(gpu::Context::headless(options), std::move(folders)));
}

Renderer Renderer::in_current_context(const std::vector<std::string>& data_folders) {
    return Renderer(std::make_unique<State>(gpu::Context::current(), find_folders(data_folders)));
}

RendererInfo Renderer::info() const {
    const gpu::Context& context = *state_->context;
    RendererInfo info{.api = context.api() == gpu::Api::gl ? "OpenGL 3.3" : "OpenGL ES 3.0",
                      .version = context.version(),
                      .renderer = context.renderer(),
                      .platform = context.platform(),
                      .is_software = context.is_software(),
                      .data_folders = {}};
    for (const auto& folder : state_->library->folders().folders()) info.data_folders.push_back(folder.string());
    return info;
}

std::vector<std::string> Renderer::technique_names() const { return state_->library->technique_names(); }

std::vector<std::string> Renderer::texture_names() const { return state_->resources.image_names(); }

Picture Renderer::texture(const std::string& name) const {
    const image::Image image = state_->resources.read_image(framework::TextureName::parse(name));
    std::vector<std::uint8_t> pixels;
    for (const auto& pixel : image.pixels()) pixels.insert(pixels.end(), {pixel.r, pixel.g, pixel.b, pixel.a});
    return Picture(image.width(), image.height(), std::move(pixels));
}

std::unique_ptr<Technique::Opened> Renderer::State::open(const framework::TechniqueDefinition& definition) {
    context->make_current();
    return std::make_unique<Technique::Opened>(*context, library, definition, resources, components);
}

Technique Renderer::open_technique(const std::string& name_or_path, const std::vector<std::string>& settings) {
    framework::TechniqueDefinition definition = state_->library->technique(name_or_path);
    for (const std::string& setting : settings) framework::assign(definition, setting);
    return Technique(state_->open(definition));
}

Technique Renderer::open_technique_text(const std::string& name, const std::string& text) {
    return Technique(state_->open(state_->library->technique_from_text(name, text)));
}

void Renderer::reload() {
    state_->context->make_current();
    state_->library = std::make_shared<const framework::Library>(state_->library->folders());
    state_->resources.forget_files();
    state_->tile = {};
}

Picture Renderer::draw(const Model& model, Technique& technique, const DrawOptions& options) {
    state_->draw_frame(model.model_, technique.opened_->technique, options, nullptr);
    return Picture(options.width, options.height, state_->frame.read());
}

void Renderer::draw_into(unsigned framebuffer, const Model& model, Technique& technique, const DrawOptions& options) {
    state_->context->make_current();
    const gpu::SavedState saved;
    state_->draw_frame(model.model_, technique.opened_->technique, options, nullptr);
    state_->frame.present(framebuffer);
}

std::vector<PassTime> Renderer::time_passes(const Model& model, Technique& technique, const DrawOptions& options) {
    state_->context->make_current();
    gpu::StretchTimer timer(*state_->context);
    state_->draw_frame(model.model_, technique.opened_->technique, options, &timer);
    const std::vector<double> milliseconds = timer.milliseconds();
    const framework::Technique& drawn = technique.opened_->technique;
    const std::vector<std::string> names = drawn.pass_names();
    std::vector<PassTime> times;
    for (std::size_t i = 0; i < names.size(); ++i) {
        times.push_back({names[i], milliseconds[i], drawn.line_count(names[i])});
    }
    return times;
}

double Renderer::time_frames(const Model& model, Technique& technique, const std::vector<DrawOptions>& frames) {
    if (frames.empty()) fail("expected at least 1 frame to time, found 0");
    state_->context->make_current();
    state_->context->finish();
    const auto begun = std::chrono::steady_clock::now();
    for (const DrawOptions& options : frames) {
        state_->draw_frame(model.model_, technique.opened_->technique, options, nullptr);
        state_->frame.resolve();
    }
    state_->context->finish();
    const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - begun;
    return taken.count() / double(frames.size());
}

Renderer::Counts Renderer::counts() const {
    const gpu::Counters& counters = state_->context->counters();
    return {counters.live_objects(),  counters.draws,           counters.read_backs,
            counters.programs_linked, counters.texture_uploads, counters.geometry_uploads};
}

}  // namespace croquis
