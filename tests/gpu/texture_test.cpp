// Textures and framebuffers: rows run from top to bottom outside this folder, copies are exact, nothing leaks.
#include "gpu/texture.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/random.h"
#include "gpu/framebuffer.h"
#include "support/errors.h"
#include "support/studio.h"

namespace croquis::gpu {
namespace {

std::vector<std::uint8_t> random_bytes(std::size_t count, std::uint64_t seed) {
    const Random random(seed, "bytes");
    std::vector<std::uint8_t> bytes;
    for (std::size_t i = 0; i < count; ++i) bytes.push_back(std::uint8_t(random.bits(i)));
    return bytes;
}

class TextureTest : public test_support::StudioTest {
protected:
    [[nodiscard]] static std::shared_ptr<Texture> empty(TextureFormat format, int width, int height) {
        return std::make_shared<Texture>(studio().context(), format, width, height);
    }
    void draw(const Framebuffer& target, const char* function, const Texture* texture) {
        const auto program = studio().resources().program("image:full_screen", function);
        target.bind();
        program->use();
        apply({});
        if (texture != nullptr) texture->bind(0);
        program->set("texture_sampler", 0);
        studio().resources().draw_full_screen();
    }
};

TEST_F(TextureTest, UploadAndReadBackKeepRowsFromTheTop) {
    constexpr int width = 7, height = 5;
    const std::vector<std::uint8_t> bytes = random_bytes(width * height * 4, 1);
    for (const Filter filter : {Filter::nearest, Filter::trilinear}) {
        const auto texture =
            std::make_shared<Texture>(studio().context(), bytes.data(), width, height, filter, Wrap::clamp);
        EXPECT_EQ(Framebuffer(studio().context(), texture, nullptr).read_pixels(), bytes);
    }
}

TEST_F(TextureTest, RowZeroIsTheTopOfThePicture) {
    // Fragment rows count from below: the top row of three is number 2.
    const Framebuffer target(studio().context(), empty(TextureFormat::rgba8, 2, 3), nullptr);
    draw(target, "test_image:place_as_color", nullptr);
    const std::vector<std::uint8_t> pixels = target.read_pixels();
    EXPECT_EQ(pixels[1], 2);
    EXPECT_EQ(pixels[2 * 2 * 4 + 1], 0);
    EXPECT_EQ(pixels[4], 1) << "columns run from the left";
}

TEST_F(TextureTest, CopiesAreExact) {
    constexpr int width = 9, height = 4;
    const std::vector<std::uint8_t> bytes = random_bytes(width * height * 4, 2);
    const Framebuffer source(
        studio().context(),
        std::make_shared<Texture>(studio().context(), bytes.data(), width, height, Filter::nearest, Wrap::clamp),
        nullptr);
    Framebuffer copy(studio().context(), empty(TextureFormat::rgba8, width, height), nullptr);
    source.copy_to(copy, Framebuffer::Part::color);
    EXPECT_EQ(copy.read_pixels(), bytes);
}

TEST_F(TextureTest, ResizingChangesOnlyAnotherSize) {
    Texture texture(studio().context(), TextureFormat::rgba8, 4, 4);
    texture.resize(8, 2);
    EXPECT_EQ(texture.width(), 8);
    EXPECT_EQ(texture.height(), 2);
}

TEST_F(TextureTest, ClearsIgnoreTheMasksOfTheLastDraw) {
    const Framebuffer target(studio().context(), empty(TextureFormat::rgba8, 2, 2), empty(TextureFormat::depth, 2, 2));
    apply({.write_depth = false, .write_color = false});
    target.clear_color({1.0f, 0.0f, 1.0f, 1.0f});
    const std::vector<std::uint8_t> pixels = target.read_pixels();
    EXPECT_EQ(pixels[0], 255);
    EXPECT_EQ(pixels[1], 0);
}

TEST_F(TextureTest, CountersComeBackToZero) {
    const Counters before = studio().counters();
    {
        const Framebuffer target(studio().context(), empty(TextureFormat::rgba8, 2, 2),
                                 empty(TextureFormat::depth, 2, 2));
        const Counters now = studio().counters();
        EXPECT_EQ(now.live_textures, before.live_textures + 2);
        EXPECT_EQ(now.live_framebuffers, before.live_framebuffers + 1);
        (void)target.read_pixels();
        EXPECT_EQ(studio().counters().read_backs, before.read_backs + 1);
    }
    EXPECT_EQ(studio().counters().live_objects(), before.live_objects());
}

TEST_F(TextureTest, UploadsAreCounted) {
    const std::int64_t before = studio().counters().texture_uploads;
    const std::uint8_t pixel[] = {1, 2, 3, 4};
    const Texture texture(studio().context(), pixel, 1, 1, Filter::nearest, Wrap::repeat);
    EXPECT_EQ(studio().counters().texture_uploads, before + 1);
}

TEST_F(TextureTest, TellsOfVolumesAndLayersThatAreTooLarge) {
    const gpu::Counters before = studio().counters();
    const int side = studio().context().longest_volume_side(), layers = studio().context().most_layers();
    EXPECT_GE(side, 256);
    EXPECT_GE(layers, 256);
    const auto slices = [](int count) {
        return Slices{std::vector<std::uint8_t>(std::size_t(count) * 4), 1, 1, count};
    };
    EXPECT_EQ(
        test_support::error_of([&] { (void)Texture(studio().context(), slices(side + 1), Filter::nearest); }),
        fmt::format("expected a volume of at most {} x {} x {} pixels, found 1 x 1 x {}", side, side, side, side + 1));
    const int longest = studio().context().longest_side();
    const std::vector<Slices> levels{slices(layers + 1)};
    EXPECT_EQ(test_support::error_of([&] { (void)Texture(studio().context(), levels, Filter::nearest); }),
              fmt::format("expected layers of at most {} x {} x {} pixels, found 1 x 1 x {}", longest, longest, layers,
                          layers + 1));
    EXPECT_EQ(studio().counters().live_objects(), before.live_objects());
}

}  // namespace
}  // namespace croquis::gpu
