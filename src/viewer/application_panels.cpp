// Where the viewer's panels stand and what is in them.
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <utility>

#include "video/video_writer.h"
#include "viewer/appearance.h"
#include "viewer/application.h"
#include "viewer/help_screen.h"

namespace croquis::viewer {
namespace {

// Their background is the colour that the window was cleared to: to blend another over it costs a software renderer
// milliseconds.
constexpr ImGuiWindowFlags fixed_panel = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                         ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoTitleBar |
                                         ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav;

constexpr std::array sample_counts{1, 4, 9, 16};

constexpr const char* save_dialogue = "save as technique";

// A button beside the last one where there is room for it, else below.
bool next_button(const char* label) {
    const float width = ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x;
    const float end = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    if (ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + width <= end) ImGui::SameLine();
    return ImGui::Button(label);
}

}  // namespace

void Application::show_panels() {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float line = ImGui::GetFontSize();
    // A narrow window keeps its middle free. In whole pixels: nobody draws what neither panel nor picture covers.
    left_ = std::floor(std::min(17 * line, 0.3f * display.x));
    right_ = std::floor(std::min(23 * line, 0.38f * display.x));
    if (settings_.shows_panels) {
        show_technique_panel(left_);
        show_tuning_panel(right_);
        if (player_.has_clips()) show_animation();
    }
    recorder_.show((settings_.shows_panels ? left_ : 0) + 0.5f * line, 0.5f * line);
    if (full_picture_.is_awaited()) show_drawing(settings_.shows_panels ? right_ : 0);
    if (loader_.is_reading()) show_reading();
    if (asks_where_to_save_ || ImGui::IsPopupOpen(save_dialogue)) show_save_dialogue();
    const float low = settings_.shows_panels ? left_ : 0, high = display.x - (settings_.shows_panels ? right_ : 0);
    if (settings_.shows_overlay) overlay_.show(low, high, session_, renderer_, frame_, detail());
    messages_.show(low, high);
    if (shows_help_) show_help_screen(commands_, shows_help_);
    magnifier_.show(canvas_, pixels_a_point_);
}

void Application::show_technique_panel(float width) {
    ImGui::SetNextWindowPos(ImVec2(0, 0));
    ImGui::SetNextWindowSize(ImVec2(width, ImGui::GetIO().DisplaySize.y));
    ImGui::Begin("techniques", nullptr, fixed_panel);
    show_menu();
    if (std::exchange(wants_search_, false)) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1);
    const bool is_entered =
        ImGui::InputTextWithHint("##search", "search (Ctrl+F)", &searched_, ImGuiInputTextFlags_EnterReturnsTrue);
    ImGui::BeginChild("list");
    std::vector<std::string> found;
    std::copy_if(techniques_.begin(), techniques_.end(), std::back_inserter(found),
                 [this](const std::string& name) { return name.find(searched_) != std::string::npos; });
    if (found.empty()) ImGui::TextDisabled("no such technique");
    if (is_entered && !found.empty()) {
        choose_technique(found.front());
        searched_.clear();
    }
    const auto clicked = show_techniques(found, session_, thumbnails_, std::exchange(scroll_to_technique_, false));
    if (clicked) {
        choose_technique(*clicked);
        scroll_to_technique_ = false;  // it is in sight
    }
    ImGui::EndChild();
    ImGui::End();
}

// Commands by their groups, and recent models.
void Application::show_menu() {
    if (ImGui::Button("menu")) ImGui::OpenPopup("menu");
    if (next_button("help (F1)")) shows_help_ = true;
    if (!ImGui::BeginPopup("menu")) return;
    if (ImGui::BeginMenu("Recent models", !settings_.recent_models.empty())) {
        for (const std::string& model : std::vector(settings_.recent_models)) {
            if (ImGui::MenuItem(model.c_str())) open(model);
        }
        ImGui::EndMenu();
    }
    for (const std::string& group : commands_.groups()) {
        if (!ImGui::BeginMenu(group.c_str())) continue;
        for (const Command& command : commands_.all()) {
            if (command.group != group || command.release) continue;  // what is held has a key alone
            const bool is_on = command.is_on && command.is_on();
            if (ImGui::MenuItem(command.name.c_str(), command.keys.front().c_str(), is_on)) act(command.run);
        }
        ImGui::EndMenu();
    }
    ImGui::EndPopup();
}

void Application::show_tuning_panel(float width) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(display.x - width, 0));
    ImGui::SetNextWindowSize(ImVec2(width, display.y));
    ImGui::Begin("tuning", nullptr, fixed_panel);
    ImGui::TextUnformatted(session_.technique_name().c_str());
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextWrapped("%s", session_.technique_help().c_str());
    ImGui::PopStyleColor();
    if (ImGui::Button("save as technique")) asks_where_to_save_ = true;
    if (next_button("copy command")) act([this] { commands_.run("Copy the command"); });
    ImGui::BeginChild("variables");
    if (ImGui::CollapsingHeader("view and light")) show_view_settings();
    if (session_.has_technique()) variables_.show(session_, messages_);
    ImGui::EndChild();
    ImGui::End();
}

