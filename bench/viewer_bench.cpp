// What the viewer costs: from a moved mouse to the new picture, its panels, and switching techniques; with the whole
// user interface drawn, as a window would draw it.
#include <backends/imgui_impl_opengl3.h>
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

#include "base/error.h"
#include "gpu/framebuffer.h"
#include "sample_models.h"
#include "viewer/appearance.h"
#include "viewer/application.h"

namespace croquis::bench {
namespace {

constexpr viewer::FrameSize frame_size{620, 500};
constexpr int triangles = 10'000;

/// The viewer on a headless context, with a framebuffer in place of its window.
class Desk {
public:
    explicit Desk(const std::string& model)
        : context_(gpu::Context::headless(gpu::ContextOptions::from_environment())),
          window_(
              *context_,
              std::make_shared<gpu::Texture>(*context_, gpu::TextureFormat::rgba8, frame_size.width, frame_size.height),
              nullptr) {
        ImGui::CreateContext();
        ImGui::GetIO().IniFilename = nullptr;
        ImGui::GetIO().DisplaySize = ImVec2(float(frame_size.width), float(frame_size.height));
        ImGui::GetIO().DeltaTime = 1.0f / 30;
        viewer::set_appearance(1);
        ImGui_ImplOpenGL3_Init(context_->api() == gpu::Api::gl ? "#version 330 core" : "#version 300 es");
        renderer_ = std::make_unique<Renderer>(Renderer::in_current_context());
        viewer::Settings settings;
        settings.technique = "cartoon";
        settings.shows_panels = false;
        application_ = std::make_unique<viewer::Application>(*renderer_, settings);
        frame();
        application_->open(model);
        rest();
    }

    void frame() {
        (void)application_->poll();
        ImGui_ImplOpenGL3_NewFrame();
        ImGui::NewFrame();
        application_->frame(frame_size);
        ImGui::Render();
        window_.bind();
        const ImVec4 color = ImGui::GetStyleColorVec4(ImGuiCol_WindowBg);
        window_.clear_color({color.x, color.y, color.z, 1});
        ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
        context_->finish();
    }
    /// Until all is read and drawn, and nothing moves.
    void rest() {
        do {
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            frame();
        } while (application_->is_busy() || application_->wants_frames());
    }
    void mouse(double x, double y, bool is_down) {
        ImGui::GetIO().MousePos = ImVec2(float(x), float(y));
        ImGui::GetIO().MouseDown[0] = is_down;
    }
    viewer::Application& application() { return *application_; }
    Renderer& renderer() { return *renderer_; }

private:
    std::unique_ptr<gpu::Context> context_;
    gpu::Framebuffer window_;
    std::unique_ptr<Renderer> renderer_;
    std::unique_ptr<viewer::Application> application_;
};

void drag(benchmark::State& state, Desk& desk) {
    desk.mouse(200, 250, true);
    desk.frame();
    double x = 200;
    for (auto _ : state) {
        x = x < 400 ? x + 3 : 200;
        desk.mouse(x, 250, true);
        desk.frame();
    }
    desk.mouse(x, 250, false);
    desk.rest();
}

// The same while a video is recorded. The processor is shared with the encoder.
void drag_recorded(benchmark::State& state, Desk& desk) {
    namespace fs = std::filesystem;
    const fs::path before = fs::current_path(), folder = fs::temp_directory_path() / "croquis_bench_viewer";
    fs::create_directories(folder);
    fs::current_path(folder);  // videos are written to where one stands
    desk.application().press("F11");
    drag(state, desk);
    desk.application().press("F11");
    const auto is_video = [](const auto& entry) { return entry.path().extension() == ".mp4"; };  // and no part of one
    while (std::none_of(fs::directory_iterator(folder), {}, is_video)) desk.rest();
    fs::current_path(before);
    fs::remove_all(folder);
}

void still(benchmark::State& state, Desk& desk) {
    for (auto _ : state) desk.frame();
}

void still_with_panels(benchmark::State& state, Desk& desk) {
    desk.application().press("Tab");
    desk.frame();
    desk.rest();
    for (auto _ : state) desk.frame();
    desk.application().press("Tab");
    desk.rest();
}

// All techniques in turn: what one takes when it is shown for the first time, its shaders compiled and its picture
// drawn.
void first_switch(benchmark::State& state, Desk& desk) {
    const std::vector<std::string> names = desk.renderer().technique_names();
    std::size_t next = 0;
    for (auto _ : state) {
        desk.application().session().choose_technique(names[next++ % names.size()]);
        desk.frame();
    }
    desk.application().session().choose_technique("cartoon");
    desk.rest();
}

}  // namespace
}  // namespace croquis::bench

int main(int argc, char** argv) {
    using namespace croquis::bench;
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    try {
        Desk desk(write_bumpy_torus(triangles));
        const auto add = [&](const char* name, void (*measured)(benchmark::State&, Desk&)) {
            return benchmark::RegisterBenchmark(name,
                                                [&desk, measured](benchmark::State& state) { measured(state, desk); })
                ->Unit(benchmark::kMillisecond)
                ->MeasureProcessCPUTime()
                ->UseRealTime();
        };
        add("mouse to picture, cartoon", drag);
        add("mouse to picture, recording", drag_recorded);
        add("frame, nothing new", still);
        add("frame, nothing new, panels", still_with_panels);
        add("first switch, mean of all", first_switch)
            ->Iterations(std::int64_t(desk.renderer().technique_names().size()));
        benchmark::RunSpecifiedBenchmarks();
    } catch (const croquis::Error& error) {
        fmt::print(stderr, "croquis_bench_viewer: {}\n", error.what());
        return 2;
    }
    return 0;
}
