// Techniques and their values in a session: what reloading and the wireframe leave as it was.
#include "viewer/session.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "api/shapes.h"
#include "gpu/context.h"
#include "support/errors.h"

namespace croquis::viewer {
namespace {

constexpr FrameSize frame_size{160, 120};

class SessionTest : public ::testing::Test {
protected:
    SessionTest() : context_(gpu::Context::headless(gpu::ContextOptions::from_environment())) {
        folder_.write("techniques/plain.technique", "pass render_toon surfaces {} ;");
        folder_.write("techniques/other.technique", "pass render_toon surfaces {} ; pass wireframe lines {} ;");
        renderer_ = std::make_unique<Renderer>(Renderer::in_current_context({folder_.path().string()}));
        session_ = std::make_unique<Session>(*renderer_);
        const Model cube = test_support::cube_file();
        session_->arrangement().take(cube, View(), frame_size);
        session_->show(cube, "cube.obj", "");
        session_->choose_technique("plain");
    }

    Picture drawn() {
        session_->draw(canvas_, frame_size, Detail::full);
        return Picture(frame_size.width, frame_size.height, canvas_.pixels());
    }
    [[nodiscard]] std::string value(const std::string& variable) const {
        for (const PassVariable& candidate : session_->variables()) {
            if (candidate.full_name() == variable) return candidate.value;
        }
        return "no such variable";
    }
    [[nodiscard]] std::string saved() const {
        const std::string path = (folder_.path() / "saved.technique").string();
        session_->save_technique(path);
        std::ifstream file(path);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    [[nodiscard]] std::string command() const { return session_->command_line(frame_size); }

    test_support::TemporaryFolder folder_;
    std::unique_ptr<gpu::Context> context_;
    Canvas canvas_;
    std::unique_ptr<Renderer> renderer_;
    std::unique_ptr<Session> session_;
};

TEST_F(SessionTest, EveryTechniqueKeepsItsValuesAcrossReloading) {
    session_->set("surfaces.clear_color", "0 0 1");
    session_->choose_technique("other");
    session_->set("lines.width", "3");
    session_->reload();
    EXPECT_EQ(value("lines.width"), "3");
    session_->reload();  // the values of one that was not chosen in between stay as well
    session_->choose_technique("plain");
    EXPECT_EQ(value("surfaces.clear_color"), "0 0 1");
    EXPECT_EQ(drawn().pixels()[2], 255);
    EXPECT_EQ(drawn().pixels()[0], 0);
    session_->reset_all();
    session_->reload();
    EXPECT_NE(value("surfaces.clear_color"), "0 0 1") << "what was reset stays so";
    session_->choose_technique("other");
    EXPECT_EQ(value("lines.width"), "3");
}

TEST_F(SessionTest, AValueWhoseVariableHasGoneIsLeftBehind) {
    session_->choose_technique("other");
    session_->set("lines.width", "3");
    session_->set("surfaces.clear_color", "0 0 1");
    session_->choose_technique("plain");
    folder_.write("techniques/other.technique", "pass render_toon surfaces {} ;");
    session_->reload();
    session_->choose_technique("other");
    EXPECT_EQ(value("lines.width"), "no such variable");
    EXPECT_EQ(value("surfaces.clear_color"), "0 0 1");
}

TEST_F(SessionTest, AMistakeInAnotherTechniqueWaitsUntilThatIsChosen) {
    session_->choose_technique("other");
    session_->set("lines.width", "3");
    session_->choose_technique("plain");
    folder_.write("techniques/other.technique", "pass nothing ;");
    session_->reload();
    EXPECT_NE(test_support::error_of([&] { session_->choose_technique("other"); }).find("unknown component"),
              std::string::npos);
    EXPECT_EQ(session_->technique_name(), "plain");
    folder_.write("techniques/other.technique", "pass render_toon surfaces {} ; pass wireframe lines {} ;");
    session_->reload();
    session_->choose_technique("other");
    EXPECT_EQ(value("lines.width"), "3");
}

TEST_F(SessionTest, AMistakeInTheTechniqueThatIsShownKeepsIt) {
    session_->set("surfaces.clear_color", "0 0 1");
    const Picture before = drawn();
    folder_.write("techniques/plain.technique", "pass nothing ;");
    EXPECT_NE(test_support::error_of([&] { session_->reload(); }), "no error");
    EXPECT_EQ(drawn().difference_from(before).maximum, 0);
    session_->set("surfaces.clear_color", "1 0 0");
    folder_.write("techniques/plain.technique", "pass render_toon surfaces {} ;");
    session_->reload();
    EXPECT_EQ(value("surfaces.clear_color"), "1 0 0");
}

TEST_F(SessionTest, TheWireframeIsDrawnAndIsNoPartOfTheTechnique) {
    session_->set("surfaces.clear_color", "0 0 1");
    const Picture before = drawn();
    const std::string technique = saved(), command = this->command();
    const std::size_t variables = session_->variables().size();
    session_->set_wireframe(true);
    EXPECT_GT(drawn().difference_from(before).mean, 0.1);
    EXPECT_EQ(session_->variables().size(), variables);
    EXPECT_EQ(saved(), technique);
    EXPECT_EQ(this->command(), command);
    session_->set_wireframe(false);
    EXPECT_EQ(drawn().difference_from(before).maximum, 0);
}

// The truth: a technique of its own with the pass that the wireframe adds.
TEST_F(SessionTest, TheWireframeFollowsValuesAndTechniques) {
    const auto with_edges = [&](const std::string& color) {
        Technique technique = renderer_->open_technique_text(
            "truth", "pass render_toon surfaces { clear_color " + color + " ; } ;" +
                         "pass wireframe edges { keep_color true ; keep_depth true ; } ;");
        return renderer_->draw(*session_->model(), technique, session_->options(frame_size));
    };
    session_->choose_technique("other");
    session_->set("lines.width", "3");
    session_->choose_technique("plain");
    session_->set_wireframe(true);
    session_->set("surfaces.clear_color", "0 0 1");
    EXPECT_EQ(drawn().difference_from(with_edges("0 0 1")).maximum, 0);
    session_->choose_technique("other");
    EXPECT_EQ(value("lines.width"), "3");
    session_->choose_technique("plain");
    session_->reload();
    EXPECT_EQ(drawn().difference_from(with_edges("0 0 1")).maximum, 0);
    session_->reset_all();
    EXPECT_EQ(drawn().difference_from(with_edges("1 1 1")).maximum, 0);
    session_->choose_technique("other");
    session_->set_wireframe(false);
    session_->choose_technique("plain");
    EXPECT_GT(drawn().difference_from(with_edges("1 1 1")).maximum, 0) << "it is off for all";
}

TEST_F(SessionTest, TheTechniquesThatWereChosenAreKnown) {
    EXPECT_NE(test_support::error_of([&] { session_->choose_technique("nothing"); }), "no error");
    session_->choose_technique("other");
    session_->reload();
    EXPECT_EQ(session_->chosen_techniques(), (std::vector<std::string>{"other", "plain"}));
}

}  // namespace
}  // namespace croquis::viewer
