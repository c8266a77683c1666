#include "viewer/application.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <exception>
#include <filesystem>
#include <utility>

#include "base/error.h"
#include "base/log.h"
#include "viewer/command_line.h"

namespace croquis::viewer {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr auto time_between_looks = std::chrono::milliseconds(400);
constexpr auto time_to_settle = std::chrono::milliseconds(300);
constexpr std::array image_endings{".png", ".jpg", ".jpeg", ".tga", ".bmp", ".pcx"};

bool is_sample_count(int samples) { return samples == 1 || samples == 4 || samples == 9 || samples == 16; }

std::string ending_of(const std::string& path) {
    std::string ending = fs::path(path).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return ending;
}

// Draws as the window does: by the same API, from the same files.
Renderer::Choice choice_like(const RendererInfo& window) {
    std::vector<std::string> users_own = window.data_folders;
    users_own.pop_back();  // the shipped one
    return {.api = window.api == "OpenGL 3.3" ? "gl" : "gles", .device = {}, .data_folders = std::move(users_own)};
}

}  // namespace

Application::Application(Renderer& renderer, Settings settings, std::function<void()> wake)
    : renderer_(renderer),
      settings_(std::move(settings)),
      session_(renderer),
      loader_(wake),
      painter_(choice_like(renderer.info()), wake),
      full_picture_(painter_, session_),
      thumbnails_(painter_),
      variables_(renderer),
      techniques_(renderer.technique_names()) {
    if (is_sample_count(settings_.samples)) session_.set_samples(settings_.samples);
    session_.arrangement().bind_light(settings_.light_stays_with);
    mouse_.set_inertia(settings_.has_inertia);
    if (settings_.least_frame_rate > 0) full_picture_.set_most_milliseconds(1000.0 / settings_.least_frame_rate);
    add_commands();
    choose_technique(settings_.technique);
    choose_any_technique();
}

// In place of one that cannot be opened, which was told and stays told.
void Application::choose_any_technique() {
    for (std::size_t i = 0; !session_.has_technique() && i < techniques_.size(); ++i) {
        try {
            session_.choose_technique(techniques_[i]);
            watch_files();
        } catch (const std::exception& error) {
            note(error.what());
        }
    }
}

Settings Application::settings() const {
    Settings settings = settings_;
    settings.samples = session_.samples();
    settings.light_stays_with = session_.arrangement().light_stays_with();
    if (session_.has_technique()) settings.technique = session_.technique_name();
    return settings;
}

// Whatever goes wrong is told, want of memory too, and told no more once the next deed succeeds.
void Application::act(const std::function<void()>& deed) {
    try {
        deed();
        messages_.mended(Messages::Source::action);
    } catch (const std::exception& error) {
        messages_.tell(Messages::Source::action, error.what());
    }
}

bool Application::press(std::string_view key) {
    bool is_known = false;
    act([&] { is_known = commands_.press(key); });
    return is_known;
}

bool Application::release(std::string_view key) { return commands_.release(key); }

bool Application::is_model(const std::string& path) {
    const std::vector<std::string> endings = Model::readable_endings();
    return std::find(endings.begin(), endings.end(), ending_of(path)) != endings.end();
}

void Application::open(const std::string& path) {
    const std::string ending = ending_of(path);
    if (ending == ".technique") {
        choose_technique(path);
    } else if (is_model(path)) {
        loader_.start(path, "");
    } else if (std::find(image_endings.begin(), image_endings.end(), ending) != image_endings.end()) {
        act([&] {
            const std::string model = loader_.is_reading() ? loader_.path() : session_.model_path();
            if (model.empty()) fail("{}: expected a model that the image can lie on, found none", path);
            loader_.start(model, path);
        });
    } else {
        act([&] { fail("{}: expected a model, a technique or an image, found \"{}\"", path, ending); });
    }
}

// A file manager has no order for what is dropped together.
void Application::open(std::vector<std::string> paths) {
    std::stable_partition(paths.begin(), paths.end(), is_model);
    for (const std::string& path : paths) open(path);
}

