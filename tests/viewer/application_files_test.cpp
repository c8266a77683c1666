// Files: what is saved draws the same, what is wrong is told, what changes on disk shows.
#include <gtest/gtest.h>

#include "viewer/application_fixture.h"

namespace croquis::viewer {
namespace {

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

}  // namespace
}  // namespace croquis::viewer
