// The viewer as a person uses it: mouse, keys, panels, models.
#include "viewer/application.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <cmath>
#include <set>
#include <thread>

#include "viewer/application_fixture.h"

namespace croquis::viewer {
namespace {

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
