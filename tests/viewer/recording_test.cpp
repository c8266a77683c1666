// Recordings at times that the test says, read again by a decoder.
#include "viewer/recording.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/temporary_folder.h"
#include "video/decoded_video.h"

namespace croquis::viewer {
namespace {

using std::chrono::milliseconds;
using test_support::decode_video;
using test_support::DecodedVideo;
using test_support::TemporaryFolder;

constexpr int side = 16;

// A picture that says its number.
Picture numbered(int number) {
    std::vector<std::uint8_t> pixels(std::size_t{side} * side * 4, 255);
    for (std::size_t i = 0; i < pixels.size(); i += 4) pixels[i] = std::uint8_t(number);
    return {side, side, std::move(pixels)};
}

std::vector<int> numbers(const DecodedVideo& video) {
    std::vector<int> found;
    for (std::size_t i = 0; i < video.frames.size(); ++i) found.push_back(video.color(i, 3, 3)[0]);
    return found;
}

// Frame n, at n / 30 seconds, shows the last picture that came by then; what came and went between two frames is seen
// in none.
TEST(Recording, ShowsEachPictureForAsLongAsItStood) {
    const TemporaryFolder folder;
    const std::string path = (folder.path() / "a.mkv").string();
    const Recording::Time begun = std::chrono::steady_clock::now();
    Recording recording(path, numbered(1), begun);
    recording.add(numbered(2), begun + milliseconds(90));   // frame 3 is at 100 ms
    recording.add(numbered(3), begun + milliseconds(101));  // frame 4 at 133
    recording.add(numbered(4), begun + milliseconds(120));
    recording.add(numbered(5), begun + milliseconds(290));  // frame 9 at 300
    recording.end(begun + milliseconds(390));               // frame 12 at 400 is no more
    recording.wait();
    EXPECT_TRUE(recording.is_over());
    EXPECT_EQ(recording.error(), "");
    const DecodedVideo video = decode_video(path);
    EXPECT_EQ(video.frame_rate, 30);
    EXPECT_EQ(numbers(video), (std::vector<int>{1, 1, 1, 2, 4, 4, 4, 4, 4, 5, 5, 5}));
}

TEST(Recording, OfAMomentHasAFrame) {
    const TemporaryFolder folder;
    const std::string path = (folder.path() / "a.mkv").string();
    const Recording::Time begun = std::chrono::steady_clock::now();
    Recording recording(path, numbered(7), begun);
    recording.end(begun);
    recording.wait();
    EXPECT_EQ(numbers(decode_video(path)), std::vector<int>{7});
}

// So many pictures at once that most must be left out: times stay right, none is seen too soon, the last is seen.
TEST(Recording, LeavesPicturesOutWhereTheEncoderFallsBehind) {
    const TemporaryFolder folder;
    const std::string path = (folder.path() / "a.mkv").string();
    const Recording::Time begun = std::chrono::steady_clock::now();
    constexpr std::size_t room_for_two = 0;
    constexpr int count = 60;
    Recording recording(path, numbered(0), begun, room_for_two);
    for (int i = 1; i < count; ++i) recording.add(numbered(i), begun + milliseconds(1000 * i / 30 - 5));
    recording.end(begun + milliseconds(1000 * count / 30 - 5));
    recording.wait();
    const std::vector<int> seen = numbers(decode_video(path));
    ASSERT_EQ(seen.size(), std::size_t{count});
    EXPECT_EQ(seen.back(), count - 1);
    int left_out = 0;
    for (int i = 0; i < count; ++i) {
        EXPECT_LE(seen[std::size_t(i)], i);
        EXPECT_GE(seen[std::size_t(i)], seen[std::size_t(std::max(i - 1, 0))]);
        left_out += seen[std::size_t(i)] != i ? 1 : 0;
    }
    EXPECT_GT(left_out, 0);
}

TEST(Recording, TellsThatItCannotWrite) {
    const TemporaryFolder folder;
    const std::string path = (folder.path() / "missing" / "a.mp4").string();
    const Recording::Time begun = std::chrono::steady_clock::now();
    Recording recording(path, numbered(0), begun);
    recording.add(numbered(1), begun + milliseconds(40));
    recording.end(begun + milliseconds(90));
    recording.wait();
    EXPECT_TRUE(recording.is_over());
    EXPECT_EQ(recording.error(), path + ": folder " + (folder.path() / "missing").string() + " does not exist");
    recording.add(numbered(2), begun + milliseconds(100));  // nobody takes it any more
}

TEST(Recording, IsWrittenWhereNobodyEndsIt) {
    const TemporaryFolder folder;
    const std::string path = (folder.path() / "a.mkv").string();
    { const Recording recording(path, numbered(9), std::chrono::steady_clock::now()); }
    EXPECT_GE(decode_video(path).frames.size(), 1u);
}

}  // namespace
}  // namespace croquis::viewer
