#include "viewer/recorder.h"

#include <imgui.h>

#include <algorithm>
#include <cassert>
#include <utility>

#include "base/log.h"

namespace croquis::viewer {
namespace {

using Clock = std::chrono::steady_clock;

constexpr ImU32 red = IM_COL32(235, 40, 30, 255);

}  // namespace

Recorder::~Recorder() { finish(); }

void Recorder::finish() {
    stop();
    for (const auto& recording : ended_) {
        recording->wait();
        if (!recording->error().empty()) warn(recording->error());
    }
    ended_.clear();
}

void Recorder::start(const std::string& path, Picture picture) {
    assert(!is_recording());
    recording_ = std::make_unique<Recording>(path, std::move(picture), Clock::now());
    shown_seconds_ = 0;
}

void Recorder::stop() {
    if (!recording_) return;
    recording_->end(Clock::now());
    ended_.push_back(std::move(recording_));
}

bool Recorder::is_writing(const std::string& path) const {
    return (recording_ && recording_->path() == path) ||
           std::any_of(ended_.begin(), ended_.end(), [&](const auto& ended) { return ended->path() == path; });
}

void Recorder::add(Picture picture) {
    if (recording_) recording_->add(std::move(picture), Clock::now());
}

// One that failed is over before anybody stopped it.
std::optional<Recorder::Outcome> Recorder::take() {
    if (recording_ && recording_->is_over()) stop();
    const auto done = std::find_if(ended_.begin(), ended_.end(), [](const auto& ended) { return ended->is_over(); });
    if (done == ended_.end()) return std::nullopt;
    Outcome outcome{(*done)->path(), (*done)->error()};
    ended_.erase(done);
    return outcome;
}

long long Recorder::seconds() const { return (long long)(recording_->seconds(Clock::now())); }

void Recorder::show(float x, float y) {
    if (!recording_) return;
    shown_seconds_ = seconds();
    ImGui::SetNextWindowPos(ImVec2(x, y));
    ImGui::Begin("recording", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoFocusOnAppearing);
    const float line = ImGui::GetTextLineHeight();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddCircleFilled(ImVec2(corner.x + 0.5f * line, corner.y + 0.5f * line), 0.4f * line,
                                                red);
    ImGui::Dummy(ImVec2(line, line));
    ImGui::SameLine();
    ImGui::Text("%lld:%02lld", shown_seconds_ / 60, shown_seconds_ % 60);
    ImGui::End();
}

bool Recorder::wants_frame() const { return recording_ && seconds() != shown_seconds_; }

}  // namespace croquis::viewer