void Application::choose_technique(const std::string& name_or_path) {
    act([&] {
        session_.choose_technique(name_or_path);
        scroll_to_technique_ = true;
        watch_files();
    });
}

void Application::step_technique(int step) {
    if (techniques_.empty()) return;
    const auto found = std::find(techniques_.begin(), techniques_.end(), session_.technique_name());
    const auto count = std::ptrdiff_t(techniques_.size());
    const std::ptrdiff_t at = found == techniques_.end() ? 0 : found - techniques_.begin() + step;
    choose_technique(techniques_[std::size_t((at + count) % count)]);
}

// All that techniques can be made of, for a file that is new may be what one missed; and the folders of techniques that
// were opened by their path, for what they include lies there.
void Application::watch_files() {
    std::vector<fs::path> places;
    for (const std::string& folder : renderer_.info().data_folders) places.emplace_back(folder);
    for (const fs::path technique : session_.chosen_techniques()) {
        if (technique.extension() != ".technique") continue;
        places.push_back(technique);
        std::error_code error;
        const fs::path folder = technique.has_parent_path() ? technique.parent_path() : fs::path(".");
        fs::directory_iterator entry(folder, error);
        for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
            if (entry->path().extension() == ".technique") places.push_back(entry->path());
        }
    }
    watch_.watch(places);
}

void Application::reload_files() {
    try {
        session_.reload();
        messages_.mended(Messages::Source::files);
        messages_.mended(Messages::Source::drawing);
    } catch (const std::exception& error) {
        messages_.tell(Messages::Source::files, error.what());
    }
    techniques_ = renderer_.technique_names();
    choose_any_technique();
    painter_.reload();
    thumbnails_.restart();
    variables_.forget_textures();
}

void Application::take_arrival(ModelLoader::Arrival arrival) {
    if (!arrival.error.empty()) {
        messages_.tell(Messages::Source::model, arrival.error);
        // A bad image does not cost the model that it was to lie on.
        if (!arrival.texture.empty() && arrival.path != session_.model_path()) {
            messages_.tell(Messages::Source::action, arrival.error);
            loader_.start(arrival.path, "");
        }
        return;
    }
    if (arrival.model) {
        messages_.mended(Messages::Source::model);
        if (arrival.path == session_.model_path() && !arrival.texture.empty()) {
            session_.lay_texture(*arrival.model, arrival.texture);
        } else {
            player_.take(arrival.model->animations());
            session_.show(*arrival.model, arrival.path, arrival.texture);
            full_picture_.begin_model();
            look_at_whole(View());
        }
        std::error_code error;  // a working folder that is gone
        const fs::path whole = fs::absolute(arrival.path, error);
        settings_.remember_model(error ? arrival.path : whole.string());
        thumbnails_.restart();
    }
    if (arrival.small_copy) session_.take_small_copy(*arrival.small_copy);
}

void Application::take_delivery(const Painter::Delivery& delivery) {
    switch (delivery.order.purpose.kind) {
        case Painter::Purpose::Kind::small_picture:
            return thumbnails_.take(delivery);
        case Painter::Purpose::Kind::file:
            return act([&] {
                if (!delivery.error.empty()) fail("{}", delivery.error);
                messages_.note("wrote " + delivery.order.purpose.name);
            });
        case Painter::Purpose::Kind::full_picture:
            if (!full_picture_.take(delivery, frame_, session_, canvas_)) return;
            if (!delivery.error.empty()) return messages_.tell(Messages::Source::drawing, delivery.error);
            messages_.mended(Messages::Source::drawing);
            overlay_.add_frame(delivery.milliseconds);
            if (recorder_.is_recording()) recorder_.add(shown_picture());
    }
}

