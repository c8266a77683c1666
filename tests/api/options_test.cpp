// What makes no sense is told, in these words.
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "api/shapes.h"
#include "support/errors.h"

namespace croquis {
namespace {

using test_support::cube_file;
using test_support::error_of;
using test_support::small;

class Options : public ::testing::Test {
protected:
    static void SetUpTestSuite() { renderer_ = std::make_unique<Renderer>(Renderer::headless()); }
    static void TearDownTestSuite() { renderer_.reset(); }
    static inline std::unique_ptr<Renderer> renderer_;
};

struct Mistake {
    std::function<void(DrawOptions&)> make;
    const char* message;
};

TEST_F(Options, OfADrawingAreChecked) {
    const Model model = cube_file();
    Technique technique = renderer_->open_technique("phong");
    const Picture before = renderer_->draw(model, technique, small());
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    for (const Mistake& mistake : {
             Mistake{[](auto& o) { o.samples = 3; }, "expected 1, 4, 9 or 16 samples a pixel, found 3"},
             Mistake{[](auto& o) { o.samples = 0; }, "expected 1, 4, 9 or 16 samples a pixel, found 0"},
             Mistake{[](auto& o) { o.view.fit = 0; }, "expected the fit to be above 0 and at most 1, found 0"},
             Mistake{[&](auto& o) { o.view.fit = nan; }, "expected the fit to be above 0 and at most 1, found nan"},
             Mistake{[](auto& o) { o.view.field_of_view = 180; },
                     "expected the field of view to be above 0.1 and below 178 degrees, found 180"},
             Mistake{[](auto& o) {
                         o.view.direction = {0, 0, 0};
                     },
                     "expected the view to have a direction, found 0,0,0"},
             Mistake{[](auto& o) {
                         o.view.up = {0, 0, 0};
                     },
                     "expected the up vector to have a length, found 0,0,0"},
             Mistake{[](auto& o) {
                         o.view.eye = {0.5, 0.5, 0.5};
                     },
                     "expected the eye at a distance from the target, found 0"},
             Mistake{[](auto& o) {
                         o.light.place = {0, 0, 0};
                     },
                     "expected the light to have a direction, found 0,0,0"},
             Mistake{[&](auto& o) {
                         o.light.place = {infinity, 0, 0};
                     },
                     "expected the light to have a direction, found inf,0,0"},
             Mistake{[&](auto& o) {
                         o.light.bound = Light::Bound::point;
                         o.light.place = {0, nan, 0};
                     },
                     "expected the light at a finite distance, found 0,nan,0"},
             Mistake{[&](auto& o) {
                         o.light.color = {1, 1, infinity};
                     },
                     "expected the light to have a finite colour, found 1,1,inf"},
             Mistake{[&](auto& o) {
                         o.view.direction = {0, infinity, 0};
                     },
                     "expected the view to have a direction, found 0,inf,0"},
             Mistake{[&](auto& o) {
                         o.view.eye = {0, 0, -infinity};
                     },
                     "expected the eye at a finite distance, found 0,0,-inf"},
             Mistake{[&](auto& o) {
                         o.view.target = {nan, 0, 0};
                     },
                     "expected the target at a finite distance, found nan,0,0"},
             Mistake{[](auto& o) {
                         o.background = Background{.color = {1, 1, 1}, .transparent = false, .texture = "papre:plain"};
                     },
                     "no texture directory \"papre\"; did you mean \"paper\"?"},
             Mistake{[](auto& o) {
                         o.background = Background{.color = {1, 1, 1}, .transparent = false, .texture = "plain"};
                     },
                     "expected a texture as directory:image, directory:image:0, directory:image:1 or <generated>:name, "
                     "found \"plain\""},
         }) {
        DrawOptions options = small();
        mistake.make(options);
        EXPECT_EQ(error_of([&] { (void)renderer_->draw(model, technique, options); }), mistake.message);
    }
    EXPECT_EQ(renderer_->draw(model, technique, small()).pixels(), before.pixels()) << "errors leave no trace";
}

TEST_F(Options, AGeneratedTextureIsNoBackground) {
    Technique technique = renderer_->open_technique("phong");
    DrawOptions options = small();
    options.background = Background{.color = {1, 1, 1}, .transparent = false, .texture = "<generated>:scene_color"};
    const std::string message = error_of([&] { (void)renderer_->draw(cube_file(), technique, options); });
    EXPECT_EQ(message, "expected an image as the background's texture, found \"<generated>:scene_color\"");
}

TEST_F(Options, SizesAreChecked) {
    Technique technique = renderer_->open_technique("phong");
    for (const auto& [width, height, samples] :
         {std::tuple(0, 10, 1), {10, -1, 1}, {1 << 20, 10, 1}, {10, 1 << 20, 16}}) {
        DrawOptions options = small(width, height);
        options.samples = samples;
        const std::string message = error_of([&] { (void)renderer_->draw(cube_file(), technique, options); });
        EXPECT_EQ(message.rfind("expected a size of 1x1 to ", 0), 0u) << message;
        EXPECT_NE(message.find(fmt::format(" pixels, found {}x{}", width, height)), std::string::npos) << message;
    }
}

TEST_F(Options, TheSmallestPictureIsAPixel) {
    Technique technique = renderer_->open_technique("edges");
    EXPECT_EQ(renderer_->draw(cube_file(), technique, small(1, 1)).pixels().size(), 4u);
}

TEST_F(Options, AnAnimationThatIsNotThereIsTold) {
    Technique technique = renderer_->open_technique("phong");
    DrawOptions options = small();
    options.animation = "run";
    const std::string message = error_of([&] { (void)renderer_->draw(cube_file(), technique, options); });
    EXPECT_NE(message.find("animation"), std::string::npos) << message;
}

TEST_F(Options, OfATechniqueAreChecked) {
    const auto open = [&](const std::string& name, const std::vector<std::string>& settings) {
        return error_of([&] { (void)renderer_->open_technique(name, settings); });
    };
    EXPECT_EQ(open("cartooon", {}), "unknown technique \"cartooon\"; did you mean \"cartoon\"?");
    EXPECT_EQ(open("../edges", {}), "expected a name inside its data folder, found \"../edges\"");
    EXPECT_EQ(open("edges", {"edges.normal_treshold=1"}),
              "pass \"edges\" has no variable \"normal_treshold\"; did you mean \"normal_threshold\"?");
    EXPECT_EQ(open("edges", {"edge.normal_threshold=1"}),
              "technique edges has no pass \"edge\"; did you mean \"edges\"?");
    EXPECT_EQ(open("edges", {"normal_threshold=1"}), "expected pass.variable=value, found \"normal_threshold=1\"");
    EXPECT_EQ(open("edges", {"edges.normal_threshold=x"}), "edges.normal_threshold: expected a number, found \"x\"");
    EXPECT_EQ(open("edges", {"edges.normal_threshold=0.3"}), "no error");
}

TEST_F(Options, OfAnOpenTechniqueAreChecked) {
    Technique technique = renderer_->open_technique("edges");
    const auto set = [&](const std::string& name, const std::string& value) {
        return error_of([&] { technique.set(name, value); });
    };
    EXPECT_EQ(set("normal_threshold", "1"), "expected pass.variable, found \"normal_threshold\"");
    EXPECT_EQ(set("edges.normal_treshold", "1"),
              "pass \"edges\" has no variable \"normal_treshold\"; did you mean \"normal_threshold\"?");
    EXPECT_EQ(set("edge.normal_threshold", "1"), "technique edges has no pass \"edge\"; did you mean \"edges\"?");
    EXPECT_EQ(set("edges.texture", "toon:flat"),
              "variable \"texture\" of pass \"edges\" cannot change while the technique runs");
    EXPECT_EQ(set("edges.normal_threshold", "0.25"), "no error");
    EXPECT_EQ(technique.get("edges.normal_threshold"), "0.25");
    EXPECT_EQ(error_of([&] { (void)technique.get("edges.normal_treshold"); }),
              "pass \"edges\" has no variable \"normal_treshold\"; did you mean \"normal_threshold\"?");
}

TEST_F(Options, NamesOfViewsAreChecked) {
    EXPECT_EQ(error_of([] { (void)View::named("frnot"); }), "unknown view \"frnot\"; did you mean \"front\"?");
    EXPECT_EQ(View::named("top").direction, (Vector3{0, 1, 0}));
}

TEST_F(Options, OfTheContextAreChecked) {
    EXPECT_EQ(error_of([] { (void)Renderer::headless({.api = "vulkan", .device = {}, .data_folders = {}}); }),
              "expected the API to be gl, gles, found \"vulkan\"");
}

}  // namespace
}  // namespace croquis
