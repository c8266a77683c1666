// What an interactive program builds on: descriptors of an opened technique, its text, reloading, placed cameras.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>

#include "api/shapes.h"
#include "support/errors.h"

namespace croquis {
namespace {

using test_support::cube_file;
using test_support::error_of;
using test_support::small;
using test_support::TemporaryFolder;
using test_support::torus_file;
using test_support::without;

std::map<std::string, PassVariable> by_name(const Technique& technique) {
    std::map<std::string, PassVariable> variables;
    for (PassVariable& variable : technique.variables()) variables.emplace(variable.full_name(), variable);
    return variables;
}

constexpr const char* component_of_all_types = R"(
component sample : render_toon {
    number amount { default 0.5 ; minimum 0 ; maximum 4 ; ui_maximum 1 ; unit "pixels" ; help "How much." ; } ;
    vector2 step { default 1 2 ; minimum -1 0 ; maximum 5 6 ; } ;
    rgb tint { default 1 0 0 ; } ;
    int count { default 3 ; read_only 1 ; } ;
    string kind { default "b" ; choices "a b" ; } ;
    string title { default "two words" ; internal 1 ; } ;
} ;
)";

TEST(Tuning, VariablesAreThoseOfTheDescriptors) {
    const TemporaryFolder folder;
    folder.write("components/sample.component", component_of_all_types);
    Renderer renderer = Renderer::headless({.api = {}, .device = {}, .data_folders = {folder.path().string()}});
    const Technique technique = renderer.open_technique_text("all", "pass sample one { amount 0.25 ; } ;");
    const auto variables = by_name(technique);

    const PassVariable& amount = variables.at("one.amount");
    EXPECT_EQ(amount.type, PassVariable::Type::number);
    EXPECT_EQ(amount.help, "How much.");
    EXPECT_EQ(amount.unit, "pixels");
    EXPECT_EQ(amount.minimum, std::vector<double>{0});
    EXPECT_EQ(amount.maximum, std::vector<double>{4});
    EXPECT_EQ(amount.ui_minimum, std::vector<double>{0}) << "where none is said, that of the hard range";
    EXPECT_EQ(amount.ui_maximum, std::vector<double>{1});
    EXPECT_EQ(amount.default_value, "0.5");
    EXPECT_EQ(amount.value, "0.25");
    EXPECT_EQ(amount.numbers, std::vector<double>{0.25});

    EXPECT_EQ(variables.at("one.step").numbers, (std::vector<double>{1, 2}));
    EXPECT_EQ(variables.at("one.step").maximum, (std::vector<double>{5, 6}));
    EXPECT_EQ(variables.at("one.tint").type, PassVariable::Type::color);
    EXPECT_EQ(variables.at("one.tint").numbers.size(), 3u);
    EXPECT_TRUE(variables.at("one.count").read_only);
    EXPECT_EQ(variables.at("one.kind").choices, (std::vector<std::string>{"a", "b"}));
    EXPECT_EQ(variables.at("one.title").value, "two words") << "without the quotes of a file";
    EXPECT_TRUE(variables.at("one.title").internal);
    EXPECT_EQ(variables.at("one.toon_map").type, PassVariable::Type::texture);
    EXPECT_EQ(variables.at("one.render").type, PassVariable::Type::boolean);
}

// Whatever `variables` says can be given back: nothing changes.
TEST(Tuning, ValuesCanBeSetAsTheyAreTold) {
    Renderer renderer = Renderer::headless();
    Technique technique = renderer.open_technique("cartoon_strokes");
    const std::string before = technique.text();
    for (const PassVariable& variable : technique.variables()) {
        if (!variable.read_only && !variable.internal) technique.set(variable.full_name(), variable.value);
    }
    EXPECT_EQ(technique.text(), before);
}

// Every shipped technique: its text read again gives the same text and the same picture.
TEST(Tuning, TextDrawsTheSame) {
    Renderer renderer = Renderer::headless();
    const Model model = torus_file();
    for (const std::string& name : renderer.technique_names()) {
        Technique technique = renderer.open_technique(name);
        Technique again = renderer.open_technique_text("again", technique.text());
        EXPECT_EQ(again.text(), technique.text()) << name;
        EXPECT_EQ(again.help(), technique.help()) << name;
        const Picture expected = renderer.draw(model, technique, small(60, 45));
        EXPECT_EQ(renderer.draw(model, again, small(60, 45)).difference_from(expected).maximum, 0) << name;
    }
}

TEST(Tuning, TextHoldsWhatWasChanged) {
    Renderer renderer = Renderer::headless();
    const Model model = torus_file();
    Technique technique = renderer.open_technique("cartoon");
    const Picture before = renderer.draw(model, technique, small());
    technique.set("surfaces.toon_map", "toon:two_tone:0");
    technique.set("edges.edge_color", "1 0 0.1 1");
    technique.set("edges.objects", "a \"quoted\" \\name");
    technique.set("edges.objects", "");
    const Picture changed = renderer.draw(model, technique, small());
    EXPECT_GT(changed.difference_from(before).maximum, 0);
    Technique again = renderer.open_technique_text("again", technique.text());
    EXPECT_EQ(renderer.draw(model, again, small()).difference_from(changed).maximum, 0);
}

TEST(Tuning, QuotesInTextAreKept) {
    Renderer renderer = Renderer::headless();
    Technique technique = renderer.open_technique("cartoon");
    technique.set("edges.objects", "a \"quoted\" \\name");
    EXPECT_EQ(by_name(renderer.open_technique_text("again", technique.text())).at("edges.objects").value,
              "a \"quoted\" \\name");
}

TEST(Tuning, TexturesAreThoseOfTheDataFolders) {
    const TemporaryFolder folder;
    folder.write("textures/mine/dot.bmp", std::string("BM") + '\x3a' + std::string(7, '\0') + '\x36' +
                                              std::string(3, '\0') + '\x28' + std::string(3, '\0') + '\1' +
                                              std::string(3, '\0') + '\1' + std::string(3, '\0') + '\1' + '\0' +
                                              '\x18' + std::string(25, '\0') + "\x10\x20\x30" + '\0');
    const Renderer renderer = Renderer::headless({.api = {}, .device = {}, .data_folders = {folder.path().string()}});
    const std::vector<std::string> names = renderer.texture_names();
    EXPECT_EQ(std::count(names.begin(), names.end(), "mine:dot"), 1);
    EXPECT_EQ(std::count(names.begin(), names.end(), "toon:two_tone"), 1);
    EXPECT_EQ(renderer.texture("mine:dot").pixels(), (std::vector<std::uint8_t>{0x30, 0x20, 0x10, 255}));
    EXPECT_EQ(error_of([&] { (void)renderer.texture("mine:dto"); }),
              "no image \"dto\" in texture directory \"mine\"; did you mean \"dot\"?");
}

// A user's folder whose shader gives one colour: what is drawn says which version of the file was read.
class Reloading : public ::testing::Test {
protected:
    // The files come first: descriptors are read when a renderer begins.
    Renderer renderer_of_the_folder() const {
        write_shader("1.0, 0.0, 0.0");
        folder_.write("components/paint.component", R"(
component paint : process_texture {
    modify fragment_program { default "paint:paint" ; } ;
    number amount { default 1 ; maximum 4 ; } ;
} ;
)");
        folder_.write("techniques/paint.technique", "pass paint paint { texture \"toon:two_tone\" ; } ;");
        return Renderer::headless({.api = {}, .device = {}, .data_folders = {folder_.path().string()}});
    }
    void write_shader(const std::string& color) const {
        folder_.write("shaders/paint.glsl",
                      "#ifdef FRAGMENT_STAGE\nvec4 paint() { return vec4(" + color + ", 1.0); }\n#endif\n");
    }
    std::array<int, 3> color(Technique& technique) {
        const Picture picture = renderer_.draw(cube_, technique, small(4, 4));
        return {picture.pixels()[0], picture.pixels()[1], picture.pixels()[2]};
    }

