// What lives how long: models and techniques go with their handles, two renderers do not disturb each other, and a
// frame makes nothing that the last one had.
#include <gtest/gtest.h>

#include <optional>

#include "api/shapes.h"
#include "croquis/lines.h"

namespace croquis {
namespace {

using test_support::cube_file;
using test_support::small;
using test_support::torus_file;

TEST(Lifetime, ADroppedModelLeavesTheGpuAtTheNextFrame) {
    Renderer renderer = Renderer::headless();
    Technique technique = renderer.open_technique("phong");
    const Model kept = cube_file();
    (void)renderer.draw(kept, technique, small());
    const int before = renderer.counts().live_objects;
    {
        const Model dropped = torus_file();
        (void)renderer.draw(dropped, technique, small());
        (void)renderer.draw(kept, technique, small());
        EXPECT_GT(renderer.counts().live_objects, before) << "a model in use stays";
    }
    (void)renderer.draw(kept, technique, small());
    EXPECT_EQ(renderer.counts().live_objects, before);
}

TEST(Lifetime, ADroppedTechniqueFreesWhatItHad) {
    Renderer renderer = Renderer::headless();
    const Model model = cube_file();
    Technique phong = renderer.open_technique("phong");
    (void)renderer.draw(model, phong, small());
    const int before = renderer.counts().live_objects;
    {
        Technique edges = renderer.open_technique("edges");
        (void)renderer.draw(model, edges, small());
        EXPECT_GT(renderer.counts().live_objects, before);
    }
    EXPECT_EQ(renderer.counts().live_objects, before);
}

TEST(Lifetime, AFrameMakesNothingAgain) {
    Renderer renderer = Renderer::headless();
    const Model model = cube_file();
    Technique technique = renderer.open_technique("edges");
    DrawOptions options = small();
    (void)renderer.draw(model, technique, options);
    const Renderer::Counts before = renderer.counts();
    options.width = 77;
    options.view.direction = {1, 2, 3};
    technique.set("edges.normal_threshold", "0.4");
    (void)renderer.draw(model, technique, options);
    EXPECT_EQ(renderer.counts().programs_linked, before.programs_linked);
    EXPECT_EQ(renderer.counts().texture_uploads, before.texture_uploads);
    EXPECT_EQ(renderer.counts().geometry_uploads, before.geometry_uploads);
}

TEST(Lifetime, ABackgroundsTextureIsLoadedOnce) {
    Renderer renderer = Renderer::headless();
    const Model model = cube_file();
    Technique technique = renderer.open_technique("phong");
    DrawOptions options = small();
    options.background = Background{.color = {1, 1, 1}, .transparent = false, .texture = "paper:plain"};
    (void)renderer.draw(model, technique, options);
    const Renderer::Counts before = renderer.counts();
    (void)renderer.draw(model, technique, options);
    EXPECT_EQ(renderer.counts().texture_uploads, before.texture_uploads) << "the paper is uploaded with each frame";
    EXPECT_EQ(renderer.counts().programs_linked, before.programs_linked) << "its program is linked with each frame";
}

TEST(Lifetime, TwoRenderersDoNotDisturbEachOther) {
    const Model model = cube_file();
    Renderer first = Renderer::headless();
    std::optional<Technique> dropped = first.open_technique("edges");
    const Picture expected = first.draw(model, *dropped, small());
    Renderer second = Renderer::headless();
    Technique technique = second.open_technique("edges");
    EXPECT_EQ(second.draw(model, technique, small()).pixels(), expected.pixels());
    dropped.reset();  // the second one's context is current
    EXPECT_EQ(second.draw(model, technique, small()).pixels(), expected.pixels());
}

TEST(Lifetime, ATechniqueChangesInItsOwnContext) {
    const Model model = cube_file();
    Renderer first = Renderer::headless();
    Technique technique = first.open_technique("metallic");
    (void)first.draw(model, technique, small());
    Technique gold = first.open_technique("metallic", {"surfaces.sphere_map=metal:gold"});
    const Picture expected = first.draw(model, gold, small());
    Renderer second = Renderer::headless();
    technique.set("surfaces.sphere_map", "metal:gold");
    EXPECT_EQ(first.draw(model, technique, small()).pixels(), expected.pixels());
}

TEST(Lifetime, ARendererCanReplaceAnother) {
    const Model model = cube_file();
    Renderer renderer = Renderer::headless();
    std::optional<Technique> technique = renderer.open_technique("phong");
    const Picture expected = renderer.draw(model, *technique, small());
    technique.reset();
    renderer = Renderer::headless();
    technique = renderer.open_technique("phong");
    EXPECT_EQ(renderer.draw(model, *technique, small()).pixels(), expected.pixels());
}

TEST(Lifetime, PassesAreTimedByName) {
    Renderer renderer = Renderer::headless();
    Technique technique = renderer.open_technique("edges");
    const std::vector<PassTime> times = renderer.time_passes(cube_file(), technique, small());
    ASSERT_EQ(times.size(), 2u);
    EXPECT_EQ(times[0].pass, "attributes");
    EXPECT_EQ(times[1].pass, "edges");
    for (const PassTime& time : times) {
        EXPECT_GT(time.milliseconds, 0.0) << time.pass;
        EXPECT_EQ(time.lines, 0u) << "found in the picture";
    }
}

TEST(Lifetime, PassesTellHowManyLinesTheyDrew) {
    Renderer renderer = Renderer::headless();
    Technique technique = renderer.open_technique("lines");
    const auto lines = [&] {
        std::size_t count = 0;
        for (const PassTime& time : renderer.time_passes(cube_file(), technique, small())) count += time.lines;
        return count;
    };
    LineOptions on_paper;
    on_paper.width = small().width;
    on_paper.height = small().height;
    on_paper.view = small().view;
    EXPECT_EQ(lines(), draw_lines(cube_file(), on_paper).paths().size());
    technique.set("lines.render", "false");
    EXPECT_EQ(lines(), 0u);
}

}  // namespace
}  // namespace croquis
