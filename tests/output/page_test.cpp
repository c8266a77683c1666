// Numbers, names and text in files.
#include <gtest/gtest.h>

#include "output/pdf.h"
#include "output/sheet.h"
#include "output/svg.h"
#include "output/vector_page.h"

namespace croquis::output {
namespace {

TEST(Page, NumbersAreShort) {
    const std::pair<double, const char*> cases[] = {
        {0, "0"},       {12, "12"},        {0.35, "0.35"},   {-3.5, "-3.5"},         {0.0004, "0"},
        {-0.0004, "0"}, {0.0005, "0.001"}, {-0.25, "-0.25"}, {270.93333, "270.933"}, {1234567.001, "1234567.001"},
        {9.9996, "10"}};
    for (const auto& [number, text] : cases) EXPECT_EQ(number_text(number), text);
}

TEST(Page, NamesAreValidAndUnique) {
    NameGiver names;
    EXPECT_EQ(names.name("visible-contour", "left wing"), "visible-contour-left_wing");
    EXPECT_EQ(names.name("visible-contour", "left_wing"), "visible-contour-left_wing-2");
    EXPECT_EQ(names.name("visible-contour", "left\"wing"), "visible-contour-left_wing-3");
    EXPECT_EQ(names.name("visible-contour", "left_wing-2"), "visible-contour-left_wing-2-2");
    EXPECT_EQ(names.name("fill"), "fill");
    EXPECT_EQ(names.name("fill"), "fill-2");
    EXPECT_EQ(names.name("a", std::string(1000, 'x')).size(), 82u);
}

TEST(Page, TextIsGoodXml) {
    EXPECT_EQ(xml_text("a & b < \"c\" > d"), "a &amp; b &lt; &quot;c&quot; &gt; d");
    EXPECT_EQ(xml_text("caf\xc3\xa9 \xe2\x82\xac \xf0\x9f\x98\x80"), "caf\xc3\xa9 \xe2\x82\xac \xf0\x9f\x98\x80");
    const std::string sign = "\xef\xbf\xbd";
    for (const char* bad : {"\xff", "\xc0\x80", "\xed\xa0\x80", "\xef\xbf\xbf", "\xf5\x80\x80\x80", "\x01", "\xc3"}) {
        const std::string clean = clean_text(bad);
        EXPECT_FALSE(clean.empty());
        EXPECT_EQ(clean.size() % 3, 0u) << clean;
        for (std::size_t i = 0; i < clean.size(); i += 3) EXPECT_EQ(clean.substr(i, 3), sign);
    }
}

TEST(Page, FrameLiesInTheMiddleOfTheSheet) {
    const Sheet sheet = lay_out({210, 297, 10}, 1900, 950);
    EXPECT_DOUBLE_EQ(sheet.mm_per_pixel, 0.1);
    EXPECT_DOUBLE_EQ(sheet.origin.x, 10);
    EXPECT_DOUBLE_EQ(sheet.origin.y, 0.5 * (297 - 95));
    const Sheet own = lay_out({0, 0, 5}, 960, 480);
    EXPECT_NEAR(own.width, 264, 1e-9);
    EXPECT_NEAR(own.height, 137, 1e-9);
}

TEST(Page, EmptyGroupsAreLeftOut) {
    VectorPage page;
    page.title = "nothing";
    page.groups.push_back({.id = "a", .title = {}, .layer = {}, .ink = {}, .paths = {}, .texts = {}, .groups = {}});
    EXPECT_EQ(svg_text(page).find("<g"), std::string::npos);
    EXPECT_EQ(pdf_bytes(page).substr(0, 5), "%PDF-");
}

}  // namespace
}  // namespace croquis::output
