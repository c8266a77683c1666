// Time in a model's animations.
#include "viewer/animation_player.h"

#include <gtest/gtest.h>

#include "support/errors.h"

namespace croquis::viewer {
namespace {

AnimationPlayer with_clips() {
    AnimationPlayer player;
    player.take({{"run", 2.0}, {"stand", 0.0}});
    return player;
}

TEST(AnimationPlayerTest, RestsUntilItPlays) {
    AnimationPlayer player = with_clips();
    player.advance(1);
    EXPECT_EQ(player.clip(), "");
    EXPECT_EQ(player.seconds(), 0);
    player.set_playing(true);
    EXPECT_EQ(player.clip(), "run");
}

TEST(AnimationPlayerTest, AClipBeginsAgainAtItsEnd) {
    AnimationPlayer player = with_clips();
    player.set_playing(true);
    player.advance(1.5);
    EXPECT_DOUBLE_EQ(player.seconds(), 1.5);
    player.advance(1.0);
    EXPECT_DOUBLE_EQ(player.seconds(), 0.5);
    player.set_speed(0.5);
    player.advance(1.0);
    EXPECT_DOUBLE_EQ(player.seconds(), 1.0);
    player.set_playing(false);
    player.advance(1.0);
    EXPECT_DOUBLE_EQ(player.seconds(), 1.0);
}

TEST(AnimationPlayerTest, AModelWithoutClipsCannotPlay) {
    AnimationPlayer player;
    player.set_playing(true);
    EXPECT_FALSE(player.is_playing());
}

TEST(AnimationPlayerTest, AnUnknownClipIsTold) {
    AnimationPlayer player = with_clips();
    EXPECT_EQ(test_support::error_of([&] { player.choose("rnu"); }),
              "the model has no animation \"rnu\"; did you mean \"run\"?");
}

}  // namespace
}  // namespace croquis::viewer
