// Techniques: values, includes, modifications and names of passes (seed C, 2.1).
#include "texts.h"

namespace croquis::framework {
namespace {

Descriptors sample() {
    return descriptors_of(R"(
component every_component { bool render { default true ; } ; } ;
component draw { string program ; number width { default 1 ; minimum 0 ; maximum 4 ; } ; } ;
component draw_red : draw { modify program { default "red" ; } ; rgb color { default 1 0 0 ; maximum 1 1 1 ; } ; } ;
component copy { texture source { default "" ; } ; string mode { default "soft" ; choices "soft hard" ; } ; } ;
)");
}

TEST(Technique, PassesHaveAllValues) {
    const Descriptors descriptors = sample();
    const TechniqueDefinition technique = technique_of(R"(
help "Draws in red." ;
pass draw_red lines { width 2 ; render 0 ; } ;
pass copy ;
)",
                                                       descriptors);
    EXPECT_EQ(technique.name, "t");
    EXPECT_EQ(technique.help, "Draws in red.");
    ASSERT_EQ(technique.passes.size(), 2u);
    const PassDefinition& lines = *technique.find("lines");
    EXPECT_EQ(lines.component->core, "draw");
    EXPECT_EQ(lines.values.at("width"), Value(2.0f));
    EXPECT_EQ(lines.values.at("render"), Value(false));
    EXPECT_EQ(lines.values.at("program"), Value(std::string("red")));
    EXPECT_EQ(lines.values.at("color"), Value(glm::vec3(1, 0, 0)));
    EXPECT_EQ(technique.find("copy")->where.to_string(), "file:4:1");
    EXPECT_EQ(technique.find("nothing"), nullptr);
}

TEST(Technique, UnnamedPassesAreNumbered) {
    const Descriptors descriptors = sample();
    EXPECT_EQ(technique_of("pass copy {} pass copy copy_2 {} pass copy {} pass copy ;", descriptors).pass_names(),
              (std::vector<std::string>{"copy", "copy_2", "copy_3", "copy_4"}));
}

TEST(Technique, IncludesStandWhereTheyAreNamed) {
    const Descriptors descriptors = sample();
    const TechniqueDefinition technique =
        technique_of("help \"outer\" ; pass copy first ; include \"inner\" ; pass copy last ;", descriptors,
                     {{"inner", "help \"inner\" ; pass draw_red lines ; include \"core\" ;"},
                      {"core", "pass copy middle { source \"a:b\" ; } ;"}});
    EXPECT_EQ(technique.pass_names(), (std::vector<std::string>{"first", "lines", "middle", "last"}));
    EXPECT_EQ(technique.help, "outer");
    EXPECT_EQ(technique.find("middle")->where.to_string(), "core:1:1");
}

TEST(Technique, IncludedPassesAreModified) {
    const Descriptors descriptors = sample();
    const TechniqueDefinition technique =
        technique_of("include \"inner\" ; modify lines { program \"blue\" ; width 3 ; } ; modify lines { width 4 ; } ;",
                     descriptors, {{"inner", "pass draw lines { width 2 ; } ;"}});
    EXPECT_EQ(technique.find("lines")->values.at("program"), Value(std::string("blue")));
    EXPECT_EQ(technique.find("lines")->values.at("width"), Value(4.0f));
}

TEST(Technique, OutOfRangeValuesWarnAndClamp) {
    const Descriptors descriptors = sample();
    std::string printed = printed_by([&] {
        const TechniqueDefinition technique =
            technique_of("pass draw_red x {\n  width 7 ;\n  color 2 0.5 3 ;\n}", descriptors);
        EXPECT_EQ(technique.passes[0].values.at("width"), Value(4.0f));
        EXPECT_EQ(technique.passes[0].values.at("color"), Value(glm::vec3(1, 0.5f, 1)));
    });
    EXPECT_EQ(
        printed,
        "croquis: warning: file:2:9: variable \"width\" of component draw_red: 7 is outside 0 to 4; using 4\n"
        "croquis: warning: file:3:9: variable \"color\" of component draw_red: 2 0.5 3 is above 1 1 1; using 1 0.5 "
        "1\n");
}

TEST(Technique, EmptyIsAllowed) { EXPECT_TRUE(technique_of("", sample()).passes.empty()); }

}  // namespace
}  // namespace croquis::framework
