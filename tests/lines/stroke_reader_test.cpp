// Stroke styles and offset files: what they set, and the exact errors for wrong ones, which are interface.
#include <gtest/gtest.h>

#include "lines/stroke_style.h"
#include "support/errors.h"

namespace croquis::lines {
namespace {

using test_support::error_of;

std::string style_error(const std::string& text) {
    return error_of([&] { static_cast<void>(read_stroke_style(text, "a.stroke")); });
}

std::string offsets_error(const std::string& text) {
    return error_of([&] { static_cast<void>(read_offsets(text, "a.offsets")); });
}

TEST(StrokeReader, ReadsEverySetting) {
    const StrokeStyle style = read_stroke_style(
        "\xef\xbb\xbf# A comment.\r\n"
        "help All that there is. # not this\r\n"
        "width 1.5w\nfull_width_from 3mm\n  color 0.1 0.2 0.3   # and a comment\nopacity .5\nends butt\ntexture "
        "charcoal\n"
        "taper 10px 25%\ntaper_to 0.25\novershoot 2mm 0.5\nwidth_by_light 2 0.5\nwidth_by_depth 3 1\n"
        "vary_width 0.1 20px\nvary_opacity 0.2 30px\nvary_color 0.3 4mm\n"
        "wobble 1px 2w 40px\nwobble 3px 0px 5px\npasses 3\ncorner_angle 90\n"
        "dash 4px 2px 1w 2px\ndash_fit yes\noffset_scale 2\noffset_run once\n"
        "hidden 1 faint\nhidden 3 dotted-2\nclass crease white_line",
        "a.stroke");
    using Unit = Length::Unit;
    EXPECT_EQ(style.help, "All that there is.");
    EXPECT_EQ(style.width, (Length{1.5, Unit::widths}));
    EXPECT_EQ(style.full_width_from, (Length{3, Unit::millimetres}));
    EXPECT_EQ(style.color, glm::vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(style.opacity, 0.5f);
    EXPECT_EQ(style.ends, StrokeEnds::butt);
    EXPECT_EQ(style.texture, "charcoal");
    EXPECT_EQ(style.taper_start, (Length{10, Unit::pixels}));
    EXPECT_EQ(style.taper_end, (Length{0.25, Unit::share}));
    EXPECT_EQ(style.taper_to, 0.25);
    EXPECT_EQ(style.overshoot, (Length{2, Unit::millimetres}));
    EXPECT_EQ(style.overshoot_variation, 0.5);
    EXPECT_EQ(style.width_by_light, (WidthRange{2, 0.5}));
    EXPECT_EQ(style.width_by_depth, (WidthRange{3, 1}));
    EXPECT_EQ(style.vary_width, (Variation{0.1, {20, Unit::pixels}}));
    EXPECT_EQ(style.vary_opacity, (Variation{0.2, {30, Unit::pixels}}));
    EXPECT_EQ(style.vary_color, (Variation{0.3, {4, Unit::millimetres}}));
    ASSERT_EQ(style.wobbles.size(), 2u);
    EXPECT_EQ(style.wobbles[0], (Wobble{{1, Unit::pixels}, {2, Unit::widths}, {40, Unit::pixels}}));
    EXPECT_EQ(style.passes, 3u);
    EXPECT_NEAR(style.corner_angle.value(), 1.5707963267948966, 1e-15);
    ASSERT_EQ(style.dash.size(), 4u);
    EXPECT_EQ(style.dash[2], (Length{1, Unit::widths}));
    EXPECT_TRUE(style.dash_fit);
    EXPECT_EQ(style.offset_scale, 2);
    EXPECT_EQ(style.offset_run, OffsetRun::once);
    EXPECT_EQ(style.hidden_styles, (std::array<std::string, 3>{"faint", "", "dotted-2"}));
    EXPECT_EQ(style.class_styles[static_cast<std::size_t>(LineClass::crease)], "white_line");
}

TEST(StrokeReader, AnEmptyTextIsThePlainStyle) {
    const StrokeStyle style = read_stroke_style("", "a.stroke");
    EXPECT_EQ(style.width, (Length{1, Length::Unit::widths}));
    EXPECT_EQ(style.passes, 1u);
    EXPECT_TRUE(style.dash.empty());
}

TEST(StrokeReader, LengthsInPixels) {
    const LengthScale scale{2, 5, 300};
    EXPECT_DOUBLE_EQ(pixels_of({3, Length::Unit::pixels}, scale), 6);
    EXPECT_DOUBLE_EQ(pixels_of({25.4, Length::Unit::millimetres}, scale), 192);
    EXPECT_DOUBLE_EQ(pixels_of({1.5, Length::Unit::widths}, scale), 7.5);
    EXPECT_DOUBLE_EQ(pixels_of({0.1, Length::Unit::share}, scale), 30);
}

TEST(StrokeReader, MessagesOfStyles) {
    const struct {
        std::string text, message;
    } cases[] = {
        {"widht 2w", R"(a.stroke:1:1: expected a setting, found "widht"; did you mean "width"?)"},
        {"\n\n  nonsense", R"(a.stroke:3:3: expected a setting, found "nonsense")"},
        {"width", "a.stroke:1:6: expected a length such as 3px, 0.5mm, 2w or 10%, found the end of the line"},
        {"width 2", R"(a.stroke:1:7: expected a length such as 3px, 0.5mm, 2w or 10%, found "2")"},
        {"width -1px", R"(a.stroke:1:7: expected a length from 0 to 10000, found "-1px")"},
        {"width nanpx", R"(a.stroke:1:7: expected a length such as 3px, 0.5mm, 2w or 10%, found "nanpx")"},
        {"width 1e999px", R"(a.stroke:1:7: expected a length such as 3px, 0.5mm, 2w or 10%, found "1e999px")"},
        {"width 2w 3w", R"(a.stroke:1:10: expected the end of the line, found "3w")"},
        {"width 2w\nwidth 2w", R"(a.stroke:2:1: expected "width" only once, found it in line 1 already)"},
        {"color 0 0", "a.stroke:1:10: expected a number from 0 to 1, found the end of the line"},
        {"color 0 0 1.5", R"(a.stroke:1:11: expected a number from 0 to 1, found "1.5")"},
        {"opacity half", R"(a.stroke:1:9: expected a number from 0 to 1, found "half")"},
        {"ends rond", R"(a.stroke:1:6: expected "round" or "butt", found "rond"; did you mean "round"?)"},
        {"texture ../secret",
         R"(a.stroke:1:9: expected the name of an image of letters, digits, '_' and '-', found "../secret")"},
        {"passes 2.5", "a.stroke:1:8: expected a whole number, found 2.5"},
        {"passes 17", R"(a.stroke:1:8: expected a number from 1 to 16, found "17")"},
        {"dash 3px", "a.stroke:1:6: expected a gap after each dash, found an odd number of lengths"},
        {"dash 0px 0px", "a.stroke:1:10: expected a dash or a gap longer than 0"},
        {"dash 1px 1px 1px 1px 1px 1px 1px 1px 1px 1px 1px 1px 1px 1px 1px 1px 1px",
         "a.stroke:1:70: expected at most 16 lengths of dashes and gaps"},
        {"wobble 1px 1px 10%", "a.stroke:1:16: expected the size of wiggles in px or mm"},
        {"vary_width 0.5 1px", R"(a.stroke:1:16: expected a length from 2 to 10000, found "1px")"},
        {"offset_run stretch", R"(a.stroke:1:12: expected "repeat", "fit" or "once", found "stretch")"},
        {"hidden 4 faint", R"(a.stroke:1:8: expected a number from 1 to 3, found "4")"},
        {"hidden 1", "a.stroke:1:9: expected the name of a style, found the end of the line"},
        {"class creese white_line",
         R"(a.stroke:1:7: expected "contour", "silhouette", "border", "tagged", "crease", "intersection" or )"
         R"("material", found "creese"; did you mean "crease"?)"},
        {"dash 1px 1px\noffsets loops",
         "a.stroke: expected either \"dash\" or \"offsets\", found both: breaks of an offset file make dashes too"},
        {std::string("\x01") + std::string(60, 'x'),
         "a.stroke:1:1: expected a setting, found \"?" + std::string(39, 'x') + "...\""},
        {std::string((1 << 20) + 1, ' '), "a.stroke: expected at most 1048576 bytes, found 1048577"},
    };
    for (const auto& c : cases) EXPECT_EQ(style_error(c.text), c.message) << c.text.substr(0, 80);
}

TEST(StrokeReader, WobblesAreBounded) {
    std::string text;
    for (int i = 0; i < 5; ++i) text += "wobble 1px 1px 10px\n";
    EXPECT_EQ(style_error(text), "a.stroke:5:1: expected \"wobble\" at most 4 times");
}

TEST(StrokeReader, ReadsOffsets) {
    const OffsetPattern pattern =
        read_offsets("help Dots.\nlength 12.5\npoint 0 0 0 # the first\npoint 6 -2 1.5\nbreak\npoint 5 1e1 -3\nbreak\n",
                     "a.offsets");
    EXPECT_EQ(pattern.help, "Dots.");
    EXPECT_EQ(pattern.length, 12.5);
    ASSERT_EQ(pattern.points.size(), 3u);
    EXPECT_EQ(pattern.points[1].along, 6);
    EXPECT_EQ(pattern.points[1].tangent, -2);
    EXPECT_EQ(pattern.points[1].normal, 1.5);
    EXPECT_TRUE(pattern.points[1].joined);
    EXPECT_FALSE(pattern.points[2].joined);
    EXPECT_FALSE(pattern.points[0].joined) << "a break at the end parts one pattern from the next";
    EXPECT_TRUE(read_offsets("length 1\npoint 0 0 0", "b").points[0].joined);
}

TEST(StrokeReader, MessagesOfOffsets) {
    const struct {
        std::string text, message;
    } cases[] = {
        {"", "a.offsets: expected at least one point, found none"},
        {"point 0 0 0", "a.offsets:1:1: expected \"length\" before the first point"},
        {"length 0.5", R"(a.offsets:1:8: expected a number from 1 to 10000, found "0.5")"},
        {"length 5\nlength 6", "a.offsets:2:1: expected \"length\" only once"},
        {"length 5\npoint 6 0 0", R"(a.offsets:2:7: expected a number from 0 to 5, found "6")"},
        {"length 5\npoint 1 0", "a.offsets:2:10: expected a number from -10000 to 10000, found the end of the line"},
        {"length 5\npiont 1 0 0",
         R"(a.offsets:2:1: expected "length", "point", "break" or "help", found "piont"; did you mean "point"?)"},
        {"length 5\npoint 1 0 0 7", R"(a.offsets:2:13: expected the end of the line, found "7")"},
    };
    for (const auto& c : cases) EXPECT_EQ(offsets_error(c.text), c.message) << c.text;
    std::string many = "length 5\n";
    for (std::size_t i = 0; i <= most_offset_points; ++i) many += "point 1 0 0\n";
    EXPECT_EQ(offsets_error(many), "a.offsets:4098:1: expected at most 4096 points");
}

}  // namespace
}  // namespace croquis::lines
