// Videos are written, and read again by a decoder.
#include "video/video_writer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/errors.h"
#include "support/temporary_folder.h"
#include "video/decoded_video.h"

namespace croquis::video {
namespace {

namespace fs = std::filesystem;
using test_support::decode_video;
using test_support::DecodedVideo;
using test_support::error_of;
using test_support::TemporaryFolder;
using test_support::without;
using Color = std::array<int, 3>;

struct TestPicture {
    int width, height;
    std::vector<std::uint8_t> pixels;

    TestPicture(int of_width, int of_height)
        : width(of_width), height(of_height), pixels(std::size_t(of_width * of_height * 4), 255) {}
    void set(int x, int y, const Color& color) {
        for (std::size_t i = 0; i < 3; ++i) {
            pixels[std::size_t(y * width + x) * 4 + i] = std::uint8_t(color[i]);
        }
    }
    [[nodiscard]] Color color(int x, int y) const {
        const std::uint8_t* pixel = pixels.data() + std::size_t(y * width + x) * 4;
        return {pixel[0], pixel[1], pixel[2]};
    }
    [[nodiscard]] VideoFrame frame() const { return {width, height, pixels}; }
};

TestPicture flat(int width, int height, const Color& color) {
    TestPicture picture(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) picture.set(x, y, color);
    }
    return picture;
}

TestPicture noise(int width, int height, unsigned seed) {
    TestPicture picture(width, height);
    std::mt19937 random(seed);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        if (i % 4 != 3) picture.pixels[i] = std::uint8_t(random());
    }
    return picture;
}

// Six fields of strong colours, another arrangement for each number.
constexpr std::array<Color, 6> strong_colors{
    {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {250, 220, 30}, {255, 255, 255}, {90, 60, 40}}};
Color color_of_field(int number, int field) { return strong_colors[std::size_t(number + field) % 6]; }
TestPicture fields(int width, int height, int number) {
    TestPicture picture(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            picture.set(x, y, color_of_field(number, 3 * x / width + 3 * (2 * y / height)));
        }
    }
    return picture;
}

