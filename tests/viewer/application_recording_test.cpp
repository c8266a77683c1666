// Videos of what is seen.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <thread>

#include "video/decoded_video.h"
#include "viewer/application_fixture.h"

namespace croquis::viewer {
namespace {

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

}  // namespace
}  // namespace croquis::viewer
