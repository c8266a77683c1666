// Who draws what, and how finely: the window while something moves, the painter beside it in full.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "viewer/application_fixture.h"

namespace croquis::viewer {
namespace {

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

}  // namespace
}  // namespace croquis::viewer
