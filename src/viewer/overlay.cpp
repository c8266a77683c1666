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

void Overlay::measure_passes(Session& session, FrameSize frame, Detail detail) {
    constexpr double seconds_between = 0.5;
    if (measured_ == drawn_ || ImGui::GetTime() < measured_at_ + seconds_between) return;
    measured_ = drawn_;
    measured_at_ = ImGui::GetTime();
    try {
        passes_ = session.time_passes(frame, detail);
    } catch (const Error&) {
        passes_.clear();  // the drawing itself tells why
    }
}

void Overlay::show(float x, float y, Session& session, const Renderer& renderer, FrameSize frame,
                   std::optional<Detail> detail) {
    if (detail) measure_passes(session, frame, *detail);
    ImGui::SetNextWindowPos(ImVec2(x, y), ImGuiCond_Always, ImVec2(1, 0));
    ImGui::Begin("overlay", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoFocusOnAppearing);
    const float last = milliseconds_[(next_ + frames_kept - 1) % frames_kept];
    ImGui::Text("%.1f ms a drawing, %.0f a second", double(last), last > 0 ? 1000.0 / double(last) : 0.0);
    const float longest = *std::max_element(milliseconds_.begin(), milliseconds_.end());
    ImGui::PlotHistogram("##frames", milliseconds_.data(), int(frames_kept), int(next_), nullptr, 0, longest,
                         ImVec2(16 * ImGui::GetFontSize(), 2.5f * ImGui::GetFontSize()));
    for (const PassTime& pass : passes_) ImGui::Text("%8.2f ms  %s", pass.milliseconds, pass.pass.c_str());
    if (const Model* model = session.model()) {
        ImGui::Text("%zu triangles in %zu meshes", model->triangle_count(), model->mesh_count());
    }
    ImGui::Text("%d x %d pixels, %d samples", frame.width, frame.height, session.samples());
    const RendererInfo info = renderer.info();
    ImGui::Text("%s", info.api.c_str());
    ImGui::TextUnformatted(info.renderer.c_str());
    ImGui::End();
}

}  // namespace croquis::viewer