int difference(const Color& a, const Color& b) {
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

struct Case {
    const char* ending;
    const char* codec;
    int tolerance;   // levels, in flat fields
    double seconds;  // how exact its times are
};
void PrintTo(const Case& given, std::ostream* out) { *out << given.ending; }
constexpr std::array<Case, 4> cases{
    {{".mp4", "h264", 4, 1e-4}, {".webm", "vp9", 6, 1e-3}, {".mkv", "ffv1", 0, 1e-3}, {".gif", "gif", 0, 0.0101}}};

class EachFormat : public ::testing::TestWithParam<Case> {
protected:
    [[nodiscard]] fs::path path() const { return folder_.path() / (std::string("video") + GetParam().ending); }
    TemporaryFolder folder_;
};

TEST_P(EachFormat, KeepsSizeTimesAndColours) {
    constexpr int width = 96, height = 64, count = 8, rate = 25;
    VideoWriter writer(path(), {width, height, rate});
    for (int i = 0; i < count; ++i) writer.add(fields(width, height, i).frame());
    writer.finish();

    const DecodedVideo video = decode_video(path());
    EXPECT_EQ(video.codec, GetParam().codec);
    EXPECT_EQ(video.width, width);
    EXPECT_EQ(video.height, height);
    EXPECT_NEAR(video.frame_rate, rate, 0.01);
    EXPECT_NEAR(video.seconds, double(count) / rate, GetParam().seconds);
    ASSERT_EQ(video.frames.size(), std::size_t(count));
    for (int i = 0; i < count; ++i) {
        EXPECT_NEAR(video.frames[std::size_t(i)].seconds, double(i) / rate, GetParam().seconds);
        for (int field = 0; field < 6; ++field) {
            const int x = (2 * (field % 3) + 1) * width / 6, y = (2 * (field / 3) + 1) * height / 4;
            EXPECT_LE(difference(video.color(std::size_t(i), x, y), color_of_field(i, field)), GetParam().tolerance)
                << "frame " << i << ", field " << field << ": "
                << ::testing::PrintToString(video.color(std::size_t(i), x, y));
        }
    }
    const bool is_yuv = GetParam().codec == std::string("h264") || GetParam().codec == std::string("vp9");
    EXPECT_EQ(video.is_bt709_limited, is_yuv);
}

TEST_P(EachFormat, TakesOddSizes) {
    constexpr int width = 35, height = 21;
    VideoWriter writer(path(), {width, height, 30});
    for (int i = 0; i < 2; ++i) writer.add(fields(width, height, 0).frame());
    writer.finish();
    const DecodedVideo video = decode_video(path());
    const bool is_even = GetParam().ending == std::string(".mp4");
    ASSERT_EQ(video.width, is_even ? 36 : 35);
    ASSERT_EQ(video.height, is_even ? 22 : 21);
    // The corners: first field, third field, and at the bottom fourth and sixth, also where the sides were made even.
    const int right = video.width - 1, below = video.height - 1;
    constexpr int tolerance = 6;
    EXPECT_LE(difference(video.color(1, 0, 0), color_of_field(0, 0)), tolerance);
    EXPECT_LE(difference(video.color(1, right, 0), color_of_field(0, 2)), tolerance);
    EXPECT_LE(difference(video.color(1, 0, below), color_of_field(0, 3)), tolerance);
    EXPECT_LE(difference(video.color(1, right, below), color_of_field(0, 5)), tolerance);
}

TEST_P(EachFormat, RepeatsTheLastFrame) {
    constexpr int size = 32;
    VideoWriter writer(path(), {size, size, 10});
    writer.add(fields(size, size, 0).frame());
    writer.repeat(3);
    writer.add(fields(size, size, 1).frame());
    writer.repeat(0);
    writer.finish();
    const DecodedVideo video = decode_video(path());
    ASSERT_EQ(video.frames.size(), 5u);
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_LE(difference(video.color(i, 2, 2), color_of_field(i < 4 ? 0 : 1, 0)), 6) << i;
        EXPECT_NEAR(video.frames[i].seconds, double(i) / 10, GetParam().seconds);
    }
}

// 48 x 32: a picture twice as wide lies in rows 8 to 23, one of a quarter of the width, twice as high, in columns 21 to
// 26.
TEST_P(EachFormat, FitsPicturesOfOtherSizesIntoTheMiddle) {
    constexpr Color color{200, 120, 40}, black{0, 0, 0};
    VideoWriter writer(path(), {48, 32, 30});
    writer.add(flat(48, 32, color).frame());
    writer.add(flat(96, 32, color).frame());
    writer.add(flat(12, 64, color).frame());
    writer.finish();
    const DecodedVideo video = decode_video(path());
    ASSERT_EQ(video.frames.size(), 3u);
    constexpr int tolerance = 12;  // near an edge, where codecs and scaling leave their traces
    const auto expect = [&](std::size_t frame, int x, int y, const Color& expected) {
        EXPECT_LE(difference(video.color(frame, x, y), expected), tolerance)
            << "frame " << frame << " at " << x << ", " << y << ": "
            << ::testing::PrintToString(video.color(frame, x, y));
    };
    expect(1, 24, 5, black);
    expect(1, 24, 10, color);
    expect(1, 24, 21, color);
    expect(1, 24, 26, black);
    expect(1, 1, 16, color);
    expect(1, 46, 16, color);
    expect(2, 18, 16, black);
    expect(2, 23, 16, color);
    expect(2, 24, 1, color);
    expect(2, 24, 30, color);
    expect(2, 29, 16, black);
}

TEST_P(EachFormat, LeavesNoFileWhereItIsNotFinished) {
    folder_.write(path().filename().string(), "older");
    {
        VideoWriter writer(path(), {32, 32, 30});
        writer.add(flat(32, 32, {1, 2, 3}).frame());
        EXPECT_EQ(read_file(path(), 100), "older");
    }
    EXPECT_EQ(read_file(path(), 100), "older");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), {}), 1);
}

