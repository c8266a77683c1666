#include "viewer/help_screen.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "viewer/appearance.h"

namespace croquis::viewer {
namespace {

// What the mouse does is no command: it has no key of its own to be looked up.
struct MouseDeed {
    const char* deed;
    const char* name;
    const char* help;
};
constexpr std::array mouse_deeds{
    MouseDeed{"drag", "Turn", "Turns what moves: a point of a sphere around the object follows the mouse."},
    MouseDeed{"Ctrl+drag", "Roll", "Turns about the line of sight, as dragging beside the object does."},
    MouseDeed{"Shift+drag, right drag", "Pan", "Moves across the line of sight."},
    MouseDeed{"wheel", "Zoom", "What is under the mouse stays under it."},
    MouseDeed{"drop a file", "Open", "A model, a technique, or an image as texture of the model."},
};

void show_row(const std::string& key, const std::string& what, const std::string& more) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, changed_color);
    ImGui::TextWrapped("%s", key.c_str());
    ImGui::PopStyleColor();
    ImGui::TableNextColumn();
    ImGui::TextWrapped("%s", what.c_str());
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextWrapped("%s", more.c_str());
    ImGui::PopStyleColor();
}

void show_group(const Commands& commands, const std::string& group) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", group.c_str());
    for (const Command& command : commands.all()) {
        if (command.group != group) continue;
        show_row(fmt::format("{}", fmt::join(command.keys, ", ")), command.name, command.help);
    }
}

}  // namespace

void show_help_screen(const Commands& commands, bool& is_open) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float line = ImGui::GetFontSize();
    ImGui::SetNextWindowPos(ImVec2(0.5f * display.x, 0.5f * display.y), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    ImGui::SetNextWindowSize(ImVec2(std::min(62 * line, 0.95f * display.x), std::min(52 * line, 0.92f * display.y)));
    ImGui::SetNextWindowFocus();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    if (ImGui::Begin("Help", &is_open,
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize) &&
        ImGui::BeginTable("keys", 3)) {
        ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthStretch, 12);
        ImGui::TableSetupColumn("command", ImGuiTableColumnFlags_WidthStretch, 14);
        ImGui::TableSetupColumn("help", ImGuiTableColumnFlags_WidthStretch, 36);
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextDisabled("Mouse");
        for (const MouseDeed& deed : mouse_deeds) show_row(deed.deed, deed.name, deed.help);
        for (const std::string& group : commands.groups()) show_group(commands, group);
        ImGui::EndTable();
    }
    ImGui::End();
    ImGui::PopStyleVar();
}

}  // namespace croquis::viewer