// What other threads have to say. True where something of it shows.
bool Application::take_what_arrived() {
    bool is_due = std::exchange(percent_read_, loader_.percent()) != loader_.percent();
    if (auto arrival = loader_.take()) {
        take_arrival(std::move(*arrival));
        is_due = true;
    }
    if (const auto outcome = recorder_.take()) {
        tell(*outcome);
        is_due = true;
    }
    while (const auto delivery = painter_.take()) {
        take_delivery(*delivery);
        is_due = true;
    }
    if (std::exchange(painters_failure_, painter_.failure()) != painter_.failure()) {
        messages_.note("everything is drawn in the window itself: " + painters_failure_);
        is_due = true;
    }
    return is_due;
}

bool Application::poll() {
    if (frame_.width == 0) return true;  // a model is seen in a frame
    bool is_due = take_what_arrived() || messages_.has_stale_note() || (settings_.shows_overlay && overlay_.is_due());
    order_thumbnail();
    if (Clock::now() - looked_at_files_ >= time_between_looks) {
        looked_at_files_ = Clock::now();
        if (watch_.has_changed()) {
            reload_files();
            is_due = true;
        }
    }
    return is_due;
}

bool Application::is_moving() const { return mouse_.is_dragging() || mouse_.is_coasting() || player_.is_playing(); }

bool Application::wants_frames() const {
    return mouse_.is_coasting() || player_.is_playing() || recorder_.wants_frame() ||
           (full_picture_.is_painters() ? full_picture_.is_due(frame_) : session_.is_stale(frame_, Detail::full));
}

bool Application::is_busy() const { return loader_.is_busy() || painter_.has_work(); }

bool Application::stop(std::chrono::milliseconds patience) {
    recorder_.finish();
    const bool has_loader_ended = loader_.stop(patience);
    return painter_.stop(has_loader_ended ? patience : std::chrono::milliseconds(0)) && has_loader_ended;
}

bool Application::is_settling() const { return Clock::now() - moved_at_ < time_to_settle; }

// What moves, or is being tuned, gives up detail where it would not keep up; full detail waits until it has come to
// rest, so that it does not stand in the way of the next drag. Where there is a painter, that is not for the window,
// which draws nothing at all before there is less to draw.
std::optional<Detail> Application::detail() const {
    const bool is_painters = full_picture_.is_painters();
    if (is_painters && !full_picture_.can_be_reduced()) return std::nullopt;
    return is_painters || (full_picture_.is_slow() && is_settling()) ? Detail::reduced : Detail::full;
}

// The model at rest, whole, in the part of the frame that the panels leave free.
void Application::look_at_whole(View view) {
    if (session_.model() == nullptr) return;
    const double left = settings_.shows_panels ? double(left_) * pixels_a_point_ : 0;
    const double right = settings_.shows_panels ? double(right_) * pixels_a_point_ : 0;
    const int width = std::max(1, frame_.width - int(left + right));
    session_.arrangement().take(*session_.model(), view, {width, frame_.height});
    session_.arrangement().pan(Moves::camera, {0.5 * (right - left), 0}, frame_);
}

void Application::move_by_mouse() {
    const ImGuiIO& io = ImGui::GetIO();
    const bool is_over_drawing = !io.WantCaptureMouse && ImGui::IsMousePosValid();
    MouseState mouse{.position = glm::dvec2(io.MousePos.x, io.MousePos.y) * pixels_a_point_,
                     .is_over_drawing = is_over_drawing,
                     .turns = io.MouseDown[0] && !io.KeyShift && !io.KeyCtrl,
                     .pans = io.MouseDown[1] || io.MouseDown[2] || (io.MouseDown[0] && io.KeyShift),
                     .rolls = io.MouseDown[0] && io.KeyCtrl,
                     .wheel = double(io.MouseWheel),
                     .seconds = double(io.DeltaTime)};
    if (magnifier_.is_held() && mouse.wheel != 0) magnifier_.zoom(std::exchange(mouse.wheel, 0.0));
    mouse_.move(mouse, settings_.moves, frame_, session_);
}

