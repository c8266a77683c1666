// Changing a variable, the window's size or the model never links a program or uploads a texture again; techniques
// share what they have in common, and dropping them frees all.
#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "support/studio.h"

namespace croquis::framework {
namespace {

using test_support::cube;
using test_support::icosphere;
using test_support::Shot;
using test_support::Stage;

class SharingTest : public test_support::StudioTest {
protected:
    struct Made {
        std::int64_t programs = 0;
        std::int64_t textures = 0;
        std::int64_t geometries = 0;
        bool operator==(const Made&) const = default;
    };
    [[nodiscard]] static Made made() {
        const gpu::Counters& counters = studio().counters();
        return {counters.programs_linked, counters.texture_uploads, counters.geometry_uploads};
    }
};

TEST_F(SharingTest, NothingIsMadeAgainWithinATechnique) {
    const auto technique = studio().open_named("cartoon");
    Stage stage(studio(), {}), other(studio(), {.model = icosphere(1)});
    stage.draw(*technique);
    other.draw(*technique);
    const Made before = made();
    technique->set("edges", "normal_threshold", 0.2f);
    technique->set("surfaces", "clear_color", glm::vec3(0.5f));
    stage.draw(*technique);
    EXPECT_EQ(made(), before) << "a variable";
    stage.resize(100, 30);
    stage.draw(*technique);
    EXPECT_EQ(made(), before) << "the size";
    other.draw(*technique);
    stage.draw(*technique);
    EXPECT_EQ(made(), before) << "the model";
}

TEST_F(SharingTest, AnotherTextureUploadsThatAlone) {
    const auto technique = studio().open_named("cartoon");
    Stage stage(studio(), {});
    stage.draw(*technique);
    const Made before = made();
    technique->set("surfaces", "toon_map", std::string("toon:two_tone:0"));
    stage.draw(*technique);
    EXPECT_EQ(made(), (Made{before.programs, before.textures + 1, before.geometries}));
    technique->set("surfaces", "toon_map", std::string("toon:two_tone:0"));
    stage.draw(*technique);
    EXPECT_EQ(made(), (Made{before.programs, before.textures + 1, before.geometries})) << "the same again";
}

TEST_F(SharingTest, TwoTechniquesShareAndTheLastFreesAll) {
    const int alive_before = studio().counters().live_objects();
    {
        const auto first = studio().open_named("cartoon");
        const Made before = made();
        {
            const auto second = studio().open_named("cartoon");
            EXPECT_EQ(made(), before);
        }
        const auto derived = studio().open_named("cartoon_per_vertex");
        EXPECT_EQ(made().textures, before.textures) << "the toon map is shared";
        EXPECT_EQ(made().programs, before.programs + 1) << "only the surfaces' program is new";
    }
    EXPECT_EQ(studio().counters().live_objects(), alive_before);
}

TEST_F(SharingTest, EveryShippedTechniqueOpensDrawsAndFreesAll) {
    const int alive_before = studio().counters().live_objects();
    for (const std::string& name : studio().library().technique_names()) {
        try {
            const auto technique = studio().open_named(name);
            const image::Image picture = Stage(studio(), {.model = icosphere(2)}).picture(*technique);
            const glm::u8vec4 first = picture.at(0, 0);
            const auto differs = [&](const glm::u8vec4& pixel) { return pixel != first; };
            EXPECT_TRUE(std::any_of(picture.pixels().begin(), picture.pixels().end(), differs)) << name;
        } catch (const Error& error) {
            ADD_FAILURE() << name << ": " << error.what();
        }
    }
    EXPECT_EQ(studio().counters().live_objects(), alive_before);
}

TEST_F(SharingTest, TheEdgeTechniqueDrawsTheSceneOnceAndReadsNothingBack) {
    // Row E6: one draw fills normals, ids and depth; the detector's full-screen triangle is the other one.
    const auto technique = studio().open_named("edges");
    Stage stage(studio(), {});
    stage.draw(*technique);
    const gpu::Counters before = studio().counters();
    stage.draw(*technique);
    EXPECT_EQ(studio().counters().draws, before.draws + 2);
    EXPECT_EQ(studio().counters().read_backs, before.read_backs);
}

TEST_F(SharingTest, NoShippedTechniqueReadsBackInAFrame) {
    for (const std::string& name : studio().library().technique_names()) {
        const auto technique = studio().open_named(name);
        Stage stage(studio(), {});
        const std::int64_t before = studio().counters().read_backs;
        stage.draw(*technique);
        EXPECT_EQ(studio().counters().read_backs, before) << name;
    }
}

TEST_F(SharingTest, AnIncludedTechniqueDrawsAsItself) {
    Stage stage(studio(), {});
    const image::Image included = stage.picture("include \"edges\" ;");
    EXPECT_EQ(included, stage.picture(*studio().open_named("edges")));
}

}  // namespace
}  // namespace croquis::framework
