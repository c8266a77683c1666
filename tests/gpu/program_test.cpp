// Shader programs: errors stand at the user's file and line, whatever it includes.
#include "gpu/program.h"

#include <gtest/gtest.h>

#include <regex>

#include "support/errors.h"
#include "support/studio.h"

namespace croquis::gpu {
namespace {

using test_support::error_of;
using test_support::without;

const std::string shaders = CROQUIS_TEST_DATA "/shaders/";

class ProgramTest : public test_support::StudioTest {
protected:
    // The error of linking a fragment function with the full-screen vertex function, its folder taken away.
    [[nodiscard]] static std::string error_for(const std::string& fragment) {
        return without(error_of([&] { (void)studio().resources().program("image:full_screen", fragment); }), shaders);
    }
    // The same for texts: file 0 and what it includes.
    [[nodiscard]] static std::string error_in(const std::map<std::string, std::string>& files,
                                              const std::string& name) {
        const auto find = [&](const std::string& file) {
            const auto found = files.find(file);
            if (found == files.end()) fail("no shader file \"{}\"", file);
            return ShaderFile{file + ".glsl", found->second};
        };
        return error_of([&] {
            const std::string vertex = "vec4 corner() { return vec4(0.0); }";
            const auto find_vertex = [&](const std::string&) { return ShaderFile{"vertex.glsl", vertex}; };
            const Program program(studio().context(), ShaderSource::read("v:corner", find_vertex),
                                  ShaderSource::read(name, find), Output::one);
        });
    }
};

TEST_F(ProgramTest, AnErrorStandsAtItsLineOfTheIncludedFile) {
    const std::string message = error_for("test_broken:color");
    EXPECT_TRUE(std::regex_search(message, std::regex(R"(^test_broken_part\.glsl:3(:\d+)?: \S)"))) << message;
}

TEST_F(ProgramTest, LinesGoOnAfterAnInclude) {
    const std::map<std::string, std::string> files{
        {"user", "// one\n#include \"part\"\n// three\nvec4 color() { return nothing; }\n"},
        {"part", "float a() { return 1.0; }\n\n\n\n"}};
    const std::string message = error_in(files, "user:color");
    EXPECT_TRUE(std::regex_search(message, std::regex(R"(^user\.glsl:4(:\d+)?: .*nothing)"))) << message;
}

TEST_F(ProgramTest, LinesAreRightWithCarriageReturns) {
    const std::string message = error_in({{"user", "\r\n\r\nvec4 color() { return nothing; }\r\n"}}, "user:color");
    EXPECT_TRUE(std::regex_search(message, std::regex(R"(^user\.glsl:3(:\d+)?: .*nothing)"))) << message;
}

TEST_F(ProgramTest, AMissingFunctionComesWithTheNearest) {
    EXPECT_EQ(error_for("test_image:gray"), "test_image.glsl: no shader function \"gray\"; did you mean \"grey\"?");
}

TEST_F(ProgramTest, AMissingFileComesWithTheNearest) {
    EXPECT_EQ(error_for("imagee:copy"), "no shader file \"imagee\"; did you mean \"image\"?");
}

TEST_F(ProgramTest, AWrongFormIsTold) {
    for (const std::string name : {"image", ":copy", "image:", ""}) {
        EXPECT_EQ(error_for(name), "expected a shader function as file:function, found \"" + name + "\"");
    }
}

TEST_F(ProgramTest, ACycleOfIncludesIsNamed) {
    EXPECT_EQ(error_for("test_cycle_a:color"),
              "test_cycle_a.glsl:1:1: test_cycle_b.glsl:2:1: shader includes form a cycle: "
              "test_cycle_a -> test_cycle_b -> test_cycle_a");
}

TEST_F(ProgramTest, AMissingIncludeStandsAtItsLine) {
    EXPECT_EQ(error_for("test_missing:color"),
              "test_missing.glsl:3:1: no shader file \"imagge\"; did you mean \"image\"?");
}

TEST_F(ProgramTest, IncludesCannotLeaveTheirFolder) {
    EXPECT_EQ(error_for("../shaders/image:copy"), "expected a name inside its data folder, found \"../shaders/image\"");
}

TEST_F(ProgramTest, IncludesAreBounded) {
    std::map<std::string, std::string> files;
    for (int i = 0; i < 40; ++i) {
        files[fmt::format("f{}", i)] = fmt::format("#include \"f{}\"\nvec4 color() {{ return vec4(1.0); }}\n", i + 1);
    }
    const std::string message = error_in(files, "f0:color");
    EXPECT_NE(message.find("shader includes are more than 16 deep at \"f16\""), std::string::npos) << message;
}

TEST_F(ProgramTest, AFileIsIncludedOnce) {
    EXPECT_EQ(error_in({{"user", "#include \"a\"\n#include \"b\"\nvec4 color() { return vec4(one()); }\n"},
                        {"a", "#include \"b\"\n"},
                        {"b", "float one() { return 1.0; }\n"}},
                       "user:color"),
              "no error");
}

TEST_F(ProgramTest, StagesThatDoNotFitAreNamed) {
    const auto find = [](const std::string& file) {
        return file == "corner" ? ShaderFile{"corner.glsl",
                                             "out vec3 shared;\nvec4 at() { shared = vec3(1.0); return vec4(0.0); }\n"}
                                : ShaderFile{"pixel.glsl", "in vec4 shared;\nvec4 color() { return shared; }\n"};
    };
    const std::string message = error_of([&] {
        const Program program(studio().context(), ShaderSource::read("corner:at", find),
                              ShaderSource::read("pixel:color", find), Output::one);
    });
    EXPECT_EQ(message.substr(0, 57), "corner.glsl:at and pixel.glsl:color do not fit together: ") << message;
    EXPECT_NE(message.find("shared"), std::string::npos) << message;
}

TEST_F(ProgramTest, FailuresLeaveNothingAlive) {
    const Counters before = studio().counters();
    (void)error_for("test_broken:color");
    EXPECT_EQ(studio().counters().live_objects(), before.live_objects());
    EXPECT_EQ(studio().counters().programs_linked, before.programs_linked);
}

// Hostile input: a name of a megabyte must not overflow the stack of whoever looks for functions.
void read_long_text() {
    const std::string text =
        "vec4 " + std::string(1 << 19, 'a') + std::string(1 << 19, ' ') + "vec4 color() { return vec4(1.0); }";
    const auto source = ShaderSource::read("user:color", [&](const std::string&) {
        return ShaderFile{"user.glsl", text};
    });
    std::_Exit(source.function == "color" ? 0 : 3);
}

TEST(ShaderSourceTest, ReadsVeryLongWords) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(read_long_text(), ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace croquis::gpu
