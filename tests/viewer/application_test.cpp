// The viewer without a window: events go in by ImGui's IO, as a window's back end puts them there, and pictures come
// out.
#include "viewer/application.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <thread>

#include "api/shapes.h"
#include "gpu/context.h"
#include "video/decoded_video.h"
#include "viewer/appearance.h"

namespace croquis::viewer {
namespace {

using test_support::TemporaryFolder;

constexpr FrameSize frame_size{640, 400};
constexpr const char* cube_text =
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

// The eye's first place e is turned back by the rotation that carries x₁ to x₂ on the sphere of radius
// r = R / (2 d tan(f/2) / h) pixels about the middle of the frame (seed B).
TEST_F(ApplicationTest, DraggingTurnsTheModelByTheTrackballsEquation) {
    open_cube();
    const View before = arrangement().view();
    const glm::dvec3 centre(0.5), eye((*before.eye)[0], (*before.eye)[1], (*before.eye)[2]);
    const glm::dvec3 back = glm::normalize(eye - centre), up(before.up[0], before.up[1], before.up[2]);
    const glm::dvec3 right = glm::cross(up, back);
    const double radius = std::sqrt(0.75) / (2 * glm::length(eye - centre) * std::tan(20 * M_PI / 180) / 400);
    const auto on_sphere = [&](double x, double y) {
        const glm::dvec2 p((x - 320) / radius, (200 - y) / radius);
        const double z = std::sqrt(1 - glm::dot(p, p));
        return p.x * right + p.y * up + z * back;
    };
    const glm::dvec3 from = on_sphere(300, 210), to = on_sphere(380, 150);
    const glm::dvec3 axis = glm::normalize(glm::cross(from, to));
    const double angle = -std::acos(glm::dot(from, to));
    const auto turned = [&](const glm::dvec3& v) {  // Rodrigues' formula
        return v * std::cos(angle) + glm::cross(axis, v) * std::sin(angle) +
               axis * glm::dot(axis, v) * (1 - std::cos(angle));
    };
    drag({300, 210}, {380, 150});

    const glm::dvec3 new_eye = centre + turned(eye - centre), new_up = turned(up);
    DrawOptions options;
    options.width = frame_size.width;
    options.height = frame_size.height;
    options.view.eye = Vector3{new_eye.x, new_eye.y, new_eye.z};
    options.view.up = Vector3{new_up.x, new_up.y, new_up.z};
    Technique technique = renderer_->open_technique("plain");
    const Picture expected = renderer_->draw(*session().model(), technique, options);
    EXPECT_LT(shown().difference_from(expected).mean, 0.02);
    options.view.eye = before.eye;
    options.view.up = before.up;
    EXPECT_GT(renderer_->draw(*session().model(), technique, options).difference_from(expected).mean, 1);
}

TEST_F(ApplicationTest, DraggingBackIsAsIfNothingWas) {
    open_cube();
    const Picture before = shown();
    mouse(300, 200, false);
    mouse(300, 200, true);
    mouse(420, 90, true);
    EXPECT_GT(shown().difference_from(before).mean, 1);
    mouse(300, 200, true);
    mouse(300, 200, false);
    EXPECT_EQ(shown().difference_from(before).maximum, 0);
}

TEST_F(ApplicationTest, WithInertiaItGoesOnTurningForAWhile) {
    open_cube();
    application_->press("I");
    drag({300, 210}, {330, 200});
    const View let_go = arrangement().view();
    EXPECT_TRUE(application_->wants_frames());
    frames();
    EXPECT_NE(arrangement().view().eye, let_go.eye);
    frames(300);  // 10 seconds
    const View at_rest = arrangement().view();
    frames();
    EXPECT_EQ(arrangement().view().eye, at_rest.eye);
}

TEST_F(ApplicationTest, NothingIsDrawnWhereNothingChanged) {
    open_cube();
    const long long draws = renderer_->counts().draws;
    frames(5);
    mouse(100, 100, false);
    EXPECT_EQ(renderer_->counts().draws, draws);
    EXPECT_FALSE(application_->wants_frames());
}

TEST_F(ApplicationTest, SwitchingTechniquesKeepsTheCameraAndTheValues) {
    open_cube();
    drag({300, 210}, {380, 150});
    const View view = arrangement().view();
    session().set("surfaces.clear_color", "0 0 1");
    frames();
    const Picture blue = shown();
    const auto names = renderer_->technique_names();
    application_->press("Down");
    frames();
    EXPECT_NE(session().technique_name(), "plain");
    EXPECT_EQ(arrangement().view().eye, view.eye);
    application_->press("Up");
    frames();
    EXPECT_EQ(session().technique_name(), "plain");
    EXPECT_EQ(shown().difference_from(blue).maximum, 0);
}

TEST_F(ApplicationTest, ASavedTechniqueDrawsTheSame) {
    open_cube();
    session().set("surfaces.clear_color", "0.25 0.5 1");
    session().set("surfaces.toon_map", "toon:two_tone:0");
    frames();
    const std::string path = (folder_.path() / "mine.technique").string();
    session().save_technique(path);
    Technique saved = renderer_->open_technique(path);
    EXPECT_EQ(
        renderer_->draw(*session().model(), saved, session().options(frame_size)).difference_from(shown()).maximum, 0);
}

TEST_F(ApplicationTest, ABadFileEndsNothing) {
    open_cube();
    const Picture before = shown();
    open_model(folder_.write("broken.obj", "v 0 0 0\nf 1 2 x\n").string());
    EXPECT_NE(mistake(Messages::Source::model).find("broken.obj:2"), std::string::npos)
        << mistake(Messages::Source::model);
    application_->open(folder_.write("broken.technique", "pass nothing ;").string());
    EXPECT_NE(mistake(Messages::Source::action).find("broken.technique:1:6: unknown component \"nothing\""),
              std::string::npos)
        << mistake(Messages::Source::action);
    application_->open(folder_.write("notes.txt", "hello").string());
    EXPECT_NE(mistake(Messages::Source::action).find("expected a model, a technique or an image, found \".txt\""),
              std::string::npos);
    open_model(folder_.write("skin.png", "no picture").string());
    EXPECT_NE(mistake(Messages::Source::model).find("skin.png"), std::string::npos);
    frames(2);
    EXPECT_EQ(shown().difference_from(before).maximum, 0);
    open_cube();
    EXPECT_EQ(mistake(Messages::Source::model), "") << "it is told until a model can be read";
}

TEST_F(ApplicationTest, ChangedFilesShowAndMistakesKeepTheLastPicture) {
    open_cube();
    session().choose_technique("red");
    frames();
    const auto color = [&] {
        const glm::u8vec4 pixel = application_->canvas().pixel(5, 5);
        return std::array<int, 3>{pixel.r, pixel.g, pixel.b};
    };
    constexpr std::array<int, 3> red{255, 0, 0}, green{0, 255, 0};
    EXPECT_EQ(color(), red);
    paint("0.0, 1.0, 0.0");
    wait_for_files();
    EXPECT_EQ(color(), green);
    paint("0.0, nonsense");
    wait_for_files();
    EXPECT_EQ(color(), green);
    EXPECT_NE(mistake(Messages::Source::files).find("paint.glsl:2"), std::string::npos);
    folder_.write("techniques/red.technique", "pass paint red {\n    textur \"toon:two_tone\" ;\n} ;");
    paint("1.0, 0.0, 0.0");
    wait_for_files();
    EXPECT_EQ(color(), green);
    EXPECT_NE(mistake(Messages::Source::files).find("red.technique:2:5: "), std::string::npos);
    folder_.write("techniques/red.technique", "pass paint red { texture \"toon:two_tone\" ; } ;");
    wait_for_files();
    EXPECT_EQ(color(), red);
    EXPECT_EQ(mistake(Messages::Source::files), "");
}

TEST_F(ApplicationTest, ATechniqueOpenedByPathIsWatchedWhileAnotherIsShown) {
    open_cube();
    const std::string file =
        folder_.write("own/mine.technique", "pass paint red { texture \"toon:two_tone\" ; } ;").string();
    application_->open(file);
    session().choose_technique("plain");
    folder_.write("own/mine.technique", "pass render_toon surfaces { clear_color 0 0 1 ; } ;");
    wait_for_files();
    session().choose_technique(file);
    frames();
    EXPECT_EQ(application_->canvas().pixel(5, 5), glm::u8vec4(0, 0, 255, 255));
}

TEST_F(ApplicationTest, ReloadingKeepsChangedValues) {
    open_cube();
    session().set("surfaces.clear_color", "0 0 1");
    frames();
    const Picture before = shown();
    application_->press("Ctrl+R");
    frames();
    EXPECT_EQ(shown().difference_from(before).maximum, 0);
    application_->press("Backspace");
    frames();
    EXPECT_GT(shown().difference_from(before).maximum, 0);
}

// Somewhere in the panel there is a slider; pressing it at a share of its length gives that share of the ui range.
TEST_F(ApplicationTest, ASliderChangesItsVariable) {
    folder_.write(
        "components/one.component",
        "component one : render_toon { number amount { default 1 ; minimum 0 ; maximum 100 ; ui_maximum 10 ; } ; } ;");
    folder_.write("techniques/one.technique", "pass one one {} ;");
    wait_for_files();
    session().choose_technique("one");
    open_cube();
    application_->press("Tab");
    frames(3);
    const auto amount = [&] {
        for (const PassVariable& variable : session().variables()) {
            if (variable.name == "amount") return variable.numbers.at(0);
        }
        return -1.0;
    };
    // The panel covers the right 38 %; its sliders begin at 42 % of its inner width. From below, for a click on a
    // header folds what is under it.
    double first = -1, last = -1;
    for (double y = 395; y > 60; y -= 6) {
        for (const double x : {520.0, 540.0}) {
            mouse(x, y, false);
            mouse(x, y, true);
            mouse(x, y, false);
            if (amount() != 1.0) (first < 0 ? first : last) = amount();
            if (first >= 0 && first != amount()) last = amount();
        }
        if (first >= 0) break;
    }
    ASSERT_GT(first, 0) << "no slider was found";
    EXPECT_GT(last, first) << "farther right is more";
    EXPECT_LE(last, 10) << "a slider keeps within the ui range";
}

TEST_F(ApplicationTest, KeysAreThoseOfTheRegistryEachOnce) {
    std::set<std::string> keys;
    for (const Command& command : application_->commands().all()) {
        EXPECT_FALSE(command.keys.empty()) << command.name;
        EXPECT_FALSE(command.help.empty()) << command.name;
        for (const std::string& key : command.keys) EXPECT_TRUE(keys.insert(key).second) << key;
    }
    EXPECT_FALSE(application_->press("Ctrl+F11"));
}

// Every command, with and without a model: none ends the session.
TEST_F(ApplicationTest, EveryCommandRuns) {
    for (const bool has_model : {false, true}) {
        if (has_model) open_cube();
        for (const Command& command : application_->commands().all()) {
            if (command.name.starts_with("Picture") || command.name == "Record" || command.name == "Close") {
                continue;  // they write, and end
            }
            application_->press(command.keys.front());
            frames();
            application_->release(command.keys.front());
        }
    }
}

TEST_F(ApplicationTest, WireframeComesOverAnyTechnique) {
    open_cube();
    const Picture before = shown();
    application_->press("W");
    frames();
    const Picture with_edges = shown();
    EXPECT_GT(with_edges.difference_from(before).mean, 0.1);
    application_->press("W");
    frames();
    EXPECT_EQ(shown().difference_from(before).maximum, 0);
}

TEST_F(ApplicationTest, TheCopiedCommandAndCameraComeBack) {
    static std::string clipboard;
    ImGui::GetIO().SetClipboardTextFn = [](void*, const char* text) { clipboard = text; };
    ImGui::GetIO().GetClipboardTextFn = [](void*) { return clipboard.c_str(); };
    open_cube();
    drag({300, 210}, {380, 150});
    application_->press("L");
    drag({300, 210}, {350, 250});
    const Picture before = shown();
    application_->press("Ctrl+Shift+C");
    application_->press("R");
    frames();
    EXPECT_GT(shown().difference_from(before).mean, 1);
    application_->press("Ctrl+V");
    frames();
    EXPECT_LT(shown().difference_from(before).mean, 0.02);
    session().set("surfaces.clear_color", "0 0 1");
    application_->press("Ctrl+C");
    for (int i = 0; application_->wants_frames() && i < 100; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        frames();
    }
    EXPECT_FALSE(application_->wants_frames()) << "the note that it was copied is still shown, and costs nothing";
    EXPECT_NE(clipboard.find("croquis render "), std::string::npos);
    EXPECT_NE(clipboard.find(" --set 'surfaces.clear_color=0 0 1' "), std::string::npos) << clipboard;
}

// A drawing that takes longer than the least frame rate allows is made with one sample while the mouse drags, and once
// it rests in full, which the window does not draw.
TEST_F(ApplicationTest, WhatMovesGivesUpDetailWhereItIsSlow) {
    begin_slowly();
    open_cube();
    wait_for_files();  // the cube's is new in a folder that is watched
    wait_for_painter();
    mouse(300, 210, false);
    mouse(300, 210, true);
    mouse(380, 150, true);
    const Picture moving = shown();
    mouse(380, 150, false);
    EXPECT_EQ(moving.difference_from(drawn_with(1)).maximum, 0);
    EXPECT_GT(moving.difference_from(drawn_with(16)).maximum, 0);
    std::this_thread::sleep_for(std::chrono::milliseconds(350));
    const long long draws = renderer_->counts().draws;
    frames();
    EXPECT_FALSE(application_->wants_frames()) << "nobody waits for the painter";
    wait_for_painter();
    EXPECT_EQ(renderer_->counts().draws, draws);
    EXPECT_EQ(shown().difference_from(drawn_with(16)).maximum, 0);
    frames(3);
    EXPECT_FALSE(application_->is_busy()) << "it is not drawn again";
}

// What changes after a picture was ordered makes it one of the past.
TEST_F(ApplicationTest, APictureThatComesTooLateIsNotShown) {
    begin_slowly();
    open_cube();
    wait_for_files();  // the cube's is new in a folder that is watched
    wait_for_painter();
    const Picture before = shown();
    session().set("surfaces.clear_color", "0 0 1");
    frames();  // ordered
    session().set("surfaces.clear_color", "1 0 0");
    const Picture reduced = shown();
    EXPECT_GT(reduced.difference_from(before).maximum, 0);
    for (int i = 0; application_->is_busy() && i < 2000; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        (void)application_->poll();
        EXPECT_EQ(shown().difference_from(reduced).maximum, 0);
    }
    wait_for_painter();
    EXPECT_EQ(shown().difference_from(drawn_with(16)).maximum, 0);
}

TEST_F(ApplicationTest, AFileThatBecameWrongLeavesThePainterWhatWasGood) {
    begin_slowly();
    session().choose_technique("red");
    open_cube();
    wait_for_files();
    drag({300, 210}, {380, 150});
    std::this_thread::sleep_for(std::chrono::milliseconds(350));
    wait_for_painter();
    paint("0.0, nonsense");
    application_->press("Ctrl+R");
    EXPECT_NE(mistake(Messages::Source::files).find("paint.glsl:2"), std::string::npos);
    const Picture good = shown();
    drag({300, 210}, {380, 150});
    std::this_thread::sleep_for(std::chrono::milliseconds(350));
    wait_for_painter();
    EXPECT_EQ(shown().difference_from(good).maximum, 0) << "what was good goes on";
    EXPECT_EQ(mistake(Messages::Source::drawing), "");
}

TEST_F(ApplicationTest, ThumbnailsAreDrawnBesideTheWindow) {
    open_cube();
    wait_for_files();  // the cube's is new in a folder that is watched
    const Renderer::Counts before = renderer_->counts();
    application_->press("Tab");
    frames(2);
    EXPECT_TRUE(application_->is_busy());
    EXPECT_FALSE(application_->wants_frames()) << "nobody waits for them";
    wait_for_painter();
    EXPECT_EQ(renderer_->counts().draws, before.draws);
    EXPECT_EQ(renderer_->counts().programs_linked, before.programs_linked);
}

TEST_F(ApplicationTest, SmallPicturesComeWithTheirTechniquesHelpOrMistake) {
    open_cube();
    folder_.write("techniques/broken.technique", "help \"Broken.\" ; pass nothing ;");
    Painter painter({.api = {}, .device = {}, .data_folders = {folder_.path().string()}}, [] {});
    Thumbnails thumbnails(painter);
    for (const char* technique : {"plain", "broken"}) thumbnails.want(technique);
    while (thumbnails.has_work() || painter.has_work()) {
        thumbnails.order_one(session());
        while (const auto delivery = painter.take()) {
            EXPECT_EQ(delivery->picture.has_value(), delivery->error.empty());
            thumbnails.take(*delivery);
        }
    }
    EXPECT_EQ(thumbnails.known("plain").help, "Plain.");
    EXPECT_EQ(thumbnails.known("plain").error, "");
    EXPECT_NE(thumbnails.known("broken").error.find("unknown component"), std::string::npos);
    thumbnails.want("broken");
    EXPECT_FALSE(thumbnails.has_work()) << "it is not tried again";
    thumbnails.restart();
    thumbnails.want("broken");
    EXPECT_TRUE(thumbnails.has_work());
}

TEST_F(ApplicationTest, ItEndsInTheMiddleOfAnything) {
    std::string large;
    for (int i = 0; i < 100'000; ++i) large += fmt::format("v {} 0 0\nv {} 1 0\nv {} 0 1\nf -3 -2 -1\n", i, i, i);
    const std::string path = folder_.write("large.obj", large).string();
    for (const int wait : {1, 30, 200}) {
        application_->press("Tab");
        open_cube();
        frames(2);
        application_->open(path);
        std::this_thread::sleep_for(std::chrono::milliseconds(wait));
        frames();
        const auto begun = std::chrono::steady_clock::now();
        EXPECT_TRUE(application_->stop(std::chrono::seconds(5)));
        application_ = std::make_unique<Application>(*renderer_, application_->settings());
        EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(5));
        frames();
    }
}

TEST_F(ApplicationTest, AModelIsSeenBetweenThePanels) {
    application_->press("Tab");
    frames(3);
    open_cube();
    const Picture picture = shown();
    int first = frame_size.width, last = 0;
    for (int x = 0; x < frame_size.width; ++x) {
        for (int y = 0; y < frame_size.height; ++y) {
            if (picture.pixels()[std::size_t(y * frame_size.width + x) * 4] == 255) continue;
            first = std::min(first, x);
            last = std::max(last, x);
        }
    }
    const int left = int(0.3 * frame_size.width), right = int((1 - 0.38) * frame_size.width);  // of a narrow window
    EXPECT_GE(first, left);
    EXPECT_LE(last, right);
    EXPECT_NEAR(first - left, right - last, 3);
}

// A model and its skin named at once, as on the command line: the skin waits for no model to be read.
TEST_F(ApplicationTest, AnImageBecomesTheTextureOfTheModel) {
    const std::string model = folder_.write("cube.obj", cube_text).string();
    const std::string data = std::getenv("CROQUIS_DATA");
    application_->open(model);
    open_model(data + "/textures/toon/two_tone.png");
    ASSERT_NE(session().model(), nullptr);
    EXPECT_EQ(session().model_path(), model);
    EXPECT_EQ(session().model_texture(), data + "/textures/toon/two_tone.png");
    drag({300, 210}, {380, 150});
    const View view = arrangement().view();
    open_model(data + "/textures/toon/flat.png");
    EXPECT_EQ(session().model_texture(), data + "/textures/toon/flat.png");
    EXPECT_EQ(arrangement().view().eye, view.eye) << "it is looked at as before";
    open_model(model);
    EXPECT_NE(arrangement().view().eye, view.eye) << "a model is seen anew";
    EXPECT_EQ(session().model_texture(), "");
}

TEST_F(ApplicationTest, AnAnimationPlays) {
    open_model("/usr/share/assimp/models/MD2/faerie.md2");
    ASSERT_NE(session().model(), nullptr);
    application_->press("Space");
    frames();
    const Picture first = shown();
    frames(10);
    EXPECT_FALSE(session().animation().empty());
    EXPECT_NEAR(session().seconds(), 11.0 / 30, 1e-5);
    EXPECT_GT(shown().difference_from(first).maximum, 0);
    application_->press("Space");
    const double paused = session().seconds();
    frames(3);
    EXPECT_EQ(session().seconds(), paused);
}

// What stands on the canvas at a time is what the video's frame of that time shows, drags and pauses alike.
TEST_F(ApplicationTest, RecordingADragGivesWhatTheCanvasShowedAtItsTimes) {
    using Clock = std::chrono::steady_clock;
    const CurrentFolder here(folder_.path());
    Settings settings = application_->settings();
    settings.video = ".mkv";
    application_ = std::make_unique<Application>(*renderer_, settings);
    frames();
    open_cube();
    struct Seen {
        double from, until;  // seconds: not before the one, at the latest from the other
        Picture picture;
    };
    const Clock::time_point before = Clock::now();
    const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - before).count(); };
    application_->press("F11");
    const double latest_begin = seconds();
    std::vector<Seen> seen{{0, 0, shown()}};
    mouse(300, 210, false);
    for (int i = 0; i <= 5; ++i) {
        const double from = seconds();
        mouse(300 + 16 * i, 210 - 10 * i, true);
        seen.push_back({from, seconds(), shown()});
        std::this_thread::sleep_for(std::chrono::milliseconds(i == 2 ? 250 : 60));
    }
    const double end = seconds();
    application_->press("F11");
    for (int i = 0; !fs::exists("cube-1.mkv") && i < 2000; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    const test_support::DecodedVideo video = test_support::decode_video("cube-1.mkv");
    EXPECT_EQ(video.width, frame_size.width);
    EXPECT_EQ(video.height, frame_size.height);
    EXPECT_NEAR(double(video.frames.size()) / 30, end, latest_begin + 1.0 / 30 + 0.01);
    for (std::size_t i = 0; i < video.frames.size(); ++i) {
        // The frame's time lies between these; so it shows one of what stood from the last to begin before to here.
        const double earliest = double(i) / 30, latest = earliest + latest_begin;
        bool is_one = false;
        for (std::size_t k = 0; k < seen.size(); ++k) {
            const bool is_over = k + 1 < seen.size() && seen[k + 1].until < earliest;
            if (seen[k].from > latest || is_over) continue;
            is_one =
                is_one ||
                Picture(video.width, video.height, video.frames[i].pixels).difference_from(seen[k].picture).maximum ==
                    0;
        }
        EXPECT_TRUE(is_one) << "frame " << i;
    }
}

TEST_F(ApplicationTest, ARecordingSaysWhatBecameOfIt) {
    const CurrentFolder here(folder_.path());
    application_->press("F11");
    EXPECT_EQ(mistake(Messages::Source::action), "expected a picture to record, found none yet");
    open_cube();
    application_->press("F11");
    EXPECT_EQ(mistake(Messages::Source::action), "");
    application_->press("F11");
    application_->press("F11");  // while the first may still be written
    application_.reset();        // ends the second
    EXPECT_GE(test_support::decode_video("cube-1.mp4").frames.size(), 1u);
    EXPECT_GE(test_support::decode_video("cube-2.mp4").frames.size(), 1u);
}

TEST_F(ApplicationTest, AVideoThatCannotBeIsTold) {
    Settings settings = application_->settings();
    settings.video = ".avi";
    application_ = std::make_unique<Application>(*renderer_, settings);
    frames();
    open_cube();
    application_->press("F11");
    for (int i = 0; mistake(Messages::Source::action).empty() && i < 2000; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        (void)application_->poll();
    }
    EXPECT_EQ(mistake(Messages::Source::action),
              "cube-1.avi: expected a video ending in .mp4, .webm, .mkv, .gif, found \".avi\"");
}

TEST_F(ApplicationTest, AFrameOfOnePixelIsDrawn) {
    open_cube();
    ImGui::GetIO().DisplaySize = ImVec2(1, 1);
    ImGui::NewFrame();
    application_->frame({1, 1});
    ImGui::Render();
    EXPECT_EQ(application_->canvas().size().width, 1);
}

}  // namespace
}  // namespace croquis::viewer
