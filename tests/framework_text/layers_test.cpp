// A user's folder of descriptors over the shipped one.
#include "texts.h"

namespace croquis::framework {
namespace {

Descriptors layered(const std::string& shipped, const std::string& users) {
    const std::vector<std::vector<Descriptors::Source>> layers{{{"shipped", shipped}}, {{"users", users}}};
    return Descriptors(layers);
}

TEST(Layers, ALaterComponentReplacesAndIsInherited) {
    const Descriptors descriptors = layered("component a { number v { default 1 ; } } component b : a { number own ; }",
                                            "component a { number v { default 2 ; } number more ; }");
    EXPECT_EQ(descriptors.at("a").where.file, "users");
    EXPECT_EQ(descriptors.at("b").variable_names(), (std::vector<std::string>{"v", "more", "own"}));
    EXPECT_EQ(descriptors.at("b").find("v")->default_value, Value(2.0f));
}

TEST(Layers, UsersMayInheritFromShipped) {
    const Descriptors descriptors = layered("component a { number v ; }", "component mine : a { }");
    EXPECT_EQ(descriptors.at("mine").core, "a");
}

TEST(Layers, WhatNoLongerFitsIsLeftOutWithItsReason) {
    const std::string shipped =
        "component a { number v ; }\ncomponent b : a {\n  modify v { default 1 ; } }\ncomponent c : b { }\n"
        "component d { }";
    std::optional<Descriptors> descriptors;
    const std::string printed =
        printed_by([&] { descriptors.emplace(layered(shipped, "component a { number w ; }")); });
    EXPECT_EQ(descriptors->names(), (std::vector<std::string>{"a", "d"}));
    EXPECT_EQ(descriptors->find("b"), nullptr);
    EXPECT_EQ(message_of([&] { (void)descriptors->at("b"); }),
              R"(component "b" was left out: shipped:3:10: component b has no variable "v" to modify)");
    EXPECT_EQ(
        message_of([&] { (void)descriptors->at("c"); }),
        "component \"c\" was left out: it inherits from b: shipped:3:10: component b has no variable \"v\" to modify");
    EXPECT_EQ(message_of([&] { technique_of("pass b {}", *descriptors); }),
              "file:1:6: component \"b\" was left out: shipped:3:10: component b has no variable \"v\" to modify");
    EXPECT_EQ(
        printed,
        "croquis: warning: component \"b\" does not fit what replaced a component that it inherits from, and is left "
        "out: shipped:3:10: component b has no variable \"v\" to modify\n"
        "croquis: warning: component \"c\" does not fit what replaced a component that it inherits from, and is left "
        "out: it inherits from b: shipped:3:10: component b has no variable \"v\" to modify\n");
}

TEST(Layers, ReplacingEveryComponentIsNoticed) {
    std::optional<Descriptors> descriptors;
    const std::string printed = printed_by([&] {
        descriptors.emplace(
            layered("component every_component { bool render ; } component x { modify render { default "
                    "1 ; } } component y { }",
                    "component every_component { bool rendered ; }"));
    });
    EXPECT_EQ(descriptors->names(), (std::vector<std::string>{"y"}));
    EXPECT_NE(printed.find("did you mean \"rendered\"?"), std::string::npos);
}

TEST(Layers, AUsersOwnMistakeIsAnError) {
    EXPECT_EQ(message_of([] { layered("component a { number v ; }", "component b : a { modify w { } }"); }),
              R"(users:1:26: component b has no variable "w" to modify)");
}

TEST(Layers, TwoOfOneNameInOneLayerAreAnError) {
    const std::vector<std::vector<Descriptors::Source>> layers{
        {{"one", "component a { }"}, {"two", "\n component a { }"}}};
    EXPECT_EQ(message_of([&] { Descriptors{layers}; }), R"(two:2:12: component "a" is already declared at one:1:11)");
}

}  // namespace
}  // namespace croquis::framework
