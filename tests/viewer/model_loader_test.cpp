// Reading beside the window: how far it has come, and cancelling in its middle.
#include "viewer/model_loader.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <thread>

#include "support/temporary_folder.h"

namespace croquis::viewer {
namespace {

using namespace std::chrono_literals;
using test_support::TemporaryFolder;

// A wavy sheet of 2 · side² triangles.
std::string sheet(int side) {
    std::string text;
    for (int y = 0; y <= side; ++y) {
        for (int x = 0; x <= side; ++x) text += fmt::format("v {} {} {}\n", x, y, (x * 7 + y * 3) % 5);
    }
    const auto at = [side](int x, int y) { return y * (side + 1) + x + 1; };
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            text += fmt::format("f {} {} {}\nf {} {} {}\n", at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y),
                                at(x + 1, y + 1), at(x, y + 1));
        }
    }
    return text;
}

class LargeModelTest : public ::testing::Test {
protected:
    // Until so much is read.
    void wait_for(int percent) const {
        while (loader_.percent() < percent) std::this_thread::sleep_for(100us);
    }

    TemporaryFolder folder_;
    const std::string large_ = folder_.write("large.obj", sheet(400)).string();
    ModelLoader loader_;
};

TEST_F(LargeModelTest, ALargeModelArrivesAndThenItsSmallCopy) {
    loader_.start(large_, "");
    EXPECT_TRUE(loader_.is_reading());
    std::optional<Model> model, small_copy;
    int last = 0;
    while (loader_.is_busy()) {
        EXPECT_GE(loader_.percent(), last);
        last = loader_.percent();
        const auto arrival = loader_.take();
        if (arrival && arrival->model) model = arrival->model;
        if (arrival && arrival->small_copy) small_copy = arrival->small_copy;
        std::this_thread::sleep_for(1ms);
    }
    ASSERT_TRUE(model && small_copy);
    EXPECT_EQ(model->triangle_count(), 320'000u);
    EXPECT_LE(small_copy->triangle_count(), std::size_t(1.03 * ModelLoader::few_triangles));
    EXPECT_EQ(loader_.percent(), 100);
}

// Soon by the clock of a machine that does nothing else; a busy one takes its share of the time that reading takes.
TEST_F(LargeModelTest, CancellingEndsItSoon) {
    const auto start = std::chrono::steady_clock::now();
    const Model whole = Model::load(large_);
    const auto soon = 200ms + (std::chrono::steady_clock::now() - start) / 4;
    for (const int percent : {0, 20, 50, 70}) {
        loader_.start(large_, "");
        wait_for(percent);
        const auto begun = std::chrono::steady_clock::now();
        loader_.cancel();
        EXPECT_FALSE(loader_.is_reading());
        EXPECT_FALSE(loader_.take());
        EXPECT_TRUE(loader_.stop(10s));
        EXPECT_LT(std::chrono::steady_clock::now() - begun, soon) << percent;
    }
}

TEST_F(LargeModelTest, AnotherModelTakesThePlaceOfTheFirst) {
    const std::string other = folder_.write("other.obj", sheet(2)).string();
    loader_.start(large_, "");
    wait_for(5);
    loader_.start(other, "");
    std::vector<std::string> arrived;
    while (loader_.is_busy()) {
        if (const auto arrival = loader_.take()) arrived.push_back(arrival->path);
        std::this_thread::sleep_for(1ms);
    }
    EXPECT_EQ(arrived, std::vector<std::string>{other});
}

}  // namespace
}  // namespace croquis::viewer