TEST_P(EachFormat, TellsThatTheDiskIsFull) {
    fs::create_symlink("/dev/full", path());
    const std::string error = error_of([&] {
        VideoWriter writer(path(), {32, 32, 30});
        for (unsigned i = 0; i < 4; ++i) writer.add(noise(32, 32, i).frame());
        writer.finish();
    });
    EXPECT_EQ(error, path().string() + ": No space left on device");
}

INSTANTIATE_TEST_SUITE_P(Video, EachFormat, ::testing::ValuesIn(cases),
                         [](const auto& parameter) { return std::string(parameter.param.codec); });

TEST(VideoWriter, LosesNothingInMkv) {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "noise.mkv";
    VideoWriter writer(path, {53, 37, 30});
    for (unsigned i = 0; i < 3; ++i) writer.add(noise(53, 37, i).frame());
    writer.finish();
    const DecodedVideo video = decode_video(path);
    ASSERT_EQ(video.frames.size(), 3u);
    for (unsigned i = 0; i < 3; ++i) EXPECT_EQ(video.frames[i].pixels, noise(53, 37, i).pixels);
}

// A colour ramp has more colours than a GIF: what it shows lies near.
TEST(VideoWriter, ChoosesTheColoursOfAGif) {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "ramp.gif";
    TestPicture ramp(128, 64);
    for (int y = 0; y < ramp.height; ++y) {
        for (int x = 0; x < ramp.width; ++x) ramp.set(x, y, {2 * x, 4 * y, 128});
    }
    VideoWriter writer(path, {ramp.width, ramp.height, 30});
    writer.add(ramp.frame());
    writer.finish();
    const DecodedVideo video = decode_video(path);
    double sum = 0;
    for (int y = 0; y < ramp.height; ++y) {
        for (int x = 0; x < ramp.width; ++x) sum += difference(video.color(0, x, y), ramp.color(x, y));
    }
    EXPECT_LT(sum / (ramp.width * ramp.height), 16);
}

TEST(VideoWriter, PutsTheIndexOfAnMp4First) {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "a.mp4";
    VideoWriter writer(path, {32, 32, 30});
    writer.add(flat(32, 32, {1, 2, 3}).frame());
    writer.finish();
    const std::string bytes = read_file(path, 1 << 20);
    EXPECT_LT(bytes.find("moov"), bytes.find("mdat"));
}

TEST(VideoWriter, TellsWhatCannotBe) {
    const TemporaryFolder folder;
    const auto error = [&](const std::string& name, const VideoOptions& options) {
        return without(error_of([&] { VideoWriter(folder.path() / name, options); }), folder.path().string() + "/");
    };
    EXPECT_EQ(error("a.avi", {32, 32, 30}),
              "a.avi: expected a video ending in .mp4, .webm, .mkv, .gif, found \".avi\"");
    EXPECT_EQ(error("a", {32, 32, 30}), "a: expected a video ending in .mp4, .webm, .mkv, .gif, found \"\"");
    EXPECT_EQ(error("a.MP4", {0, 32, 30}), "a.MP4: expected a video of 1 to 16384 pixels a side, found 0x32");
    EXPECT_EQ(error("a.mkv", {32, 16385, 30}), "a.mkv: expected a video of 1 to 16384 pixels a side, found 32x16385");
    EXPECT_EQ(error("a.mp4", {32, 32, 0}), "a.mp4: expected 1 to 240 frames a second, found 0");
    EXPECT_EQ(error("a.gif", {32, 32, 60}), "a.gif: expected 1 to 50 frames a second, found 60");
    EXPECT_EQ(error("b/a.mp4", {32, 32, 30}), "b/a.mp4: folder b does not exist");
    fs::create_directory(folder.path() / "c.mp4");
    EXPECT_EQ(error("c.mp4", {32, 32, 30}), "c.mp4: expected a file name, found a folder");
    EXPECT_EQ(without(error_of([&] {
                          VideoWriter(folder.path() / "d.webm", {32, 32, 30}).finish();
                      }),
                      folder.path().string() + "/"),
              "d.webm: expected at least one frame, found none");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1) << "nothing was written";
}

}  // namespace
}  // namespace croquis::video
