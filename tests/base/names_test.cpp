// Typos find the name that was meant; patterns match as a shell's do.
#include "base/names.h"

#include <gtest/gtest.h>

namespace croquis {
namespace {

struct Typo {
    const char* typed;
    const char* nearest;
};

class NearestName : public ::testing::TestWithParam<Typo> {};

TEST_P(NearestName, IsTheOneMeant) {
    const std::vector<std::string> known{"threshold", "edge_color", "render",  "toon_map",    "id",
                                         "objects",   "toon",       "cartoon", "render_phong"};
    EXPECT_EQ(nearest_name(GetParam().typed, known), GetParam().nearest) << GetParam().typed;
}

INSTANTIATE_TEST_SUITE_P(Typos, NearestName,
                         ::testing::Values(Typo{"treshold", "threshold"},    // one letter missing
                                           Typo{"thresholdd", "threshold"},  // one too many
                                           Typo{"thershold", "threshold"},   // two swapped
                                           Typo{"rendar", "render"},         // one wrong
                                           Typo{"tonmapp", ""},  // three edits of seven letters are too many
                                           Typo{"edge_colour", "edge_color"},    //
                                           Typo{"threshold", "threshold"},       //
                                           Typo{"xyzzy", ""},                    // nothing like it
                                           Typo{"ab", ""},                       // nothing in common with id
                                           Typo{"ix", "id"},                     // one edit of up to three letters
                                           Typo{"own", ""},                      // but not two
                                           Typo{"ton", "toon"},                  //
                                           Typo{"tone", "toon"},                 // two edits of up to six letters
                                           Typo{"tames", ""},                    // but not three
                                           Typo{"cartoom", "cartoon"},           //
                                           Typo{"render_fong", "render_phong"},  //
                                           Typo{"", ""}),
                         [](const auto& tested) { return "Case" + std::to_string(tested.index); });

TEST(NearestName, OfNothingIsNothing) { EXPECT_EQ(nearest_name("a", {}), ""); }

TEST(NearestName, OfAVeryLongNameIsNothing) {
    const std::vector<std::string> known{std::string(250, 'a')};
    EXPECT_EQ(nearest_name(std::string(250, 'a'), known), "");
}

TEST(Suggestion, IsTheTailOfAnError) {
    const std::vector<std::string> known{"threshold"};
    EXPECT_EQ(suggestion("treshold", known), "; did you mean \"threshold\"?");
    EXPECT_EQ(suggestion("xyzzy", known), "");
}

struct Pattern {
    const char* name;
    const char* pattern;
    bool matches;
};

class MatchesPattern : public ::testing::TestWithParam<Pattern> {};

TEST_P(MatchesPattern, AsAShellDoes) {
    const Pattern& c = GetParam();
    EXPECT_EQ(matches_pattern(c.name, c.pattern), c.matches) << c.name << " against " << c.pattern;
}

INSTANTIATE_TEST_SUITE_P(Patterns, MatchesPattern,
                         ::testing::Values(Pattern{"teapot", "teapot", true}, Pattern{"teapot", "Teapot", false},
                                           Pattern{"teapot", "tea*", true}, Pattern{"teapot", "*pot", true},
                                           Pattern{"teapot", "*", true}, Pattern{"", "*", true}, Pattern{"", "", true},
                                           Pattern{"", "?", false}, Pattern{"teapot", "te?pot", true},
                                           Pattern{"teapot", "te?ot", false}, Pattern{"teapot", "tea", false},
                                           Pattern{"teapot", "*a*o*", true}, Pattern{"teapot", "*t*t*t*", false},
                                           Pattern{"abababc", "*abc", true}, Pattern{"abababc", "a*b*c", true},
                                           Pattern{"teapot", "teapot**", true}, Pattern{"a*", "a*b", false}),
                         [](const auto& tested) { return "Case" + std::to_string(tested.index); });

TEST(MatchesPattern, ManyStarsEndInTime) {
    std::string pattern;
    for (int i = 0; i < 40; ++i) pattern += "*a";
    EXPECT_FALSE(matches_pattern(std::string(4000, 'a'), pattern + "b"));
}

TEST(Split, LeavesNoEmptyPieces) {
    EXPECT_EQ(split("  a, b,,c ", " ,"), (std::vector<std::string>{"a", "b", "c"}));
    EXPECT_TRUE(split(" , ", " ,").empty());
}

}  // namespace
}  // namespace croquis
