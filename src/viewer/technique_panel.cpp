#include "viewer/technique_panel.h"

#include "viewer/appearance.h"

namespace croquis::viewer {
namespace {

void show_hint(const Thumbnails::Known& known) {
    if (!ImGui::IsItemHovered() || (known.error.empty() && known.help.empty())) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(24 * ImGui::GetFontSize());
    ImGui::TextUnformatted(known.help.c_str());
    if (!known.error.empty()) ImGui::TextColored(mistake_color, "%s", known.error.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

}  // namespace

std::optional<std::string> show_techniques(const std::vector<std::string>& names, const Session& session,
                                           Thumbnails& thumbnails, bool scroll_to_chosen) {
    std::optional<std::string> clicked;
    const float height = 4.2f * ImGui::GetFontSize();
    const ImVec2 picture(height * float(Thumbnails::size.aspect()), height);
    for (const std::string& name : names) {
        ImGui::PushID(name.c_str());
        const bool is_chosen = name == session.technique_name();
        const ImVec2 corner = ImGui::GetCursorPos();
        const ImVec2 row(ImGui::GetContentRegionAvail().x, height);
        if (ImGui::Selectable("##row", is_chosen, 0, row)) clicked = name;
        if (is_chosen && scroll_to_chosen) ImGui::SetScrollHereY();
        const Thumbnails::Known known = thumbnails.known(name);
        show_hint(known);
        if (ImGui::IsItemVisible()) thumbnails.want(name);
        const ImVec2 below = ImGui::GetCursorPos();
        ImGui::SetCursorPos(corner);
        thumbnails.show(name, picture);
        ImGui::SetCursorPos(ImVec2(corner.x + picture.x + ImGui::GetStyle().ItemSpacing.x, corner.y));
        ImGui::PushTextWrapPos(corner.x + row.x);
        const ImVec4 color = known.error.empty() ? ImGui::GetStyleColorVec4(ImGuiCol_Text) : mistake_color;
        ImGui::TextColored(color, "%s", name.c_str());
        ImGui::PopTextWrapPos();
        ImGui::SetCursorPos(below);
        ImGui::PopID();
    }
    return clicked;
}

}  // namespace croquis::viewer
