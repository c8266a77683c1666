// The exact errors for wrong descriptor files: messages are interface.
#include "texts.h"

namespace croquis::framework {
namespace {

struct Wrong {
    std::string text;
    std::string message;
};

void expect_messages(const std::vector<Wrong>& cases) {
    for (const Wrong& c : cases) EXPECT_EQ(message_of([&] { descriptors_of(c.text); }), c.message) << c.text;
}

TEST(DescriptorMessages, Syntax) {
    expect_messages({
        {"", "no error"},
        {"# nothing", "no error"},
        {"foo", R"(file:1:1: expected "component", found "foo")"},
        {"\n  componen a {}", R"(file:2:3: expected "component", found "componen"; did you mean "component"?)"},
        {"component {", "file:1:11: expected a name for the component, found '{'"},
        {"component 2d {", R"(file:1:11: expected a name for the component, found "2d")"},
        {"component a-b {", R"(file:1:11: expected a name for the component, found "a-b")"},
        {"component", "file:1:10: expected a name for the component, found the end of the file"},
        {"component a", "file:1:12: expected '{' after the component's name, found the end of the file"},
        {"component a b {", R"(file:1:13: expected '{' after the component's name, found "b")"},
        {"component a : {", "file:1:15: expected the name of the component it inherits from, found '{'"},
        {"component a: b:c {", "file:1:15: expected '{' after the component's name, found \":c\""},
        {"component a { ; }", R"(file:1:15: expected a type, "modify", "help" or '}', found ';')"},
        {"component a {\n  int b ;\n",
         "file:3:1: expected a type, \"modify\", \"help\" or '}', found the end of the file; the '{' of component "
         "\"a\" in "
         "line 1 is not closed"},
        {"component a {\n  int b ;\ncomponent c { }",
         "file:3:1: expected a type, \"modify\", \"help\" or '}', found \"component\"; the '{' of component \"a\" in "
         "line 1 is not closed"},
        {"component a { } }", "file:1:17: expected \"component\", found '}'"},
        {"component a { } ; ;", "file:1:19: expected \"component\", found ';'"},
        {"component a { numbr b ; }", R"(file:1:15: unknown type "numbr"; did you mean "number"?)"},
        {"component a { number ; }", "file:1:22: expected a name for the variable, found ';'"},
        {"component a { number 3 ; }", R"(file:1:22: expected a name for the variable, found "3")"},
        {"component a { number b }", "file:1:24: expected ';' or '{' after the variable's name, found '}'"},
        {"component a { number b { 3 ; } }", R"(file:1:26: expected a property or '}', found "3")"},
        {"component a {\n number b {\n default 3 ;",
         "file:3:13: expected a property or '}', found the end of the file; the '{' of variable \"b\" in line 2 is not "
         "closed"},
        {"component a { number b { default ; } }", "file:1:34: expected a value, found ';'"},
        {"component a { number b {\n  default 3\n} }", "file:3:1: expected ';' after the value, found '}'"},
        {"component a { string b { default \"x\" 3 ; } }", R"(file:1:38: expected ';' after the value, found "3")"},
        {"component a { number b { default 3 \"x\" ; } }",
         "file:1:36: expected ';' after the value, found a quoted text"},
        {"component a { modify ; }", "file:1:22: expected the name of the variable to modify, found ';'"},
        {"component a { modify b ; }", "file:1:24: expected '{' after the variable's name, found ';'"},
        {"component a { help text ; }", R"(file:1:20: expected a help text in double quotes, found "text")"},
        {"component a { help \"text\" }", "file:1:27: expected ';' after the value, found '}'"},
        {"component a { help \"x\" ; help \"y\" ; }", R"(file:1:31: component "a" has a help text already)"},
    });
}

TEST(DescriptorMessages, Characters) {
    expect_messages({
        {"component a { help \"open\n ; }", "file:1:20: this quoted text has no closing '\"' in its line"},
        {"component a { help \"é\" \"open", "file:1:24: this quoted text has no closing '\"' in its line"},
        {"component a { help \"a\\n\" ; }",
         "file:1:22: expected \\\" or \\\\ here: a backslash in a quoted text stands before these only"},
        {"# é−\xF0\x9F\x8E\xA8 x\n# é\xFF", "file:2:4: expected UTF-8 text, found the byte 0xFF"},
        {"\xC0\xAF", "file:1:1: expected UTF-8 text, found the byte 0xC0"},
        {"\xED\xA0\x80", "file:1:1: expected UTF-8 text, found the byte 0xED"},
        {"\xF4\x90\x80\x80", "file:1:1: expected UTF-8 text, found the byte 0xF4"},
        {"\xE2\x88", "file:1:1: expected UTF-8 text, found the byte 0xE2"},
        {std::string("component a { \0 }", 17), "file:1:15: found the control character U+0000"},
        {"\xEF\xBB\xBF\x1B", "file:1:1: found the control character U+001B"},
        {"# été\n\"é\" x", "file:2:1: expected \"component\", found a quoted text"},
        {"component a { help \"é−\" x", R"(file:1:25: expected ';' after the value, found "x")"},
    });
}

TEST(DescriptorMessages, Values) {
    expect_messages({
        {"component a { int b { default 0.5 ; } }",
         R"(file:1:31: default of variable "b" expects a whole number, found "0.5")"},
        {"component a { number b { default abc ; } }",
         R"(file:1:34: default of variable "b" expects a number, found "abc")"},
        {"component a { number b { default \"1\" ; } }",
         R"(file:1:34: default of variable "b" expects a number, found the quoted text "1")"},
        {"component a { number b { maximum inf ; } }",
         R"(file:1:34: maximum of variable "b" expects a number, found "inf")"},
        {"component a { string b { default abc ; } }",
         R"(file:1:34: default of variable "b" expects a text in double quotes, found "abc")"},
        {"component a { rgb b { default 1 0 ; } }",
         R"(file:1:31: default of variable "b" expects 3 numbers (red green blue), found "1 0")"},
        {"component a { vector3 b { default 1 x 0 ; } }",
         R"(file:1:37: default of variable "b" expects 3 numbers, found "x")"},
        {"component a { bool b { default maybe ; } }",
         R"(file:1:32: default of variable "b" expects true or false, found "maybe")"},
        {"component a { bool b { internal 0.5 ; } }",
         R"(file:1:33: internal of variable "b" expects true or false, found "0.5")"},
        {"component a { bool b { help 5 ; } }",
         R"(file:1:29: help of variable "b" expects a text in double quotes, found "5")"},
        {"component a { number b { default 1\n maximum 2 ; } }",
         "file:1:34: default of variable \"b\" expects a number, found \"1 maximum 2\"; is a ';' missing at the end of "
         "line 1?"},
    });
}

TEST(DescriptorMessages, Properties) {
    expect_messages({
        {"component a { number b { dafault 1 ; } }",
         R"(file:1:26: variable "b" has no property "dafault"; did you mean "default"?)"},
        {"component a { number b { default 1 ; default 2 ; } }", R"(file:1:38: variable "b" sets "default" twice)"},
        {"component a { bool b { minimum 0 ; } }",
         R"(file:1:24: variable "b" is of type bool, which has no range: minimum is not allowed)"},
        {"component a { string b { ui_maximum \"z\" ; } }",
         R"(file:1:26: variable "b" is of type string, which has no range: ui_maximum is not allowed)"},
        {"component a { texture b { maximum 1 ; } }",
         R"(file:1:27: variable "b" is of type texture, which has no range: maximum is not allowed)"},
        {"component a { int b { choices \"1 2\" ; } }",
         R"(file:1:23: variable "b" is of type int, which has no choices: choices is not allowed)"},
        {"component a { string b { form \"flat\" ; } }",
         R"(file:1:26: variable "b" is of type string, which has no form: form is not allowed)"},
        {"component a { texture b { form \"volumes\" ; } }",
         R"(file:1:32: form of variable "b" expects one of "flat", "volume", "tonal"; found "volumes"; did you mean "volume"?)"},
        {"component a { number b { default 7 ; minimum -1 ; maximum 1 ; } }",
         R"(file:1:34: default of variable "b": 7 is outside -1 to 1)"},
        {"component a { rgb b { default 0 0 2 ; maximum 1 1 1 ; } }",
         R"(file:1:31: default of variable "b": 0 0 2 is above 1 1 1)"},
        {"component a { number b { default 7 ; } modify b { maximum 5 ; } }",
         R"(file:1:59: default of variable "b": 7 is above 5)"},
        {"component a { number b { minimum 2 ; maximum 1 ; } }",
         R"(file:1:34: variable "b": its minimum 2 is above its maximum 1)"},
        {"component a { vector2 b { ui_minimum 0 2 ; ui_maximum 1 1 ; } }",
         R"(file:1:38: variable "b": its ui_minimum 0 2 is above its ui_maximum 1 1)"},
        {"component a { number b { minimum 0 ; ui_minimum -1 ; } }",
         R"(file:1:34: variable "b": its minimum 0 is above its ui_minimum -1)"},
        {"component a { string b { choices \"x y\" ; default \"z\" ; } }",
         R"(file:1:50: default of variable "b" expects one of "x", "y"; found "z")"},
    });
}

TEST(DescriptorMessages, Names) {
    expect_messages({
        {"component a { int b ; int b ; }", R"(file:1:27: variable "b" is already declared in line 1)"},
        {"component a { int b ; } component c : a { int b ; }",
         "file:1:47: component c inherits a variable \"b\"; to change it write: modify b { … }"},
        {"component every_component { bool render ; } component a { bool render ; }",
         "file:1:64: component a inherits a variable \"render\"; to change it write: modify render { … }"},
        {"component a { number threshold ; modify treshold { } }",
         R"(file:1:41: component a has no variable "treshold" to modify; did you mean "threshold"?)"},
        {"component a { } component a { }", R"(file:1:27: component "a" is already declared at file:1:11)"},
        {"component simple { } component b : simpel { }",
         R"(file:1:36: component "b" inherits from unknown component "simpel"; did you mean "simple"?)"},
        {"component a : a { }", R"(file:1:15: component "a" inherits from itself: a inherits a)"},
        {"component a : b { } component b : c { }\ncomponent c : a { }",
         R"(file:1:15: component "a" inherits from itself: a inherits b inherits c inherits a)"},
        {"component x : a { } component a : b { } component b : a { }",
         R"(file:1:35: component "a" inherits from itself: a inherits b inherits a)"},
    });
}

}  // namespace
}  // namespace croquis::framework