    TemporaryFolder folder_;
    Renderer renderer_ = renderer_of_the_folder();
    Model cube_ = cube_file();
};

constexpr std::array<int, 3> red{255, 0, 0}, green{0, 255, 0};

TEST_F(Reloading, TakesNoticeOfShaders) {
    Technique old = renderer_.open_technique("paint");
    write_shader("0.0, 1.0, 0.0");
    EXPECT_EQ(color(old), red);
    Technique unaware = renderer_.open_technique("paint");
    EXPECT_EQ(color(unaware), red) << "programs are shared until the renderer reloads";
    renderer_.reload();
    Technique aware = renderer_.open_technique("paint");
    EXPECT_EQ(color(aware), green);
    EXPECT_EQ(color(old), red) << "what was opened before goes on";
}

TEST_F(Reloading, AWrongShaderLeavesTheOldOneDrawing) {
    Technique old = renderer_.open_technique("paint");
    write_shader("0.0, 1.0");
    renderer_.reload();
    const std::string message = error_of([&] { (void)renderer_.open_technique("paint"); });
    EXPECT_NE(message.find("paint.glsl:2"), std::string::npos) << message;
    EXPECT_EQ(color(old), red);
    write_shader("0.0, 1.0, 0.0");
    Technique mended = renderer_.open_technique("paint");
    EXPECT_EQ(color(mended), green) << "a program that failed is not remembered";
}

TEST_F(Reloading, TakesNoticeOfDescriptors) {
    Technique old = renderer_.open_technique("paint");
    folder_.write("components/paint.component",
                  "component paint : process_texture {\n    modify fragment_progam { } ;\n} ;");
    const std::string message = error_of([&] { renderer_.reload(); });
    EXPECT_NE(message.find("paint.component:2:12: "), std::string::npos) << message;
    EXPECT_NO_THROW((void)renderer_.open_technique("paint")) << "nothing changed";
    folder_.write("components/paint.component",
                  "component paint : process_texture { modify fragment_program { default \"paint:paint\" ; } ;\n"
                  "number other { default 7 ; } ; } ;");
    renderer_.reload();
    EXPECT_EQ(by_name(renderer_.open_technique("paint")).at("paint.other").value, "7");
    EXPECT_EQ(by_name(old).at("paint.amount").value, "1") << "what was opened before keeps its descriptors";
}

// The same picture from a placed view as from direction and fit.
TEST(PlacedView, ShowsTheSame) {
    Renderer renderer = Renderer::headless();
    const Model model = torus_file({.scale = 3, .offset = 100, .winding = {}});
    Technique technique = renderer.open_technique("phong");
    for (const bool parallel : {false, true}) {
        DrawOptions options = small();
        options.view = View::named("iso");
        options.view.parallel = parallel;
        const Picture expected = renderer.draw(model, technique, options);
        options.view = options.view.placed(model, 120.0 / 90.0);
        ASSERT_TRUE(options.view.eye && options.view.target);
        EXPECT_NEAR((*options.view.target)[0], 100, 1e-9);
        EXPECT_LT(renderer.draw(model, technique, options).difference_from(expected).mean, 0.05) << parallel;
    }
}

// The unit cube from the front in a square frame: its front side, half a unit before the centre, fills the share `fit`
// of the frame, so that the eye stands 0.5 + 0.5 / (fit tan(20°)) from the centre.
TEST(PlacedView, StandsWhereTheEquationSays) {
    View view = View::named("front");
    view.fit = 0.8;
    const View placed = view.placed(cube_file(), 1.0);
    const double expected = 0.5 + 0.5 + 0.5 / (0.8 * std::tan(20.0 * 3.14159265358979 / 180.0));
    EXPECT_NEAR((*placed.eye)[2], expected, 1e-6);
    EXPECT_NEAR((*placed.eye)[0], 0.5, 1e-9);
}

}  // namespace
}  // namespace croquis
