// An application without a window: events go in by ImGui's IO, as a window's back end puts them there, and pictures
// come out.
#pragma once

#include <gtest/gtest.h>
#include <imgui.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "api/shapes.h"
#include "gpu/context.h"
#include "viewer/appearance.h"
#include "viewer/application.h"

namespace croquis::viewer {

using test_support::TemporaryFolder;

inline constexpr FrameSize frame_size{640, 400};
inline constexpr const char* cube_text =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n"
    "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";

namespace fs = std::filesystem;

/// What is written without a folder goes there.
class CurrentFolder {
public:
    explicit CurrentFolder(const fs::path& folder) : before_(fs::current_path()) { fs::current_path(folder); }
    ~CurrentFolder() { fs::current_path(before_); }
    CurrentFolder(const CurrentFolder&) = delete;
    CurrentFolder& operator=(const CurrentFolder&) = delete;

private:
    fs::path before_;
};

class ApplicationTest : public ::testing::Test {
protected:
    ApplicationTest() : context_(gpu::Context::headless(gpu::ContextOptions::from_environment())) {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = ImVec2(float(frame_size.width), float(frame_size.height));
        io.DeltaTime = 1.0f / 30;
        set_appearance(1);
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);  // no back end does it
        folder_.write("techniques/plain.technique", "help \"Plain.\" ; pass render_toon surfaces {} ;");
        folder_.write("techniques/red.technique", "pass paint red { texture \"toon:two_tone\" ; } ;");
        folder_.write(
            "components/paint.component",
            "component paint : process_texture { modify fragment_program { default \"paint:paint\" ; } ; } ;");
        paint("1.0, 0.0, 0.0");
        renderer_ = std::make_unique<Renderer>(Renderer::in_current_context({folder_.path().string()}));
        Settings settings;
        settings.technique = "plain";
        settings.shows_panels = false;
        settings.samples = 1;
        application_ = std::make_unique<Application>(*renderer_, settings);
        frames();
    }
    ~ApplicationTest() override {
        application_.reset();
        renderer_.reset();
        ImGui::DestroyContext();
    }

    void paint(const std::string& color) const {
        folder_.write("shaders/paint.glsl",
                      "#ifdef FRAGMENT_STAGE\nvec4 paint() { return vec4(" + color + ", 1.0); }\n#endif\n");
    }
    void frames(int count = 1) {
        for (int i = 0; i < count; ++i) {
            (void)application_->poll();
            ImGui::NewFrame();
            application_->frame(frame_size);
            ImGui::Render();
        }
    }
    // Until a model was read, and what comes after it.
    void open_model(const std::string& path) {
        application_->open(path);
        while_busy([this] { return application_->loader().is_busy(); });
        frames(2);
    }
    template <typename IsBusy>
    void while_busy(const IsBusy& is_busy) {
        for (int i = 0; is_busy() && i < 2000; ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            (void)application_->poll();
        }
    }
    // Until nothing more is drawn beside, and all that was is shown.
    void wait_for_painter() {
        for (frames(2); application_->is_busy(); frames(2)) {
            while_busy([this] { return application_->is_busy(); });
        }
    }
    // Any drawing takes too long for so high a rate.
    void begin_slowly() {
        Settings settings = application_->settings();
        settings.samples = 16;
        settings.least_frame_rate = 1e6;
        application_ = std::make_unique<Application>(*renderer_, settings);
        frames();
    }
    Picture drawn_with(int samples) {
        DrawOptions options = session().options(frame_size);
        options.samples = samples;
        Technique technique = renderer_->open_technique_text("plain", session().order({}, {}).text);
        return renderer_->draw(*session().model(), technique, options);
    }
    void open_cube() { open_model(folder_.write("cube.obj", cube_text).string()); }
    // Files are looked at now and then.
    void wait_for_files() {
        std::this_thread::sleep_for(std::chrono::milliseconds(450));
        frames(2);
    }
    void mouse(double x, double y, bool is_down) {
        ImGui::GetIO().MousePos = ImVec2(float(x), float(y));
        ImGui::GetIO().MouseDown[0] = is_down;
        frames();
    }
    void drag(const glm::dvec2& from, const glm::dvec2& to) {
        mouse(from.x, from.y, false);
        mouse(from.x, from.y, true);
        mouse(0.5 * (from.x + to.x), 0.5 * (from.y + to.y), true);
        mouse(to.x, to.y, true);
        mouse(to.x, to.y, false);
    }
    Picture shown() { return Picture(frame_size.width, frame_size.height, application_->canvas().pixels()); }
    Session& session() { return application_->session(); }
    const Arrangement& arrangement() { return std::as_const(session()).arrangement(); }
    std::string mistake(Messages::Source source) { return application_->messages().mistake(source); }

    TemporaryFolder folder_;
    std::unique_ptr<gpu::Context> context_;
    std::unique_ptr<Renderer> renderer_;
    std::unique_ptr<Application> application_;
};

}  // namespace croquis::viewer
