// Descriptors: properties, ranges, inheritance, and clamping (seed C, 2.2.2 and 2.2.3).
#include <limits>

#include "texts.h"

namespace croquis::framework {
namespace {

TEST(Descriptor, EveryPropertyIsKept) {
    const Descriptors descriptors = descriptors_of(R"(
component c {
  help "Draws " # a comment between pieces of a text
       "things." ;
  number width { help "How \"wide\"." ; unit "pixels" ; default 2 ; minimum 0 ; maximum 10 ; ui_minimum 1 ;
                 ui_maximum 5 ; vertex_parameter true ; fragment_parameter 1 ; read_only 0 ; internal false ; }
  string mode { choices "soft  hard" ; default "hard" ; }
  texture map { form "volume" ; }
})");
    const ComponentDescriptor& component = descriptors.at("c");
    EXPECT_EQ(component.help, "Draws things.");
    const VariableDescriptor& width = *component.find("width");
    EXPECT_EQ(width.help, "How \"wide\".");
    EXPECT_EQ(width.unit, "pixels");
    EXPECT_EQ(width.default_value, Value(2.0f));
    EXPECT_EQ(width.minimum, Value(0.0f));
    EXPECT_EQ(width.maximum, Value(10.0f));
    EXPECT_EQ(width.ui_minimum, Value(1.0f));
    EXPECT_EQ(width.ui_maximum, Value(5.0f));
    EXPECT_TRUE(width.vertex_parameter);
    EXPECT_TRUE(width.fragment_parameter);
    EXPECT_FALSE(width.read_only);
    EXPECT_FALSE(width.internal);
    EXPECT_EQ(width.where.to_string(), "file:5:10");
    EXPECT_EQ(component.find("mode")->choices, (std::vector<std::string>{"soft", "hard"}));
    EXPECT_EQ(component.find("map")->form, TextureForm::volume);
    EXPECT_EQ(component.find("nothing"), nullptr);
}

TEST(Descriptor, AllTypesHaveDefaults) {
    const Descriptors descriptors = descriptors_of(R"(component c {
  bool a { default true ; } ; int b { default -5 ; } ; number c { default 1.5e-2 ; } ; string d { default "x" ; } ;
  vector2 e { default 1 2 ; } ; vector3 f { default 1 2 3 ; } ; vector4 g { default 1 2 3 4 ; } ;
  rgb h { default 0.1 0.2 0.3 ; } ; rgba i { default 0 0 0 0.5 ; } ; texture j { default "toon:two_tone:0" ; } ;
} ;)");
    const std::vector<Value> expected = {true,
                                         -5,
                                         0.015f,
                                         std::string("x"),
                                         glm::vec2(1, 2),
                                         glm::vec3(1, 2, 3),
                                         glm::vec4(1, 2, 3, 4),
                                         glm::vec3(0.1f, 0.2f, 0.3f),
                                         glm::vec4(0, 0, 0, 0.5f),
                                         std::string("toon:two_tone:0")};
    const auto& variables = descriptors.at("c").variables;
    ASSERT_EQ(variables.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(variables[i].default_value, expected[i]) << i;
}

TEST(Descriptor, TextMayHaveMarkOfByteOrderAndCarriageReturns) {
    const Descriptors descriptors = descriptors_of("\xEF\xBB\xBF# x\r\ncomponent c\r\n{\r\nint a ;\r\n} ;\r\n");
    EXPECT_EQ(descriptors.at("c").find("a")->where.to_string(), "file:4:5");
}

TEST(Descriptor, RangeIsThatOfTheSliderUnlessGiven) {
    const Descriptors descriptors = descriptors_of(R"(
component a {
  number x { ui_minimum 2 ; minimum 0 ; maximum 10 ; }
  number y { minimum 0 ; maximum 10 ; ui_maximum 5 ; }
}
component b : a { modify x { minimum 1 ; } modify y { maximum 20 ; ui_minimum 3 ; } })");
    const ComponentDescriptor &a = descriptors.at("a"), &b = descriptors.at("b");
    EXPECT_EQ(a.find("x")->ui_minimum, Value(2.0f));
    EXPECT_EQ(a.find("x")->ui_maximum, Value(10.0f));
    EXPECT_EQ(a.find("y")->ui_minimum, Value(0.0f));
    EXPECT_EQ(a.find("y")->ui_maximum, Value(5.0f));
    EXPECT_EQ(b.find("x")->ui_minimum, Value(1.0f));
    EXPECT_EQ(b.find("x")->ui_maximum, Value(10.0f));
    EXPECT_EQ(b.find("y")->ui_minimum, Value(3.0f));
    EXPECT_EQ(b.find("y")->ui_maximum, Value(20.0f));
}

TEST(Descriptor, InheritsAcrossFilesInAnyOrder) {
    const std::vector<std::vector<Descriptors::Source>> layers{
        {{"one", "component c : b { modify v { default 3 ; help \"third\" ; } number own ; }"},
         {"two", "component b : a { modify v { default 2 ; unit \"px\" ; } }"},
         {"three",
          "component a { number v { default 1 ; minimum 0 ; } } component every_component { bool render "
          "{ default true ; } }"}}};
    const Descriptors descriptors(layers);
    const ComponentDescriptor& c = descriptors.at("c");
    EXPECT_EQ(c.parent, "b");
    EXPECT_EQ(c.core, "a");
    EXPECT_EQ(c.variable_names(), (std::vector<std::string>{"render", "v", "own"}));
    EXPECT_EQ(c.find("v")->default_value, Value(3.0f));
    EXPECT_EQ(c.find("v")->unit, "px");
    EXPECT_EQ(c.find("v")->help, "third");
    EXPECT_EQ(c.find("v")->minimum, Value(0.0f));
    EXPECT_EQ(descriptors.at("a").parent, "");
    EXPECT_EQ(descriptors.at("a").core, "a");
    EXPECT_EQ(descriptors.at("b").find("v")->help, "");
    EXPECT_EQ(descriptors.names(), (std::vector<std::string>{"a", "b", "c"}));
}

TEST(Descriptor, LongChainsOfInheritanceAreBuilt) {
    std::string text = "component c0 { int v ; }";
    for (int i = 1; i < 1000; ++i) text += fmt::format(" component c{} : c{} {{ }}", i, i - 1);
    EXPECT_EQ(descriptors_of(text).at("c999").core, "c0");
}

TEST(Descriptor, RenderIsModifiable) {
    const Descriptors descriptors = descriptors_of(
        "component every_component { bool render { default 1 ; } } component a { modify render { default 0 ; } }");
    EXPECT_EQ(descriptors.at("a").find("render")->default_value, Value(false));
}

TEST(Descriptor, SizeIsBounded) {
    std::string many = "component a {";
    for (int i = 0; i < 257; ++i) many += fmt::format(" int v{} ;", i);
    EXPECT_EQ(message_of([&] { descriptors_of(many + "}"); }).substr(0, 5), "file:");
    // A chain that copies much is refused before it takes the memory.
    std::string chain = "component c0 { string v { default \"" + std::string(500'000, 'x') + "\" ; } }";
    for (int i = 1; i < 10'000; ++i) chain += fmt::format(" component c{} : c{} {{ }}", i, i - 1);
    const std::string message = message_of([&] { descriptors_of(chain); });
    EXPECT_NE(message.find("the components together are larger than 64 MiB"), std::string::npos) << message;
    EXPECT_EQ(message_of([] { descriptors_of(std::string((1 << 20) + 1, ' ')); }),
              "file: larger than the 1 MiB allowed here");
}

TEST(Descriptor, UnknownNameSuggestsTheNearest) {
    const Descriptors descriptors = descriptors_of("component render_phong { }");
    EXPECT_EQ(message_of([&] { (void)descriptors.at("render_fong"); }),
              R"(unknown component "render_fong"; did you mean "render_phong"?)");
}

// ---- Clamping -------------------------------------------------------------------------------------------------------

VariableDescriptor variable(const std::string& declaration) {
    return descriptors_of("component c { " + declaration + " }").at("c").variables.at(0);
}

TEST(Clamp, IsComponentWise) {
    const VariableDescriptor v = variable("vector3 v { minimum 0 -1 0 ; maximum 1 1 0.5 ; }");
    Value clamped;
    const std::string printed = printed_by([&] { clamped = clamp_to_range(v, glm::vec3(2, -3, 0.25f), "here"); });
    EXPECT_EQ(clamped, Value(glm::vec3(1, -1, 0.25f)));
    EXPECT_EQ(printed,
              "croquis: warning: here: variable \"v\": 2 -3 0.25 is outside 0 -1 0 to 1 1 0.5; using 1 -1 0.25\n");
}

TEST(Clamp, OneSidedRangesSaySo) {
    EXPECT_EQ(fit_to_range(variable("int v { minimum 3 ; }"), 1).warning, "1 is below 3; using 3");
    EXPECT_EQ(fit_to_range(variable("int v { maximum 3 ; }"), 4).warning, "4 is above 3; using 3");
    EXPECT_EQ(fit_to_range(variable("int v { maximum 3 ; }"), 3).warning, "");
}

TEST(Clamp, LargeIntegersAreExact) {
    const VariableDescriptor v = variable("int v { minimum -2147483647 ; maximum 2147483646 ; }");
    EXPECT_EQ(fit_to_range(v, 2147483647).value, Value(2147483646));
    EXPECT_EQ(fit_to_range(v, 2147483645).value, Value(2147483645));
    EXPECT_EQ(fit_to_range(v, std::numeric_limits<std::int32_t>::min()).value, Value(-2147483647));
}

TEST(Clamp, NotANumberBecomesTheDefaultOrTheMinimum) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    EXPECT_EQ(fit_to_range(variable("number v { default 0.5 ; minimum 0 ; }"), nan).value, Value(0.5f));
    EXPECT_EQ(fit_to_range(variable("number v { minimum 0.25 ; }"), nan).value, Value(0.25f));
    EXPECT_EQ(fit_to_range(variable("number v ;"), nan).value, Value(0.0f));
    EXPECT_EQ(fit_to_range(variable("number v ;"), infinity).value, Value(0.0f));
    EXPECT_EQ(fit_to_range(variable("number v { maximum 3 ; }"), infinity).value, Value(3.0f));
    EXPECT_EQ(fit_to_range(variable("vector2 v { default 7 8 ; }"), glm::vec2(1, nan)).value, Value(glm::vec2(1, 8)));
    EXPECT_EQ(fit_to_range(variable("number v ;"), nan).warning, "nan is not a finite number; using 0");
}

TEST(Clamp, StringsMustBeAmongTheChoices) {
    const VariableDescriptor v = variable(R"(string v { choices "soft hard" ; })");
    EXPECT_EQ(clamp_to_range(v, std::string("soft"), "here"), Value(std::string("soft")));
    EXPECT_EQ(message_of([&] { (void)clamp_to_range(v, std::string("sofd"), "here"); }),
              R"(here: variable "v" expects one of "soft", "hard"; found "sofd"; did you mean "soft"?)");
    EXPECT_EQ(clamp_to_range(variable("string v ;"), std::string("any"), "here"), Value(std::string("any")));
}

}  // namespace
}  // namespace croquis::framework
