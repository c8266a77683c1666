#include "viewer/variables_panel.h"

#include <fmt/format.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "viewer/appearance.h"

namespace croquis::viewer {
namespace {

constexpr const char* generated = "<generated>:";

// As technique files write numbers, so that a value that is shown and set again is the same.
std::string text_of(std::span<const float> numbers) { return fmt::format("{}", fmt::join(numbers, " ")); }

std::array<float, 4> floats(const std::vector<double>& numbers) {
    std::array<float, 4> all{};
    std::transform(numbers.begin(), numbers.end(), all.begin(), [](double number) { return float(number); });
    return all;
}

double clamped(double value, const PassVariable& variable) {
    if (!variable.minimum.empty()) value = std::max(value, variable.minimum.front());
    if (!variable.maximum.empty()) value = std::min(value, variable.maximum.front());
    return value;
}

// Few digits for large numbers, more for small ones; a slider keeps what it shows.
const char* format_for(double low, double high) {
    const double range = high - low;
    return range > 200 ? "%.0f" : range > 5 ? "%.2f" : range > 0.05 ? "%.3f" : "%.5f";
}

constexpr float share_of_slider = 0.6f;

// The number box stands beside its slider; what is left for it.
float beside_slider(float width) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::SameLine(0, gap);
    return (1 - share_of_slider) * width - gap;
}

// A slider over the range of good values where there is one, and a box for any the variable can take.
bool edit_number(const PassVariable& variable, float width, float& value) {
    const bool has_slider = !variable.ui_minimum.empty() && !variable.ui_maximum.empty();
    bool is_changed = false;
    if (has_slider) {
        const float low = float(variable.ui_minimum.front()), high = float(variable.ui_maximum.front());
        ImGui::SetNextItemWidth(share_of_slider * width);
        is_changed = ImGui::SliderFloat("##slider", &value, low, high, format_for(low, high));
        width = beside_slider(width);
    }
    ImGui::SetNextItemWidth(width);
    is_changed = ImGui::InputFloat("##box", &value, 0, 0, "%g", ImGuiInputTextFlags_EnterReturnsTrue) || is_changed;
    if (is_changed) value = float(clamped(double(value), variable));
    return is_changed;
}

bool edit_integer(const PassVariable& variable, float width, int& value) {
    const bool has_slider = !variable.ui_minimum.empty() && !variable.ui_maximum.empty();
    bool is_changed = false;
    if (has_slider) {
        const int low = int(variable.ui_minimum.front()), high = int(variable.ui_maximum.front());
        ImGui::SetNextItemWidth(share_of_slider * width);
        is_changed = ImGui::SliderInt("##slider", &value, low, high);
        width = beside_slider(width);
    }
    ImGui::SetNextItemWidth(width);
    is_changed = ImGui::InputInt("##box", &value, 0, 0, ImGuiInputTextFlags_EnterReturnsTrue) || is_changed;
    if (is_changed) value = int(clamped(double(value), variable));
    return is_changed;
}

// Each component within its own limits.
bool edit_vector(const PassVariable& variable, float all, std::array<float, 4>& values) {
    bool is_changed = false;
    const std::size_t count = variable.numbers.size();
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width = (all - gap * float(count - 1)) / float(count);
    for (std::size_t i = 0; i < count; ++i) {
        ImGui::PushID(int(i));
        if (i > 0) ImGui::SameLine(0, gap);
        ImGui::SetNextItemWidth(width);
        const float low = variable.minimum.empty() ? -1e30f : float(variable.minimum[i]);
        const float high = variable.maximum.empty() ? 1e30f : float(variable.maximum[i]);
        is_changed =
            ImGui::DragFloat("##component", &values[i], 0.01f, low, high, "%.3f", ImGuiSliderFlags_AlwaysClamp) ||
            is_changed;
        ImGui::PopID();
    }
    return is_changed;
}

bool edit_color(const PassVariable& variable, float width, std::array<float, 4>& values) {
    ImGui::SetNextItemWidth(width);
    if (variable.numbers.size() == 3) return ImGui::ColorEdit3("##color", values.data());
    return ImGui::ColorEdit4("##color", values.data(), ImGuiColorEditFlags_AlphaPreviewHalf);
}

std::string chosen(const PassVariable& variable, float width) {
    std::string choice = variable.value;
    ImGui::SetNextItemWidth(width);
    if (!ImGui::BeginCombo("##choices", choice.c_str())) return choice;
    for (const std::string& word : variable.choices) {
        if (ImGui::Selectable(word.c_str(), word == variable.value)) choice = word;
    }
    ImGui::EndCombo();
    return choice;
}

std::string switched(const PassVariable& variable) {
    bool on = variable.value == "true";
    return ImGui::Checkbox("##switch", &on) ? (on ? "true" : "false") : variable.value;
}

std::string typed(const PassVariable& variable, float width) {
    std::string text = variable.value;
    ImGui::SetNextItemWidth(width);
    return ImGui::InputText("##text", &text, ImGuiInputTextFlags_EnterReturnsTrue) ? text : variable.value;
}

std::string range_text(const std::vector<double>& low, const std::vector<double>& high) {
    if (low.empty() && high.empty()) return {};
    if (high.empty()) return fmt::format("\nfrom {:g}", fmt::join(low, " "));
    if (low.empty()) return fmt::format("\nup to {:g}", fmt::join(high, " "));
    return fmt::format("\n{:g} to {:g}", fmt::join(low, " "), fmt::join(high, " "));
}

void show_help(const PassVariable& variable, const std::string& original) {
    if (!ImGui::IsItemHovered()) return;
    std::string text = variable.help + range_text(variable.minimum, variable.maximum);
    if (!variable.unit.empty()) text += " " + variable.unit;
    text += fmt::format("\nin this technique: {}", original.empty() ? "nothing" : original);
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(24 * ImGui::GetFontSize());
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

// "toon:two_tone:0" without its filter.
std::string image_of(const std::string& texture) {
    const std::size_t first = texture.find(':');
    return texture.substr(0, first == std::string::npos ? first : texture.find(':', first + 1));
}

bool is_switch_of_pass(const PassVariable& variable) { return variable.common && variable.name == "render"; }

void set(Session& session, Messages& messages, const std::string& variable, const std::string& value) {
    try {
        session.set(variable, value);
        messages.mended(Messages::Source::action);
    } catch (const Error& error) {
        messages.tell(Messages::Source::action, error.what());
    }
}

}  // namespace

void VariablesPanel::forget_textures() {
    texture_names_.clear();
    previewed_.clear();
}

void VariablesPanel::show(Session& session, Messages& messages) {
    const std::vector<PassVariable> variables = session.variables();
    for (auto first = variables.begin(); first != variables.end();) {
        const auto next = std::find_if(first, variables.end(), [&](const auto& v) { return v.pass != first->pass; });
        show_pass(std::span(first, next), session, messages);
        first = next;
    }
}

// The pass's own variables; those that every pass has are seldom wanted, and fold away. A pass that has no others is
// folded whole.
void VariablesPanel::show_pass(std::span<const PassVariable> variables, Session& session, Messages& messages) {
    const auto is_own = [](const PassVariable& variable) { return !variable.common && !variable.internal; };
    const auto is_hidden_at_first = [](const PassVariable& variable) { return variable.common && !variable.internal; };
    const std::string& pass = variables.front().pass;
    const bool has_own = std::any_of(variables.begin(), variables.end(), is_own);
    ImGui::PushID(pass.c_str());
    const ImGuiTreeNodeFlags flags = has_own ? ImGuiTreeNodeFlags_DefaultOpen : 0;
    const bool is_open = ImGui::CollapsingHeader(pass.c_str(), flags | ImGuiTreeNodeFlags_AllowItemOverlap);
    const auto render = std::find_if(variables.begin(), variables.end(), is_switch_of_pass);
    if (render != variables.end()) show_switch(*render, session, messages);
    if (is_open) {
        for (const PassVariable& variable : variables) {
            if (is_own(variable)) show_variable(variable, session, messages);
        }
        if (ImGui::TreeNodeEx("as every pass", ImGuiTreeNodeFlags_NoTreePushOnOpen)) {
            for (const PassVariable& variable : variables) {
                if (is_hidden_at_first(variable) && !is_switch_of_pass(variable)) {
                    show_variable(variable, session, messages);
                }
            }
        }
    }
    ImGui::PopID();
}

// Whether the pass is drawn at all: at the right end of its header.
void VariablesPanel::show_switch(const PassVariable& render, Session& session, Messages& messages) {
    const float size = ImGui::GetFrameHeight();
    ImGui::SameLine(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - size);
    const std::string value = switched(render);
    show_help(render, session.original_value(render.full_name()));
    if (value != render.value) set(session, messages, render.full_name(), value);
}

// One row: the name, the widget, and where the value was changed a way back.
void VariablesPanel::show_variable(const PassVariable& variable, Session& session, Messages& messages) {
    ImGui::PushID(variable.name.c_str());
    constexpr float share_of_names = 0.42f;
    const std::string original = session.original_value(variable.full_name());
    const bool is_changed = session.is_changed(variable);
    const float all = ImGui::GetContentRegionAvail().x, begin = ImGui::GetCursorPosX();
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored(is_changed ? changed_color : ImGui::GetStyleColorVec4(ImGuiCol_Text), "%s",
                       variable.name.c_str());
    show_help(variable, original);
    ImGui::SameLine();
    const float widgets = begin + share_of_names * all, name_end = ImGui::GetCursorPosX();
    if (name_end + ImGui::CalcTextSize(variable.unit.c_str()).x < widgets) {
        ImGui::TextDisabled("%s", variable.unit.c_str());  // else the help tells it
        ImGui::SameLine();
    }
    if (name_end > widgets) ImGui::NewLine();
    ImGui::SetCursorPosX(widgets);
    const float undo = ImGui::CalcTextSize("undo").x + 2 * ImGui::GetStyle().FramePadding.x;
    const bool has_undo = is_changed && !variable.read_only;
    width_ = (1 - share_of_names) * all - (has_undo ? undo + ImGui::GetStyle().ItemInnerSpacing.x : 0);
    ImGui::BeginDisabled(variable.read_only);
    ImGui::BeginGroup();
    std::string value = edited(variable);
    ImGui::EndGroup();
    ImGui::EndDisabled();
    if (has_undo) {
        ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
        if (ImGui::Button("undo")) value = original;
    }
    if (value != variable.value) set(session, messages, variable.full_name(), value);
    ImGui::PopID();
}

// The value that the widget leaves; the variable's own where nobody touched it.
std::string VariablesPanel::edited(const PassVariable& variable) {
    std::array<float, 4> values = floats(variable.numbers);
    switch (variable.type) {
        case PassVariable::Type::integer: {
            int value = int(variable.numbers.front());
            return edit_integer(variable, width_, value) ? fmt::format("{}", value) : variable.value;
        }
        case PassVariable::Type::number:
            return edit_number(variable, width_, values[0]) ? text_of(std::span(values).first(1)) : variable.value;
        case PassVariable::Type::vector:
            return edit_vector(variable, width_, values) ? text_of(std::span(values).first(variable.numbers.size()))
                                                         : variable.value;
        case PassVariable::Type::color:
            return edit_color(variable, width_, values) ? text_of(std::span(values).first(variable.numbers.size()))
                                                        : variable.value;
        case PassVariable::Type::texture:
            return chosen_texture(variable);
        case PassVariable::Type::text:
            return variable.choices.empty() ? typed(variable, width_) : chosen(variable, width_);
        case PassVariable::Type::boolean:
            return switched(variable);
    }
    return variable.value;
}

// Images of the data folders with previews. A texture that an earlier pass generates has no other to choose from.
std::string VariablesPanel::chosen_texture(const PassVariable& variable) {
    std::string choice = variable.value;
    const ImVec2 preview(2 * ImGui::GetFontSize(), ImGui::GetFontSize());
    float width = width_;
    if (!choice.empty() && !choice.starts_with(generated)) {
        show_preview(image_of(choice));
        ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
        width -= preview.x + ImGui::GetStyle().ItemInnerSpacing.x;
    }
    ImGui::SetNextItemWidth(width);
    if (!ImGui::BeginCombo("##textures", choice.c_str())) return choice;
    if (texture_names_.empty()) texture_names_ = renderer_.texture_names();
    const std::string now = image_of(variable.value);
    const std::string filter = variable.value.substr(std::min(now.size(), variable.value.size()));
    for (const std::string& name : texture_names_) {
        if (ImGui::IsRectVisible(ImVec2(1, preview.y)))
            show_preview(name);
        else
            ImGui::Dummy(preview);
        ImGui::SameLine();
        // The filter that the technique chose goes with the place and not with the image.
        if (ImGui::Selectable(name.c_str(), name == now)) choice = name + filter;
    }
    ImGui::EndCombo();
    return choice;
}

void VariablesPanel::show_preview(const std::string& texture) {
    if (std::find(previewed_.begin(), previewed_.end(), texture) == previewed_.end()) {
        previewed_.push_back(texture);
        try {
            previews_.put(texture, renderer_.texture(texture));
        } catch (const Error&) {
            // What cannot be shown can still be chosen, and is told then.
        }
    }
    previews_.show(texture, ImVec2(2 * ImGui::GetFontSize(), ImGui::GetFontSize()));
}

}  // namespace croquis::viewer
