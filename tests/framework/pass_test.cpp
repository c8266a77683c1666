// Variables of an open technique: clamped, refused or told; a change that cannot be leaves all as it was.
#include "framework/pass.h"

#include <gtest/gtest.h>

#include "support/errors.h"
#include "support/studio.h"

namespace croquis::framework {
namespace {

using test_support::error_of;
using test_support::Shot;
using test_support::Stage;

class PassTest : public test_support::StudioTest {
protected:
    [[nodiscard]] static std::unique_ptr<Technique> grey() {
        return studio().open("pass test_image grey { fragment_program \"test_image:grey\" ; amount 0.2 ; } ;");
    }
    [[nodiscard]] static int level(Technique& technique) {
        return Stage(studio(), {.width = 4, .height = 4}).picture(technique).at(1, 1).x;
    }
};

TEST_F(PassTest, AChangeShowsInTheNextFrame) {
    const auto technique = grey();
    EXPECT_EQ(level(*technique), 51);
    technique->set("grey", "amount", 0.6f);
    EXPECT_EQ(level(*technique), 153);
}

TEST_F(PassTest, ValuesAreClampedToTheirRange) {
    const auto technique = grey();
    technique->set("grey", "amount", 7.0f);
    EXPECT_EQ(std::get<float>(technique->pass("grey").value("amount")), 1.0f);
    technique->set("grey", "amount", -7.0f);
    EXPECT_EQ(std::get<float>(technique->pass("grey").value("amount")), 0.0f);
}

struct Refused {
    const char* variable;
    Value value;
    const char* message;
};

TEST_F(PassTest, WhatCannotBeSetIsToldAndChangesNothing) {
    const auto technique = grey();
    const std::vector<Refused> cases{
        {"fixed", 0.1f, "variable \"fixed\" of pass \"grey\" cannot change while the technique runs"},
        {"hidden", 0.1f, "variable \"hidden\" of pass \"grey\" cannot change while the technique runs"},
        {"amuont", 0.1f, "pass \"grey\" has no variable \"amuont\"; did you mean \"amount\"?"},
        {"texture", std::string("toon:two_tune"),
         "no image \"two_tune\" in texture directory \"toon\"; did you mean \"two_tone\"?"},
        {"texture", std::string("<generated>:none"), "no pass generates the texture \"none\""},
        {"texture", std::string("nonsense"),
         "expected a texture as directory:image, directory:image:0, directory:image:1 or <generated>:name, found "
         "\"nonsense\""},
        {"fragment_program", std::string("test_image:gray"), nullptr},
        {"blend", std::string("ovre"), nullptr},
    };
    for (const Refused& refused : cases) {
        const bool exists = technique->pass("grey").has(refused.variable);
        const std::string before = exists ? format_value(technique->pass("grey").value(refused.variable)) : "";
        const std::string message = error_of([&] { technique->set("grey", refused.variable, refused.value); });
        if (refused.message != nullptr) {
            EXPECT_EQ(message, refused.message);
        }
        EXPECT_NE(message, "no error") << refused.variable;
        if (exists) {
            EXPECT_EQ(format_value(technique->pass("grey").value(refused.variable)), before);
        }
        EXPECT_EQ(level(*technique), 51);
    }
}

TEST_F(PassTest, ATextureThatDoesNotExistLeavesTheOldOne) {
    const auto technique =
        studio().open("pass test_image copy { fragment_program \"image:stretch\" ; texture \"toon:flat:0\" ; } ;");
    const int before = level(*technique);
    const gpu::Texture* texture = technique->pass("copy").texture("texture");
    EXPECT_NE(error_of([&] { technique->set("copy", "texture", std::string("toon:none")); }), "no error");
    EXPECT_EQ(technique->pass("copy").texture("texture"), texture);
    EXPECT_EQ(level(*technique), before);
}

TEST_F(PassTest, AnUnknownPassComesWithTheNearest) {
    EXPECT_EQ(error_of([&] { grey()->set("gray", "amount", 0.5f); }),
              "technique test has no pass \"gray\"; did you mean \"grey\"?");
}

TEST_F(PassTest, ShadersChangeWhileTheTechniqueRuns) {
    const auto technique =
        studio().open("pass process_texture p { texture \"toon:flat\" ; fragment_program \"test_image:grey\" ; } ;");
    technique->set("p", "fragment_program", std::string("test_image:place_as_color"));
    const image::Image picture = Stage(studio(), {.width = 4, .height = 4}).picture(*technique);
    EXPECT_EQ(picture.at(2, 0), glm::u8vec4(2, 3, 0, 255));
}

TEST_F(PassTest, RenderOffSkipsThePass) {
    const auto technique = studio().open(
        "pass test_image first { fragment_program \"test_image:grey\" ; amount 0.2 ; } ;"
        "pass test_image second { fragment_program \"test_image:grey\" ; amount 0.6 ; render false ; } ;");
    EXPECT_EQ(level(*technique), 51);
    technique->set("second", "render", true);
    EXPECT_EQ(level(*technique), 153);
    technique->set("second", "render", false);
    EXPECT_EQ(level(*technique), 51);
}

TEST_F(PassTest, RevisionsCountChanges) {
    const auto technique = grey();
    const int before = technique->pass("grey").revision();
    technique->set("grey", "amount", 0.3f);
    EXPECT_EQ(technique->pass("grey").revision(), before + 1);
}

}  // namespace
}  // namespace croquis::framework
