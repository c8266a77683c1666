// The registry: every command of the viewer with its keys. Help screen and menu are made from it.
#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <utility>

#include "viewer/application.h"
#include "viewer/command_line.h"

namespace croquis::viewer {
namespace {

constexpr double radians_per_degree = 3.14159265358979323846 / 180.0;
constexpr double roll_step = 15 * radians_per_degree;
constexpr double zoom_step = 1.25;

}  // namespace

void Application::add_commands() {
    add_view_commands();
    add_motion_commands();
    add_technique_commands();
    add_file_commands();
}

void Application::add_view_commands() {
    commands_.add({"Window",
                   "Help",
                   {"F1", "H"},
                   "This screen.",
                   [this] { shows_help_ = !shows_help_; },
                   [this] { return shows_help_; }});
    commands_.add(
        {"Window", "Back", {"Escape"}, "Closes this screen and other questions, and takes note of a mistake.", [this] {
             shows_help_ = asks_where_to_save_ = false;
             messages_.close();
         }});
    commands_.add({"Window",
                   "Panels",
                   {"Tab"},
                   "Hides all panels or shows them again.",
                   [this] { settings_.shows_panels = !settings_.shows_panels; },
                   [this] { return settings_.shows_panels; }});
    commands_.add({"Window",
                   "Figures",
                   {"F2"},
                   "What a drawing costs: time a pass, triangles, the last drawings.",
                   [this] { settings_.shows_overlay = !settings_.shows_overlay; },
                   [this] { return settings_.shows_overlay; }});
    commands_.add({"Window",
                   "Magnifier",
                   {"M"},
                   "A lens at the mouse while the key is held; the wheel sets how strong.",
                   [this] { magnifier_.hold(); },
                   [this] { return magnifier_.is_held(); },
                   [this] { magnifier_.release(); }});
    commands_.add({"Window",
                   "Shape of the lens",
                   {"Shift+M"},
                   "The magnifier round, square, or a sphere that shows more at its rim, in turn.",
                   [this] { magnifier_.take_next_shape(); }});
    commands_.add({"Window", "Close", {"Ctrl+Q"}, "Ends the program.", [this] { wants_to_close_ = true; }});
}

void Application::add_motion_commands() {
    constexpr std::array<const char*, 7> views{"front", "back", "left", "right", "top", "bottom", "iso"};
    for (std::size_t i = 0; i < views.size(); ++i) {
        commands_.add({"Looking",
                       fmt::format("View {}", views[i]),
                       {fmt::format("{}", i + 1)},
                       "The whole model at rest from this side.",
                       [this, name = views[i]] {
                           View view = View::named(name);
                           const Arrangement& arrangement = std::as_const(session_).arrangement();
                           view.parallel = arrangement.is_parallel();
                           view.field_of_view = arrangement.field_of_view();
                           look_at_whole(view);
                       }});
    }
    commands_.add(
        {"Looking", "First view", {"R", "Home"}, "As a model is seen first.", [this] { look_at_whole(View()); }});
    commands_.add({"Looking",
                   "Parallel",
                   {"P"},
                   "Parallel projection in place of perspective.",
                   [this] { session_.arrangement().set_parallel(!session_.arrangement().is_parallel()); },
                   [this] { return std::as_const(session_).arrangement().is_parallel(); }});
    commands_.add({"Looking", "Nearer", {"+", "=", "Shift+="}, "Zooms to the middle.", [this] {
                       session_.arrangement().zoom(zoom_step, {0.5 * frame_.width, 0.5 * frame_.height}, frame_);
                   }});
    commands_.add({"Looking", "Farther", {"-"}, "Zooms from the middle.", [this] {
                       session_.arrangement().zoom(1 / zoom_step, {0.5 * frame_.width, 0.5 * frame_.height}, frame_);
                   }});
    const auto add_choice = [this](const char* name, const char* key, const char* help, Moves moves) {
        commands_.add({"Moving",
                       name,
                       {key},
                       help,
                       [this, moves] { settings_.moves = moves; },
                       [this, moves] { return settings_.moves == moves; }});
    };
    add_choice("Move the object", "O", "The mouse turns and moves the object before the camera.", Moves::object);
    add_choice("Move the camera", "C", "The mouse moves the camera around what it looks at.", Moves::camera);
    add_choice("Move the light", "L", "The mouse moves the light around the object.", Moves::light);
    commands_.add({"Moving", "Roll left", {"Q"}, "Turns by 15 degrees about the line of sight.", [this] {
                       session_.arrangement().roll(settings_.moves, roll_step);
                   }});
    commands_.add({"Moving", "Roll right", {"E"}, "The same the other way.", [this] {
                       session_.arrangement().roll(settings_.moves, -roll_step);
                   }});
    commands_.add({"Moving",
                   "Inertia",
                   {"I"},
                   "What is let go of goes on turning for a while.",
                   [this] { mouse_.set_inertia(settings_.has_inertia = !settings_.has_inertia); },
                   [this] { return settings_.has_inertia; }});
    commands_.add({"Moving",
                   "Play",
                   {"Space"},
                   "Plays the model's animation, or pauses it.",
                   [this] { player_.set_playing(!player_.is_playing()); },
                   [this] { return player_.is_playing(); }});
}

void Application::add_technique_commands() {
    commands_.add({"Technique", "Next technique", {"Down"}, "The next of the list; camera and light stay.", [this] {
                       step_technique(1);
                   }});
    commands_.add({"Technique", "Previous technique", {"Up"}, "The one before.", [this] { step_technique(-1); }});
    commands_.add({"Technique", "Search", {"Ctrl+F"}, "Shows the techniques alone whose names hold a text.", [this] {
                       settings_.shows_panels = true;
                       searched_.clear();
                       wants_search_ = true;
                   }});
    commands_.add({"Technique", "Reset values", {"Backspace"}, "All variables as the technique has them.", [this] {
                       session_.reset_all();
                   }});
    commands_.add({"Technique",
                   "Wireframe",
                   {"W"},
                   "Every edge of the mesh over the drawing.",
                   [this] { session_.set_wireframe(!session_.has_wireframe()); },
                   [this] { return session_.has_wireframe(); }});
    commands_.add({"Technique", "Save as technique", {"Ctrl+S"}, "Writes a .technique file that draws as now.", [this] {
                       asks_where_to_save_ = true;
                   }});
    commands_.add(
        {"Technique", "Reload", {"Ctrl+R"}, "Reads all files anew. Changed files are noticed without it.", [this] {
             reload_files();
         }});
}

void Application::add_file_commands() {
    commands_.add(
        {"Pictures", "Picture", {"F12"}, "Writes the drawing to a PNG beside where the program was started.", [this] {
             save_picture(true);
         }});
    commands_.add({"Pictures",
                   "Picture without background",
                   {"Shift+F12"},
                   "The same, transparent where nothing is drawn.",
                   [this] { save_picture(false); }});
    commands_.add({"Pictures",
                   "Record",
                   {"F11"},
                   "Records the drawing to a video beside the pictures, until this key again.",
                   [this] { record(); },
                   [this] { return recorder_.is_recording(); }});
    commands_.add(
        {"Pictures", "Copy the command", {"Ctrl+C"}, "Copies the command that draws this picture to a file.", [this] {
             ImGui::SetClipboardText(session_.command_line(frame_).c_str());
             messages_.note("copied the command");
         }});
    commands_.add({"Pictures", "Copy camera and light", {"Ctrl+Shift+C"}, "Copies them as text.", [this] {
                       const Arrangement& arrangement = std::as_const(session_).arrangement();
                       ImGui::SetClipboardText(camera_and_light(arrangement.view(), arrangement.light()).c_str());
                       messages_.note("copied camera and light");
                   }});
    commands_.add(
        {"Pictures", "Paste camera and light", {"Ctrl+V"}, "Takes them from such a text, or from a command.", [this] {
             paste_camera();
         }});
}

}  // namespace croquis::viewer