void Application::draw_picture() {
    if (full_picture_.is_painters() && !is_settling()) full_picture_.order(frame_);
    const std::optional<Detail> asked = detail();
    if (!asked || !session_.is_stale(frame_, *asked)) return;
    const auto begun = Clock::now();
    try {
        session_.draw(canvas_, frame_, *asked);
        canvas_.finish();
        messages_.mended(Messages::Source::drawing);
    } catch (const std::exception& error) {
        messages_.tell(Messages::Source::drawing, error.what());
        return;
    }
    const double milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - begun).count();
    if (asked == Detail::full) full_picture_.measured(milliseconds);
    overlay_.add_frame(milliseconds);
    if (recorder_.is_recording()) recorder_.add(shown_picture());
}

// One at a time, and none while something moves: the painter takes a core. None of a large model before its smaller
// copy is there.
void Application::order_thumbnail() {
    if (loader_.is_busy() || !full_picture_.can_be_reduced()) return;
    if (painter_.has_work() || is_settling() || ImGui::IsAnyMouseDown()) return;
    thumbnails_.order_one(session_);
}

// Only what the panels leave free: to blend is what the user interface costs on a software renderer.
void Application::show_picture() const {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float low = settings_.shows_panels ? left_ : 0;
    const float high = display.x - (settings_.shows_panels ? right_ : 0);
    ImGui::GetBackgroundDrawList()->AddImage(texture_id(canvas_.texture()), ImVec2(low, 0), ImVec2(high, display.y),
                                             ImVec2(low / display.x, 1), ImVec2(high / display.x, 0));
}

void Application::frame(FrameSize pixels) {
    const ImGuiIO& io = ImGui::GetIO();
    pixels_a_point_ = double(pixels.width) / double(io.DisplaySize.x);
    frame_ = pixels;
    if (player_.is_playing()) {
        player_.advance(double(io.DeltaTime));
        session_.set_moment(player_.clip(), player_.seconds());
    }
    move_by_mouse();
    const bool is_tuning = ImGui::IsAnyItemActive() && !io.WantTextInput;
    if (is_moving() || io.MouseWheel != 0 || is_tuning) moved_at_ = Clock::now();
    draw_picture();
    show_panels();
    show_picture();
}

// drawing-1.png, drawing-2.png, …: the first that is not there yet, and not on its way.
std::string Application::unused_path(const std::string& ending) const {
    const std::string model = fs::path(session_.model_path()).stem().string();
    std::error_code error;
    for (int number = 1;; ++number) {
        std::string path = fmt::format("{}-{}{}", model.empty() ? "drawing" : model, number, ending);
        const bool is_on_its_way =
            recorder_.is_writing(path) || painter_.has_order({Painter::Purpose::Kind::file, path});
        if (!fs::exists(path, error) && !is_on_its_way) return path;
    }
}

void Application::save_picture(bool has_background) {
    const std::string path = unused_path(".png");
    const DrawOptions options = session_.picture_options(frame_, picture_scale_, has_background);
    if (full_picture_.is_painters()) {
        painter_.order(session_.order({Painter::Purpose::Kind::file, path}, options));
        return messages_.note("drawing " + path);
    }
    session_.save_picture(path, options);
    messages_.note("wrote " + path);
}

Picture Application::shown_picture() const { return {canvas_.size().width, canvas_.size().height, canvas_.pixels()}; }

void Application::record() {
    if (recorder_.is_recording()) return recorder_.stop();
    if (!canvas_.has_picture()) fail("expected a picture to record, found none yet");
    recorder_.start(unused_path(settings_.video), shown_picture());
}

void Application::tell(const Recorder::Outcome& outcome) {
    if (outcome.error.empty())
        messages_.note("wrote " + outcome.path);
    else
        messages_.tell(Messages::Source::action, outcome.error);
}

void Application::paste_camera() {
    const char* text = ImGui::GetClipboardText();
    View view = session_.arrangement().view();
    Light light = session_.arrangement().light();
    read_camera_and_light(text != nullptr ? text : "", view, light);
    session_.arrangement().place(view);
    session_.arrangement().set_light(light);
}

}  // namespace croquis::viewer
