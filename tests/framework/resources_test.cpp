// What techniques share: made once, freed with its last user; wrong names come with the nearest.
#include "framework/resources.h"

#include <gtest/gtest.h>

#include "support/errors.h"
#include "support/studio.h"
#include "support/temporary_folder.h"

namespace croquis::framework {
namespace {

using test_support::error_of;
using test_support::TemporaryFolder;

class ResourcesTest : public test_support::StudioTest {
protected:
    [[nodiscard]] static std::string error_for(const std::string& name) {
        return error_of([&] { (void)studio().resources().image(TextureName::parse(name)); });
    }
};

TEST_F(ResourcesTest, ProgramsAreSharedAndFreed) {
    const gpu::Counters before = studio().counters();
    {
        const auto one = studio().resources().program("image:full_screen", "image:copy");
        const auto same = studio().resources().program("image:full_screen", "image:copy");
        const auto other = studio().resources().program("image:full_screen", "image:stretch");
        EXPECT_EQ(one, same);
        EXPECT_NE(one, other);
        EXPECT_EQ(studio().counters().programs_linked, before.programs_linked + 2);
    }
    EXPECT_EQ(studio().counters().live_programs, before.live_programs);
}

TEST_F(ResourcesTest, ImagesAreSharedAndFreed) {
    const gpu::Counters before = studio().counters();
    {
        const auto one = studio().resources().image(TextureName::parse("toon:two_tone:0"));
        const auto same = studio().resources().image(TextureName::parse("toon:two_tone:0"));
        const auto filtered = studio().resources().image(TextureName::parse("toon:two_tone"));
        EXPECT_EQ(one, same);
        EXPECT_NE(one, filtered);
        EXPECT_EQ(studio().counters().texture_uploads, before.texture_uploads + 2);
    }
    EXPECT_EQ(studio().counters().live_textures, before.live_textures);
}

TEST_F(ResourcesTest, AMaterialsImageIsSharedAndNotConfusedWithItsSuccessor) {
    const gpu::Counters before = studio().counters();
    for (int i = 0; i < 3; ++i) {
        const auto pixels = std::make_shared<const image::Image>(2, 2, glm::u8vec4(std::uint8_t(i)));
        const auto one = studio().resources().image(pixels);
        EXPECT_EQ(studio().resources().image(pixels), one);
        EXPECT_EQ(studio().counters().texture_uploads, before.texture_uploads + i + 1);
    }
    EXPECT_EQ(studio().counters().live_textures, before.live_textures);
}

TEST_F(ResourcesTest, AStarIsTheFirstImage) {
    EXPECT_EQ(studio().resources().image(TextureName::parse("images:*")),
              studio().resources().image(TextureName::parse("images:checker")));
}

TEST_F(ResourcesTest, WrongNamesComeWithTheNearest) {
    EXPECT_EQ(error_for("tone:two_tone"), "no texture directory \"tone\"; did you mean \"toon\"?");
    EXPECT_EQ(error_for("toon:two_tune"),
              "no image \"two_tune\" in texture directory \"toon\"; did you mean \"two_tone\"?");
    EXPECT_EQ(error_for("toon:qqqqqqq"), "no image \"qqqqqqq\" in texture directory \"toon\"");
    EXPECT_EQ(error_for("..:secret"), "expected a name inside its data folder, found \"..\"");
    EXPECT_EQ(error_for("toon:../../secret"), "expected a name inside its data folder, found \"../../secret\"");
}

TEST_F(ResourcesTest, TheUsersImageWinsWhateverItsEnding) {
    const TemporaryFolder own, shipped;
    const std::string red = "P6\n1 1\n255\n\xff" + std::string(2, '\0'),
                      green = "P6\n1 1\n255\n" + std::string(1, '\0') + "\xff" + std::string(1, '\0');
    (void)own.write("textures/toon/a.jpg", red);
    (void)shipped.write("textures/toon/a.png", green);
    Resources resources(studio().context(), DataFolders({own.path(), shipped.path()}));
    const auto image = std::const_pointer_cast<gpu::Texture>(resources.image(TextureName::parse("toon:a:0")));
    EXPECT_EQ(gpu::Framebuffer(studio().context(), image, nullptr).read_pixels().at(0), 255)
        << "the shipped image was taken";
}

}  // namespace
}  // namespace croquis::framework
