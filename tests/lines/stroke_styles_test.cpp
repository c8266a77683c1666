// Styles by name, and the shipped ones.
#include <gtest/gtest.h>

#include <cstdlib>

#include "lines/stroke_styles.h"
#include "stroke_drawings.h"
#include "support/errors.h"
#include "support/temporary_folder.h"

namespace croquis::lines {
namespace {

using test_support::error_of;

TEST(StrokeStyles, EarlierFoldersComeFirst) {
    const test_support::TemporaryFolder users, shipped;
    users.write("pencil.stroke", "width 3w\nhidden 2 faint\nclass crease white");
    shipped.write("pencil.stroke", "width 2w");
    shipped.write("faint.stroke", "opacity 0.25");
    shipped.write("white.stroke", "color 1 1 1");
    shipped.write("wavy.stroke", "offsets waves");
    shipped.write("waves.offsets", "length 4\npoint 0 0 0\npoint 2 0 1");
    const StrokeStyles styles({users.path(), shipped.path() / "missing", shipped.path()});
    EXPECT_EQ(styles.names(), (std::vector<std::string>{"faint", "pencil", "wavy", "white"}));
    EXPECT_EQ(styles.style("pencil").width.value, 3);
    ASSERT_TRUE(styles.style("wavy").pattern);
    EXPECT_EQ(styles.style("wavy").pattern->points.size(), 2u);

    const StyleSet set = styles.set("pencil");
    EXPECT_EQ(set.visible[static_cast<std::size_t>(LineClass::crease)].color, glm::vec3(1.0f));
    EXPECT_EQ(set.visible[static_cast<std::size_t>(LineClass::border)].width.value, 3);
    EXPECT_FALSE(set.hidden[0].dash.empty()) << "dashed where no style is named";
    EXPECT_EQ(set.hidden[1].opacity, 0.25f);
    EXPECT_EQ(set.hidden[2].opacity, 0.25f) << "as the layer before";
}

TEST(StrokeStyles, Messages) {
    const test_support::TemporaryFolder folder;
    folder.write("pencil.stroke", "hidden 1 fain");
    folder.write("faint.stroke", "widht 3w");
    folder.write("wavy.stroke", "offsets wavs");
    folder.write("waves.offsets", "length 4\npoint 0 0 0");
    const StrokeStyles styles({folder.path()});
    const std::string prefix = folder.path().string() + "/";
    const auto message = [&](const std::string& name) {
        return test_support::without(error_of([&] { static_cast<void>(styles.set(name)); }), prefix);
    };
    EXPECT_EQ(message("pencl"), R"(there is no stroke style "pencl"; did you mean "pencil"?)");
    EXPECT_EQ(message("../secret"), R"(there is no stroke style "../secret")");
    EXPECT_EQ(message("pencil"), R"(there is no stroke style "fain"; did you mean "faint"?)");
    EXPECT_EQ(message("faint"), R"(faint.stroke:1:1: expected a setting, found "widht"; did you mean "width"?)");
    EXPECT_EQ(message("wavy"), R"(stroke style "wavy": there is no offset file "wavs"; did you mean "waves"?)");
}

TEST(StrokeStyles, TheShippedOnesDrawEverything) {
    const char* data = std::getenv("CROQUIS_DATA");
    ASSERT_NE(data, nullptr);
    const StrokeStyles styles({std::filesystem::path(data) / "strokes"});
    EXPECT_GE(styles.names().size(), 12u);
    Drawing drawing = drawing_of(wave());
    add_line(drawing, circle(90, 60), LineClass::contour, 0, true);
    for (const std::uint32_t layers : {1u, 2u, 3u}) add_line(drawing, wave(), LineClass::crease, layers);
    for (const std::string& name : styles.names()) {
        SCOPED_TRACE(name);
        EXPECT_FALSE(styles.style(name).help.empty());
        StrokeOptions options;
        options.styles = styles.set(name);
        const Strokes strokes = make_strokes(drawing, options);
        std::vector<bool> is_drawn(drawing.lines.size(), false);
        for (const Stroke& stroke : strokes.strokes) is_drawn[stroke.line] = true;
        EXPECT_EQ(std::count(is_drawn.begin(), is_drawn.end(), true), 5);
        for (const Brush& brush : strokes.brushes) {
            if (brush.texture.empty()) continue;
            EXPECT_TRUE(
                std::filesystem::exists(std::filesystem::path(data) / "textures/strokes" / (brush.texture + ".png")));
        }
    }
}

}  // namespace
}  // namespace croquis::lines
