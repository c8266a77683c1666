// The exact errors for wrong technique files: messages are interface.
#include "texts.h"

namespace croquis::framework {
namespace {

struct Wrong {
    std::string text;
    std::string message;
};

Descriptors sample() {
    return descriptors_of(R"(
component every_component { bool render { default true ; } ; } ;
component render_phong { number threshold { default 0 ; minimum -1 ; maximum 1 ; } ; int count { default 1 ; } ;
  rgb edge_color { default 0 0 0 ; } ; bool invert { default 0 ; } ; texture texture { default "" ; } ;
  string mode { default "soft" ; choices "soft hard" ; } ; } ;
component process_texture { string fragment_program ; } ;
)");
}

void expect_messages(const std::vector<Wrong>& cases, const std::map<std::string, std::string>& others = {}) {
    const Descriptors descriptors = sample();
    for (const Wrong& c : cases) {
        EXPECT_EQ(message_of([&] { technique_of(c.text, descriptors, others); }), c.message) << c.text;
    }
}

TEST(TechniqueMessages, Syntax) {
    expect_messages({
        {"foo", R"(file:1:1: expected "pass", "include", "modify" or "help", found "foo")"},
        {"pas render_phong {}",
         R"(file:1:1: expected "pass", "include", "modify" or "help", found "pas"; did you mean "pass"?)"},
        {"pass {", "file:1:6: expected the name of the pass's component, found '{'"},
        {"pass \"x\" {", "file:1:6: expected the name of the pass's component, found a quoted text"},
        {"pass render_phong", "file:1:18: expected a name for the pass or '{', found the end of the file"},
        {"pass render_phong 2x {", R"(file:1:19: expected a name for the pass or '{', found "2x")"},
        {"pass render_phong x y {", R"(file:1:21: expected '{' after the pass's name, found "y")"},
        {"pass render_phong x { ; }", "file:1:23: expected a variable or '}', found ';'"},
        {"\npass render_phong x {\n  count 3 ;",
         "file:3:12: expected a variable or '}', found the end of the file; the '{' of pass \"x\" in line 2 is not "
         "closed"},
        {"pass render_phong {\n  count",
         "file:2:8: expected a value, found the end of the file; the '{' of pass \"render_phong\" in line 1 is not "
         "closed"},
        {"pass render_phong x {\n\n\n\n  count 3\n  }", "file:6:3: expected ';' after the value, found '}'"},
        {"pass render_phong x {\n  count 3 ;\npass render_phong y {",
         "file:3:21: expected ';' after the value, found '{'; the '{' of pass \"x\" in line 1 is not closed"},
        {"pass render_phong x { } x", R"(file:1:25: expected "pass", "include", "modify" or "help", found "x")"},
        {"include edges ;", R"(file:1:9: expected the name of a technique in double quotes, found "edges")"},
        {"include \"edges\"", "file:1:16: expected ';' after the value, found the end of the file"},
        {"help ;", "file:1:6: expected a help text in double quotes, found ';'"},
        {"modify {", "file:1:8: expected the name of the pass to modify, found '{'"},
        {"modify x ;", "file:1:10: expected '{' after the pass's name, found ';'"},
        {"component a { }", R"(file:1:1: expected "pass", "include", "modify" or "help", found "component")"},
    });
}

TEST(TechniqueMessages, Names) {
    expect_messages({
        {"\n\npass render_fong {}", R"(file:3:6: unknown component "render_fong"; did you mean "render_phong"?)"},
        {"pass every_component {}",
         "file:1:6: component every_component only lends its variables to the others; no pass can use it"},
        {"pass render_phong edges {\n  treshold 0.7 ;\n}",
         "file:2:3: pass \"edges\" sets \"treshold\", which component render_phong does not have; did you mean "
         "\"threshold\"?"},
        {"pass render_phong a { count 1 ; count 2 ; }", R"(file:1:33: pass "a" sets "count" twice)"},
        {"\npass process_texture x { }",
         R"(file:2:1: pass "x" must set "fragment_program": component process_texture gives it no default)"},
        {"pass render_phong a {}\npass render_phong a {}", R"(file:2:19: there is a pass "a" already, at file:1:1)"},
        {"pass render_phong edges {} modify edgs { }",
         R"(file:1:35: there is no pass "edgs" above to modify; did you mean "edges"?)"},
        {"modify edges { } pass render_phong edges {}", R"(file:1:8: there is no pass "edges" above to modify)"},
    });
}

TEST(TechniqueMessages, Values) {
    const std::string threshold = R"(variable "threshold" of component render_phong expects a number, found )";
    expect_messages({
        {"pass render_phong a {\n\n\n    threshold abc ;\n}", "file:4:15: " + threshold + "\"abc\""},
        {"pass render_phong a { threshold \"abc\" ; }", "file:1:33: " + threshold + "the quoted text \"abc\""},
        {"pass render_phong a { threshold 1 2 ; }", "file:1:33: " + threshold + "\"1 2\""},
        {"pass render_phong a { threshold 0.5\n count 3 ; }",
         "file:1:33: " + threshold + "\"0.5 count 3\"; is a ';' missing at the end of line 1?"},
        {"pass render_phong a { count 1.5 ; }",
         R"(file:1:29: variable "count" of component render_phong expects a whole number, found "1.5")"},
        {"pass render_phong a { edge_color 1 1 red ; }",
         R"(file:1:38: variable "edge_color" of component render_phong expects 3 numbers (red green blue), found "red")"},
        {"pass render_phong a { invert on ; }",
         R"(file:1:30: variable "invert" of component render_phong expects true or false, found "on")"},
        {"pass render_phong a { texture images:* ; }",
         "file:1:31: variable \"texture\" of component render_phong expects a texture name in double quotes, found "
         "\"images:*\""},
        {"pass render_phong a { mode \"sofd\" ; }",
         "file:1:28: variable \"mode\" of component render_phong expects one of \"soft\", \"hard\"; found \"sofd\"; "
         "did you "
         "mean \"soft\"?"},
    });
}

TEST(TechniqueMessages, Includes) {
    expect_messages(
        {
            {"include \"nothing\" ;", R"(file:1:9: unknown technique "nothing")"},
            {"include \"t\" ;", "file:1:9: the includes never end: t includes t"},
            {"include \"a\" ;", "b:1:9: the includes never end: a includes b includes a"},
            {"include \"back\" ;", "back:1:9: the includes never end: t includes back includes t"},
            {"include \"wrong\" ;", R"(wrong:1:6: unknown component "x")"},
            {"pass render_phong p ; include \"p\" ;", R"(p:1:19: there is a pass "p" already, at file:1:1)"},
        },
        {{"a", "include \"b\" ;"},
         {"b", "include \"a\" ;"},
         {"back", "include \"t\" ;"},
         {"wrong", "pass x ;"},
         {"p", "pass render_phong p ;"}});
}

TEST(TechniqueMessages, Bounds) {
    std::map<std::string, std::string> deep;
    for (int i = 0; i < 40; ++i) deep[fmt::format("d{}", i)] = fmt::format("include \"d{}\" ;", i + 1);
    expect_messages({{"include \"d0\" ;", "d14:1:9: includes are nested more than 16 deep"}}, deep);
    // Each includes the next twice: 2^14 in all.
    std::map<std::string, std::string> wide;
    for (int i = 0; i < 14; ++i)
        wide[fmt::format("w{}", i)] = fmt::format("include \"w{0}\" ; include \"w{0}\" ;", i + 1);
    wide["w14"] = "";
    expect_messages({{"include \"w0\" ;", "w12:1:9: more than 256 includes"}}, wide);
    std::string many;
    for (int i = 0; i < 257; ++i) many += "pass render_phong ;\n";
    expect_messages({{many, "file:257:1: more than 256 passes"}});
    expect_messages({{std::string((1 << 20) + 1, '#'), "file: larger than the 1 MiB allowed here"}});
}

}  // namespace
}  // namespace croquis::framework
