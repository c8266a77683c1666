// Times per stretch of drawing (row B3).
#include "gpu/timer.h"

#include <gtest/gtest.h>

#include "gpu/framebuffer.h"
#include "support/studio.h"

namespace croquis::gpu {
namespace {

class TimerTest : public test_support::StudioTest {
protected:
    static void draw(int side) {
        const Framebuffer target(studio().context(),
                                 std::make_shared<Texture>(studio().context(), TextureFormat::rgba8, side, side),
                                 nullptr);
        const auto program = studio().resources().program("image:full_screen", "test_image:place_as_color");
        target.bind();
        program->use();
        apply({});
        studio().resources().draw_full_screen();
    }
};

TEST_F(TimerTest, GivesAPositiveTimeForEachStretch) {
    StretchTimer timer(studio().context());
    for (int i = 0; i < 3; ++i) {
        timer.begin();
        draw(64);
        timer.end();
    }
    const std::vector<double> times = timer.milliseconds();
    ASSERT_EQ(times.size(), 3u);
    for (const double time : times) EXPECT_GT(time, 0.0);
    EXPECT_TRUE(timer.milliseconds().empty()) << "times are handed out once";
}

TEST_F(TimerTest, MoreWorkTakesLonger) {
    StretchTimer timer(studio().context());
    draw(16);  // links the program outside the measurement
    timer.begin();
    draw(16);
    timer.end();
    timer.begin();
    draw(2048);
    timer.end();
    const std::vector<double> times = timer.milliseconds();
    EXPECT_GT(times.at(1), times.at(0));
}

}  // namespace
}  // namespace croquis::gpu
