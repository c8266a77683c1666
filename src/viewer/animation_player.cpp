#include "viewer/animation_player.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/names.h"

namespace croquis::viewer {

void AnimationPlayer::take(std::vector<Animation> clips) {
    *this = AnimationPlayer();
    clips_ = std::move(clips);
}

void AnimationPlayer::set_playing(bool on) {
    is_playing_ = on && has_clips();
    if (is_playing_ && chosen_ < 0) chosen_ = 0;
}

void AnimationPlayer::advance(double seconds) {
    if (!is_playing_ || chosen_ < 0) return;
    seconds_ += seconds * speed_;
    const double length = clips_[std::size_t(chosen_)].seconds;
    if (length > 0) seconds_ -= length * std::floor(seconds_ / length);
}

void AnimationPlayer::choose(const std::string& clip) {
    seconds_ = 0;
    chosen_ = -1;
    if (clip.empty()) return;
    const auto found = std::find_if(clips_.begin(), clips_.end(), [&](const Animation& a) { return a.name == clip; });
    if (found == clips_.end()) {
        std::vector<std::string> names;
        for (const Animation& animation : clips_) names.push_back(animation.name);
        fail("the model has no animation \"{}\"{}", clip, suggestion(clip, names));
    }
    chosen_ = int(found - clips_.begin());
}

bool AnimationPlayer::show() {
    const int chosen_before = chosen_;
    const double seconds_before = seconds_;
    const float line = ImGui::GetFontSize();
    if (ImGui::Button(is_playing_ ? "pause" : "play", ImVec2(4 * line, 0))) set_playing(!is_playing_);
    ImGui::SameLine();
    ImGui::SetNextItemWidth(10 * line);
    if (ImGui::BeginCombo("##clip", chosen_ < 0 ? "at rest" : clip().c_str())) {
        if (ImGui::Selectable("at rest", chosen_ < 0)) choose("");
        for (const Animation& animation : clips_) {
            if (ImGui::Selectable(animation.name.c_str(), animation.name == clip())) choose(animation.name);
        }
        ImGui::EndCombo();
    }
    ImGui::SameLine();
    float seconds = float(seconds_), speed = float(speed_);
    const float length = chosen_ < 0 ? 0 : float(clips_[std::size_t(chosen_)].seconds);
    ImGui::SetNextItemWidth(18 * line);
    if (ImGui::SliderFloat("##moment", &seconds, 0, length, "%.2f s", ImGuiSliderFlags_AlwaysClamp))
        seconds_ = double(seconds);
    ImGui::SameLine();
    ImGui::SetNextItemWidth(8 * line);
    if (ImGui::SliderFloat("speed", &speed, 0.1f, 3, "%.1f x", ImGuiSliderFlags_AlwaysClamp)) speed_ = double(speed);
    return chosen_ != chosen_before || seconds_ != seconds_before;
}

}  // namespace croquis::viewer
