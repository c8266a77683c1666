// Names of textures: each form, and each mistake (row F5).
#include "framework/texture_name.h"

#include <gtest/gtest.h>

#include "support/errors.h"

namespace croquis::framework {
namespace {

using test_support::error_of;

struct Form {
    const char* text;
    bool is_generated;
    const char* directory;
    const char* image;
    bool is_filtered;
    const char* as_text;
};

TEST(TextureNameTest, ReadsEachForm) {
    for (const Form& form :
         {Form{"toon:two_tone", false, "toon", "two_tone", true, "toon:two_tone:1"},
          Form{"toon:two_tone:0", false, "toon", "two_tone", false, "toon:two_tone:0"},
          Form{"toon:two_tone:1", false, "toon", "two_tone", true, "toon:two_tone:1"},
          Form{"toon:*", false, "toon", "*", true, "toon:*:1"}, Form{"toon:*:0", false, "toon", "*", false, "toon:*:0"},
          Form{"<generated>:scene_color", true, "", "scene_color", false, "<generated>:scene_color"},
          Form{"<generated>:scene_depth:1", true, "", "scene_depth", false, "<generated>:scene_depth"}}) {
        const TextureName name = TextureName::parse(form.text);
        EXPECT_EQ(name.is_generated, form.is_generated) << form.text;
        EXPECT_EQ(name.directory, form.directory) << form.text;
        EXPECT_EQ(name.image, form.image) << form.text;
        EXPECT_EQ(name.is_filtered, form.is_filtered) << form.text;
        EXPECT_EQ(name.to_string(), form.as_text);
    }
}

TEST(TextureNameTest, RefusesEverythingElse) {
    for (const std::string text :
         {"", "toon", "toon:", ":two_tone", "toon:two_tone:2", "toon:two_tone:", "toon:two_tone:yes",
          "toon:two_tone:1:0", "toon::1", "<generated>:", "<generated>"}) {
        EXPECT_EQ(error_of([&] { (void)TextureName::parse(text); }),
                  "expected a texture as directory:image, directory:image:0, directory:image:1 or <generated>:name, "
                  "found \"" +
                      text + "\"");
    }
}

}  // namespace
}  // namespace croquis::framework
