// The viewer without its window: what is shown, what the mouse, keys and dropped files do. A window, or a test, gives
// it events by ImGui's IO and by `press`, and calls `frame` between ImGui::NewFrame and ImGui::Render.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/animation_player.h"
#include "viewer/commands.h"
#include "viewer/file_watch.h"
#include "viewer/full_picture.h"
#include "viewer/magnifier.h"
#include "viewer/messages.h"
#include "viewer/model_loader.h"
#include "viewer/mouse.h"
#include "viewer/overlay.h"
#include "viewer/painter.h"
#include "viewer/recorder.h"
#include "viewer/session.h"
#include "viewer/settings.h"
#include "viewer/technique_panel.h"
#include "viewer/variables_panel.h"

namespace croquis::viewer {

class Application {
public:
    /// `renderer` draws in the context that is current, which must stay so. `wake` is called, on another thread, when
    /// something was read or drawn there: `poll` takes it.
    Application(
        Renderer& renderer, Settings settings, std::function<void()> wake = [] {});

    /// Opens a file by its ending: a model, a technique, or an image as texture of the model that is shown. Anything
    /// else, and whatever is wrong with it, is told in the window.
    void open(const std::string& path);
    /// The same of several, models before the images that are to lie on them.
    void open(std::vector<std::string> paths);

    /// Whether `open` takes the file for a model.
    [[nodiscard]] static bool is_model(const std::string& path);

    /// A key, as the registry of commands names it: "Ctrl+S". False where none has it.
    bool press(std::string_view key);
    bool release(std::string_view key);

    /// Draws what changed and shows the panels, in a window that is cleared to ImGuiCol_WindowBg. `pixels` is the size
    /// of the picture, `ImGui::GetIO().DisplaySize` that of the window in points.
    void frame(FrameSize pixels);

    /// Looks for models that were read and files that changed. True when a frame is due.
    [[nodiscard]] bool poll();
    /// True while frames are due without anybody doing anything: something moves, or is still being made.
    [[nodiscard]] bool wants_frames() const;
    [[nodiscard]] bool wants_to_close() const { return wants_to_close_; }
    /// True while something is being read or drawn on other threads.
    [[nodiscard]] bool is_busy() const;
    /// Cancels what other threads do, but for pictures that are being written. False where they still run after so
    /// long; then only the end of the program ends them: without `stop` the destructor waits.
    [[nodiscard]] bool stop(std::chrono::milliseconds patience);

    /// What to remember.
    [[nodiscard]] Settings settings() const;

    [[nodiscard]] Session& session() { return session_; }
    [[nodiscard]] Canvas& canvas() { return canvas_; }
    [[nodiscard]] const Commands& commands() const { return commands_; }
    [[nodiscard]] const Messages& messages() const { return messages_; }
    [[nodiscard]] const ModelLoader& loader() const { return loader_; }

private:
    // application_commands.cpp
    void add_commands();
    void add_view_commands();
    void add_motion_commands();
    void add_technique_commands();
    void add_file_commands();

    void act(const std::function<void()>& deed);
    void choose_technique(const std::string& name_or_path);
    void choose_any_technique();
    void step_technique(int step);
    void watch_files();
    void reload_files();
    void take_arrival(ModelLoader::Arrival arrival);
    void take_delivery(const Painter::Delivery& delivery);
    [[nodiscard]] bool take_what_arrived();
    [[nodiscard]] std::string unused_path(const std::string& ending) const;
    void save_picture(bool has_background);
    [[nodiscard]] Picture shown_picture() const;
    void record();
    void tell(const Recorder::Outcome& outcome);
    void paste_camera();

    void look_at_whole(View view);
    void move_by_mouse();
    void draw_picture();
    void show_picture() const;
    void order_thumbnail();
    [[nodiscard]] bool is_moving() const;
    [[nodiscard]] bool is_settling() const;
    [[nodiscard]] std::optional<Detail> detail() const;

    // application_panels.cpp
    void show_panels();
    void show_technique_panel(float width);
    void show_tuning_panel(float width);
    void show_view_settings();
    void show_menu();
    void show_animation();
    void show_reading();
    void show_drawing(float right);
    void show_save_dialogue();

    Renderer& renderer_;
    Settings settings_;
    Session session_;
    Canvas canvas_;
    Commands commands_;
    Messages messages_;
    ModelLoader loader_;
    Painter painter_;
    FullPicture full_picture_;
    FileWatch watch_;
    std::chrono::steady_clock::time_point looked_at_files_;
    Mouse mouse_;
    AnimationPlayer player_;
    Magnifier magnifier_;
    Thumbnails thumbnails_;
    VariablesPanel variables_;
    Overlay overlay_;
    Recorder recorder_;

    FrameSize frame_{0, 0};  // in pixels; nothing before the first frame
    double pixels_a_point_ = 1;
    float left_ = 0, right_ = 0;  // widths of the panels, in points
    std::vector<std::string> techniques_;
    bool scroll_to_technique_ = true;
    std::string searched_;  // part of the names in the list of techniques
    bool wants_search_ = false;
    bool shows_help_ = false;
    bool asks_where_to_save_ = false;
    std::string save_path_;
    std::string saved_technique_;    // for which the path was suggested
    std::set<std::string> written_;  // techniques: those may be replaced unasked
    std::chrono::steady_clock::time_point moved_at_;
    int percent_read_ = 0;          // that was shown
    std::string painters_failure_;  // that was told
    int picture_scale_ = 1;         // of pictures that are written
    bool wants_to_close_ = false;
};

}  // namespace croquis::viewer
