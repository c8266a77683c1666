// Pictures that are drawn beside the window: the same as drawn directly, the newest alone, and none that is too late.
#include "viewer/painter.h"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <thread>

#include "api/shapes.h"

namespace croquis::viewer {
namespace {

using test_support::small;
using test_support::TemporaryFolder;
using test_support::torus_file;
using Kind = Painter::Purpose::Kind;
using namespace std::chrono_literals;

constexpr const char* plain_text = "pass render_toon surfaces {} ;";

class PainterTest : public ::testing::Test {
protected:
    static Painter::Order order(const std::string& text, long long revision,
                                const Painter::Purpose& purpose = {Kind::full_picture, {}}) {
        return {.purpose = purpose,
                .technique = "test",
                .text = text,
                .model = model(),
                .options = small(),
                .revision = revision};
    }
    static const Model& model() {
        static const Model torus = torus_file();
        return torus;
    }
    // All that comes until nothing more can.
    static std::vector<Painter::Delivery> deliveries(Painter& painter) {
        std::vector<Painter::Delivery> all;
        while (painter.has_work()) {
            while (auto one = painter.take()) all.push_back(std::move(*one));
            std::this_thread::sleep_for(1ms);
        }
        return all;
    }
    static std::string written(const TemporaryFolder& folder) { return (folder.path() / "picture.png").string(); }
};

TEST_F(PainterTest, APictureIsTheOneThatIsDrawnDirectly) {
    std::atomic<int> woken = 0;
    Painter painter({}, [&] { ++woken; });
    painter.order(order(plain_text, 7));
    const auto delivered = deliveries(painter);
    ASSERT_EQ(delivered.size(), 1u);
    ASSERT_TRUE(delivered[0].picture) << delivered[0].error;
    EXPECT_EQ(delivered[0].order.revision, 7);
    EXPECT_GT(delivered[0].milliseconds, 0);
    EXPECT_EQ(woken, 1);
    Renderer renderer = Renderer::headless();
    Technique technique = renderer.open_technique_text("test", plain_text);
    const Picture direct = renderer.draw(model(), technique, small());
    EXPECT_EQ(delivered[0].picture->difference_from(direct).maximum, 0);
}

TEST_F(PainterTest, OfSeveralOrdersForTheSameOnlyTheNewestArrives) {
    Painter painter({}, [] {});
    painter.order(order(plain_text, 0));
    EXPECT_EQ(deliveries(painter).size(), 1u);
    for (int i = 1; i <= 3; ++i) painter.order(order(plain_text, i));
    Painter::Order slow = order(plain_text, 4);
    slow.options = small(1600, 1200);
    slow.options.samples = 4;
    painter.order(slow);
    std::this_thread::sleep_for(20ms);  // it is begun, and far from done
    painter.order(order(plain_text, 5));
    painter.order(order(plain_text, 6, {Kind::small_picture, "other"}));
    const auto delivered = deliveries(painter);
    ASSERT_EQ(delivered.size(), 2u) << "another purpose is another picture";
    EXPECT_EQ(delivered[0].order.revision, 5);
    EXPECT_EQ(delivered[1].order.revision, 6);
}

TEST_F(PainterTest, WhatIsTakenBackDoesNotArrive) {
    Painter painter({}, [] {});
    for (const auto wait : {0ms, 5ms, 500ms}) {  // before it is begun, while it is drawn, when it is done
        painter.order(order(plain_text, 1));
        std::this_thread::sleep_for(wait);
        painter.withdraw({Kind::full_picture, {}});
        EXPECT_FALSE(painter.has_order({Kind::full_picture, {}}));
        EXPECT_TRUE(deliveries(painter).empty());
    }
}

TEST_F(PainterTest, AMistakeIsToldAndEndsNothing) {
    Painter painter({}, [] {});
    painter.order(order("pass nothing ;", 1));
    auto delivered = deliveries(painter);
    ASSERT_EQ(delivered.size(), 1u);
    EXPECT_FALSE(delivered[0].picture);
    EXPECT_NE(delivered[0].error.find("unknown component \"nothing\""), std::string::npos) << delivered[0].error;
    painter.order(order(plain_text, 2));
    delivered = deliveries(painter);
    ASSERT_EQ(delivered.size(), 1u);
    EXPECT_TRUE(delivered[0].picture) << delivered[0].error;
}

TEST_F(PainterTest, WithoutAContextItSaysWhy) {
    Painter painter({.api = "crayon", .device = {}, .data_folders = {}}, [] {});
    EXPECT_EQ(painter.failure(), "") << "nothing was asked for yet";
    painter.order(order(plain_text, 1));
    EXPECT_TRUE(deliveries(painter).empty());
    EXPECT_NE(painter.failure().find("crayon"), std::string::npos);
    painter.order(order(plain_text, 2));
    EXPECT_FALSE(painter.has_work());
    EXPECT_TRUE(painter.stop(1s));
}

// A shader that is changed shows in the next picture; one that became wrong leaves the one that was good.
TEST_F(PainterTest, ChangedFilesShow) {
    const TemporaryFolder folder;
    const auto paint = [&](const std::string& color) {
        folder.write("shaders/paint.glsl",
                     "#ifdef FRAGMENT_STAGE\nvec4 paint() { return vec4(" + color + "); }\n#endif\n");
    };
    folder.write("components/paint.component",
                 "component paint : process_texture { modify fragment_program { default \"paint:paint\" ; } ; } ;");
    std::filesystem::create_directories(folder.path() / "techniques");
    paint("1.0, 0.0, 0.0, 1.0");
    Painter painter({.api = {}, .device = {}, .data_folders = {folder.path().string()}}, [] {});
    const auto red_of_picture = [&] {
        painter.order(order("pass paint paper { texture \"toon:two_tone\" ; } ;", 1));
        const auto delivered = deliveries(painter);
        EXPECT_TRUE(delivered.size() == 1 && delivered[0].picture);
        return delivered.empty() || !delivered[0].picture ? -1 : int(delivered[0].picture->pixels()[0]);
    };
    EXPECT_EQ(red_of_picture(), 255);
    paint("0.0, 0.0, 0.0, 1.0");
    EXPECT_EQ(red_of_picture(), 255);
    painter.reload();
    EXPECT_EQ(red_of_picture(), 0);
    paint("nonsense");
    painter.reload();
    EXPECT_EQ(red_of_picture(), 0);
}

TEST_F(PainterTest, WhatIsForAFileIsWrittenEvenAtTheEnd) {
    const TemporaryFolder folder;
    {
        Painter painter({}, [] {});
        painter.order(order(plain_text, 1));
        painter.order(order(plain_text, 1, {Kind::file, written(folder)}));
        EXPECT_TRUE(painter.stop(10s));
        painter.order(order(plain_text, 2));
        EXPECT_FALSE(painter.has_order({Kind::full_picture, {}})) << "it begins nothing more";
    }
    EXPECT_EQ(Picture::read(written(folder)).width(), small().width);
}

TEST_F(PainterTest, ItCanGoInTheMiddleOfAnything) {
    for (const auto wait : {0ms, 1ms, 20ms, 60ms}) {
        Painter painter({}, [] {});
        for (int i = 0; i < 20; ++i) painter.order(order(plain_text, i, {Kind::small_picture, std::to_string(i)}));
        std::this_thread::sleep_for(wait);
        const auto begun = std::chrono::steady_clock::now();
        EXPECT_TRUE(painter.stop(5s));
        EXPECT_LT(std::chrono::steady_clock::now() - begun, 5s);
    }
}

}  // namespace
}  // namespace croquis::viewer
