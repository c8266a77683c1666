#include "viewer/application.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <utility>

#include "base/error.h"
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

}  // namespace

Application::Application(Renderer& renderer, Settings settings)
    : renderer_(renderer),
      settings_(std::move(settings)),
      session_(renderer),
      thumbnails_(renderer),
      variables_(renderer),
      techniques_(renderer.technique_names()) {
    if (is_sample_count(settings_.samples)) session_.set_samples(settings_.samples);
    session_.arrangement().bind_light(settings_.light_stays_with);
    mouse_.set_inertia(settings_.has_inertia);
    add_commands();
    choose_technique(settings_.technique);
    if (!session_.has_technique() && !techniques_.empty()) choose_technique(techniques_.front());
}

Settings Application::settings() const {
    Settings settings = settings_;
    settings.samples = session_.samples();
    settings.light_stays_with = session_.arrangement().light_stays_with();
    if (session_.has_technique()) settings.technique = session_.technique_name();
    return settings;
}

// Whatever goes wrong is told, and told no more once the next deed succeeds.
void Application::act(const std::function<void()>& deed) {
    try {
        deed();
        messages_.mended(Messages::Source::action);
    } catch (const Error& error) {
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
        for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
            if (entry.path().extension() == ".technique") places.push_back(entry.path());
        }
    }
    watch_.watch(places);
}

void Application::reload_files() {
    try {
        session_.reload();
        messages_.mended(Messages::Source::files);
        messages_.mended(Messages::Source::drawing);
    } catch (const Error& error) {
        messages_.tell(Messages::Source::files, error.what());
    }
    techniques_ = renderer_.technique_names();
    thumbnails_.restart();
    variables_.forget_textures();
}

void Application::take_arrival(ModelLoader::Arrival arrival) {
    if (!arrival.error.empty()) {
        messages_.tell(Messages::Source::model, arrival.error);
        return;
    }
    if (arrival.model) {
        messages_.mended(Messages::Source::model);
        if (arrival.path == session_.model_path() && !arrival.texture.empty()) {
            session_.lay_texture(*arrival.model, arrival.texture);
        } else {
            player_.take(arrival.model->animations());
            session_.show(*arrival.model, arrival.path, arrival.texture);
            look_at_whole(View());
        }
        settings_.remember_model(fs::absolute(arrival.path).string());
        thumbnails_.restart();
    }
    if (arrival.small_copy) session_.take_small_copy(*arrival.small_copy);
}

bool Application::poll() {
    if (frame_.width == 0) return true;  // a model is seen in a frame
    bool is_due = messages_.has_stale_note() || (settings_.shows_overlay && overlay_.is_due());
    if (auto arrival = loader_.take()) {
        take_arrival(std::move(*arrival));
        is_due = true;
    }
    if (const auto outcome = recorder_.take()) {
        tell(*outcome);
        is_due = true;
    }
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
    return mouse_.is_coasting() || player_.is_playing() || can_draw_thumbnail() || loader_.is_reading() ||
           recorder_.wants_frame() || session_.is_stale(frame_, Detail::full);
}

bool Application::is_slow() const { return full_milliseconds_ * settings_.least_frame_rate > 1000.0; }

bool Application::is_settling() const { return Clock::now() - moved_at_ < time_to_settle; }

// What moves, or is being tuned, gives up detail where it would not keep up; full detail waits until it has come to
// rest, so that it does not stand in the way of the next drag.
Detail Application::detail() const { return is_slow() && is_settling() ? Detail::reduced : Detail::full; }

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
    if (!session_.is_stale(frame_, detail())) return;
    const Detail asked = detail();
    const auto begun = Clock::now();
    try {
        session_.draw(canvas_, frame_, asked);
        canvas_.finish();
        messages_.mended(Messages::Source::drawing);
    } catch (const Error& error) {
        messages_.tell(Messages::Source::drawing, error.what());
        return;
    }
    const double milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - begun).count();
    if (asked == Detail::full) full_milliseconds_ = milliseconds;
    overlay_.add_frame(milliseconds);
    if (recorder_.is_recording()) recorder_.add(shown_picture());
}

// None of a large model before its smaller copy is there.
bool Application::can_draw_thumbnail() const {
    return thumbnails_.has_work() && session_.model() != nullptr && !loader_.is_busy();
}

// One a frame, and none while the mouse is busy: each may compile shaders.
void Application::draw_thumbnail() {
    if (can_draw_thumbnail() && !is_settling() && !ImGui::IsAnyMouseDown()) thumbnails_.draw_one(session_);
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
    draw_thumbnail();  // before the panels: what they show must last until they are drawn
    show_panels();
    show_picture();
}

// drawing-1.png, drawing-2.png, …: the first that is not there yet.
std::string Application::unused_path(const std::string& ending) const {
    const std::string model = fs::path(session_.model_path()).stem().string();
    std::error_code error;
    for (int number = 1;; ++number) {
        std::string path = fmt::format("{}-{}{}", model.empty() ? "drawing" : model, number, ending);
        if (!fs::exists(path, error) && !recorder_.is_writing(path)) return path;
    }
}

void Application::save_picture(bool has_background) {
    const std::string path = unused_path(".png");
    session_.save_picture(path, frame_, picture_scale_, has_background);
    messages_.note("wrote " + path);
}

Picture Application::shown_picture() const { return {canvas_.size().width, canvas_.size().height, canvas_.pixels()}; }

void Application::record() {
    if (recorder_.is_recording()) return recorder_.stop();
    if (session_.model() == nullptr) fail("expected a model to record, found none");
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
