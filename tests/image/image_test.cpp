// Pictures in memory: decoding, its errors, and how far two lie apart.
#include "image/image.h"

#include <gtest/gtest.h>

#include <string>

#include "base/random.h"
#include "support/errors.h"
#include "support/temporary_folder.h"

namespace croquis::image {
namespace {

using test_support::error_of;
using test_support::TemporaryFolder;

Image decode_text(const std::string& bytes) { return decode(std::as_bytes(std::span(bytes)), "picture"); }

// A binary PPM of that size, filled with one colour.
std::string ppm(int width, int height, const std::string& pixel) {
    std::string bytes = "P6\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n";
    for (int i = 0; i < width * height; ++i) bytes += pixel;
    return bytes;
}

TEST(Decode, GivesRowsFromTheTopWithFullAlpha) {
    const Image image = decode_text("P6\n2 2\n255\n" + std::string("\x01\x02\x03\x04\x05\x06\x07\x08\x09\x0a\x0b\x0c"));
    ASSERT_EQ(image.width(), 2);
    ASSERT_EQ(image.height(), 2);
    EXPECT_EQ(image.at(0, 0), glm::u8vec4(1, 2, 3, 255));
    EXPECT_EQ(image.at(1, 0), glm::u8vec4(4, 5, 6, 255));
    EXPECT_EQ(image.at(0, 1), glm::u8vec4(7, 8, 9, 255));
}

TEST(Decode, TellsWhatIsNoImage) {
    EXPECT_EQ(error_of([] { (void)decode_text("not an image"); }),
              "picture: expected an image, found 12 bytes that are none (unknown image type)");
    EXPECT_EQ(error_of([] { (void)decode_text(""); }).substr(0, 54),
              "picture: expected an image, found 0 bytes that are non");
}

TEST(Decode, RefusesMoreThanTheLongestSide) {
    const std::string message = error_of([] { (void)decode_text("P6\n40000 1\n255\n" + std::string(120000, 'x')); });
    EXPECT_EQ(message.substr(0, 33), "picture: expected an image, found");
}

TEST(Decode, SurvivesCutAndDamagedFiles) {
    const std::string whole = ppm(16, 16, "abc");
    const Random random(5, "damage");
    for (std::size_t length = 0; length < whole.size(); length += 7) {
        std::string damaged = whole.substr(0, length);
        if (!damaged.empty()) damaged[random.bits(length) % damaged.size()] = char(random.bits(length + 1));
        try {
            const Image image = decode_text(damaged);
            EXPECT_LE(image.width(), longest_side);
        } catch (const Error&) {
        }
    }
}

TEST(Read, NamesTheFile) {
    const TemporaryFolder folder;
    const auto missing = folder.path() / "missing.png";
    const auto text = folder.write("text.png", "hello");
    EXPECT_EQ(error_of([&] { (void)read(missing); }), missing.string() + ": no such file");
    EXPECT_EQ(error_of([&] { (void)read(text); }),
              text.string() + ": expected an image, found 5 bytes that are none (unknown image type)");
}

TEST(Read, GoesByContentNotByName) {
    const TemporaryFolder folder;
    EXPECT_EQ(read(folder.write("wrong.png", ppm(3, 2, "abc"))), Image(3, 2, {'a', 'b', 'c', 255}));
}

TEST(Compare, GivesMeanAndMaximumOverFourChannels) {
    const Image a(2, 2, {10, 20, 30, 255});
    Image b = a;
    EXPECT_EQ(compare(a, b).mean, 0.0);
    EXPECT_EQ(compare(a, b).maximum, 0);
    b.at(1, 1) = {14, 10, 30, 255};
    EXPECT_DOUBLE_EQ(compare(a, b).mean, 14.0 / 16.0);
    EXPECT_EQ(compare(a, b).maximum, 10);
    EXPECT_DOUBLE_EQ(compare(b, a).mean, 14.0 / 16.0);
    b = a;
    b.at(0, 0).w = 0;
    EXPECT_EQ(compare(a, b).maximum, 255);
}

TEST(Compare, RefusesTwoSizes) {
    EXPECT_EQ(error_of([] { (void)compare(Image(2, 3), Image(3, 2)); }),
              "expected pictures of one size, found 2x3 and 3x2");
}

TEST(Compare, OfNothingIsNothing) { EXPECT_EQ(compare(Image(), Image()).mean, 0.0); }

}  // namespace
}  // namespace croquis::image
