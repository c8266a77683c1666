#include "viewer/overlay.h"

#include <imgui.h>

#include <algorithm>

#include "base/error.h"

namespace croquis::viewer {

void Overlay::add_frame(double milliseconds) {
    milliseconds_[next_] = float(milliseconds);
    next_ = (next_ + 1) % frames_kept;
    ++drawn_;
}

bool Overlay::is_due() const {
    constexpr auto between = std::chrono::milliseconds(500);
    return measured_ != drawn_ && std::chrono::steady_clock::now() >= measured_at_ + between;
}

void Overlay::measure_passes(Session& session, FrameSize frame, Detail detail) {
    if (!is_due()) return;
    measured_ = drawn_;
    measured_at_ = std::chrono::steady_clock::now();
    try {
        passes_ = session.time_passes(frame, detail);
    } catch (const Error&) {
        passes_.clear();  // the drawing itself tells why
    }
}

void Overlay::show(float low, float high, Session& session, const Renderer& renderer, FrameSize frame,
                   std::optional<Detail> detail) {
    if (detail) measure_passes(session, frame, *detail);
    const float line = ImGui::GetFontSize();
    const float room = high - low - line - 2 * ImGui::GetStyle().WindowPadding.x;
    const float width = std::max(line, std::min(16 * line, room));
    ImGui::SetNextWindowPos(ImVec2(high - 0.5f * line, 0.5f * line), ImGuiCond_Always, ImVec2(1, 0));
    ImGui::Begin("overlay", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
    const float last = milliseconds_[(next_ + frames_kept - 1) % frames_kept];
    ImGui::Text("%.1f ms a drawing, %.0f a second", double(last), last > 0 ? 1000.0 / double(last) : 0.0);
    const float longest = *std::max_element(milliseconds_.begin(), milliseconds_.end());
    ImGui::PlotHistogram("##frames", milliseconds_.data(), int(frames_kept), int(next_), nullptr, 0, longest,
                         ImVec2(width, 2.5f * line));
    for (const PassTime& pass : passes_) {
        ImGui::Text("%8.2f ms  %s", pass.milliseconds, pass.pass.c_str());
        if (pass.lines == 0) continue;
        ImGui::SameLine();
        ImGui::TextDisabled("%zu lines", pass.lines);
    }
    if (const Model* model = session.model()) {
        ImGui::Text("%zu triangles in %zu meshes", model->triangle_count(), model->mesh_count());
    }
    ImGui::Text("%d x %d pixels, %d samples", frame.width, frame.height, session.samples());
    const RendererInfo info = renderer.info();
    ImGui::Text("%s", info.api.c_str());
    ImGui::TextUnformatted(info.renderer.c_str());
    ImGui::PopTextWrapPos();
    ImGui::End();
}

}  // namespace croquis::viewer