void Application::show_view_settings() {
    const Arrangement& arrangement = std::as_const(session_).arrangement();
    ImGui::PushID("view");
    ImGui::TextUnformatted("the mouse moves");
    int moves = int(settings_.moves);
    const bool is_other = ImGui::RadioButton("object", &moves, int(Moves::object));
    ImGui::SameLine();
    const bool is_camera = ImGui::RadioButton("camera", &moves, int(Moves::camera));
    ImGui::SameLine();
    const bool is_light = ImGui::RadioButton("light", &moves, int(Moves::light));
    if (is_other || is_camera || is_light) settings_.moves = Moves(moves);
    ImGui::PopID();

    ImGui::PushID("light");
    ImGui::TextUnformatted("the light stays with");
    int stays = int(arrangement.light_stays_with());
    bool is_changed = ImGui::RadioButton("viewer", &stays, int(LightStaysWith::viewer));
    ImGui::SameLine();
    is_changed = ImGui::RadioButton("object", &stays, int(LightStaysWith::object)) || is_changed;
    ImGui::SameLine();
    is_changed = ImGui::RadioButton("world", &stays, int(LightStaysWith::world)) || is_changed;
    if (is_changed) session_.arrangement().bind_light(LightStaysWith(stays));
    ImGui::PopID();

    bool is_parallel = arrangement.is_parallel();
    if (ImGui::Checkbox("parallel projection", &is_parallel)) session_.arrangement().set_parallel(is_parallel);
    float degrees = float(arrangement.field_of_view());
    if (ImGui::SliderFloat("field of view", &degrees, 5, 120, "%.0f°", ImGuiSliderFlags_AlwaysClamp)) {
        session_.arrangement().set_field_of_view(double(degrees));
    }
    if (ImGui::BeginCombo("samples", fmt::format("{}", session_.samples()).c_str())) {
        for (const int count : sample_counts) {
            if (ImGui::Selectable(fmt::format("{}", count).c_str(), count == session_.samples())) {
                session_.set_samples(count);
            }
        }
        ImGui::EndCombo();
    }
    ImGui::SliderInt("picture scale", &picture_scale_, 1, 8, "%d x", ImGuiSliderFlags_AlwaysClamp);
    if (ImGui::BeginCombo("video", settings_.video.c_str())) {
        for (const char* ending : video::video_endings) {
            if (ImGui::Selectable(ending, ending == settings_.video)) settings_.video = ending;
        }
        ImGui::EndCombo();
    }
    bool has_background = session_.background().has_value();
    std::array<float, 3> color{1, 1, 1};
    if (has_background) {
        std::transform(session_.background()->color.begin(), session_.background()->color.end(), color.begin(),
                       [](double c) { return float(c); });
    }
    bool is_other_background = ImGui::Checkbox("background", &has_background);
    ImGui::SameLine();
    is_other_background =
        ImGui::ColorEdit3("##background", color.data(), ImGuiColorEditFlags_NoInputs) || is_other_background;
    if (is_other_background) {
        const Background chosen{
            .color = {double(color[0]), double(color[1]), double(color[2])}, .transparent = false, .texture = {}};
        session_.set_background(has_background ? std::optional(chosen) : std::nullopt);
    }
}

void Application::show_animation() {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(0.5f * display.x, 0.5f * ImGui::GetFontSize()), ImGuiCond_Always, ImVec2(0.5f, 0));
    ImGui::Begin("animation", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoNav);
    if (player_.show()) session_.set_moment(player_.clip(), player_.seconds());
    ImGui::End();
}

void Application::show_reading() {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(0.5f * display.x, 0.5f * display.y), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    ImGui::Begin("reading", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoNav);
    const std::string name = std::filesystem::path(loader_.path()).filename().string();
    ImGui::Text("reading %s", name.c_str());
    ImGui::ProgressBar(float(loader_.percent()) / 100, ImVec2(14 * ImGui::GetFontSize(), 0));
    if (ImGui::Button("cancel")) loader_.cancel();
    ImGui::End();
}

// In a corner: meanwhile the picture can be turned in less detail.
void Application::show_drawing(float right) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float line = ImGui::GetFontSize();
    ImGui::SetNextWindowPos(ImVec2(display.x - right - 0.5f * line, display.y - 0.5f * line), ImGuiCond_Always,
                            ImVec2(1, 1));
    ImGui::Begin("drawing", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::Text("drawing %zu triangles", session_.model()->triangle_count());
    ImGui::End();
}

void Application::show_save_dialogue() {
    if (!ImGui::IsPopupOpen(save_dialogue)) {
        if (std::exchange(saved_technique_, session_.technique_name()) != session_.technique_name()) {
            save_path_ = "my_" + std::filesystem::path(session_.technique_name()).stem().string() + ".technique";
        }
        ImGui::OpenPopup(save_dialogue);
    }
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(0.5f * display.x, 0.5f * display.y), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    if (!ImGui::BeginPopupModal(save_dialogue, &asks_where_to_save_, ImGuiWindowFlags_AlwaysAutoResize)) return;
    ImGui::SetNextItemWidth(26 * ImGui::GetFontSize());
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    const bool is_entered = ImGui::InputText("##path", &save_path_, ImGuiInputTextFlags_EnterReturnsTrue);
    std::error_code ignored;
    const bool is_there = std::filesystem::exists(save_path_, ignored) && written_.count(save_path_) == 0;
    if (is_there) ImGui::TextColored(mistake_color, "there is such a file already");
    if (ImGui::Button(is_there ? "replace it" : "save") || (is_entered && !is_there)) {
        act([this] {
            session_.save_technique(save_path_);
            written_.insert(save_path_);
            messages_.note("wrote " + save_path_);
            asks_where_to_save_ = false;
        });
    }
    ImGui::SameLine();
    if (ImGui::Button("cancel")) asks_where_to_save_ = false;
    if (!asks_where_to_save_) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace croquis::viewer
