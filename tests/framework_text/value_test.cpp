// Values and their text form: reading back what was written changes nothing; wrong text says what was expected.
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "base/random.h"
#include "texts.h"

namespace croquis::framework {
namespace {

// Any finite float, all bit patterns alike.
float random_float(const Random& random, std::uint64_t index) {
    const auto bits = static_cast<std::uint32_t>(random.bits(index));
    float number = 0;
    std::memcpy(&number, &bits, sizeof number);
    return std::isfinite(number) ? number : static_cast<float>(random.unit(index));
}

std::string random_text(const Random& random, std::uint64_t index) {
    constexpr std::array<std::string_view, 8> pieces = {"a", "\"", "\\", " ", "#;{}", "é", "−", "\t"};
    std::string text;
    for (std::uint64_t i = 0; i < random.bits(index) % 12; ++i) {
        text += pieces[random.bits(index * 100 + i + 1) % pieces.size()];
    }
    return text;
}

Value random_value(VariableType type, const Random& random, std::uint64_t index) {
    const auto f = [&](std::uint64_t i) { return random_float(random, index * 4 + i); };
    switch (type) {
        case VariableType::boolean:
            return random.bits(index) % 2 == 0;
        case VariableType::integer:
            return static_cast<std::int32_t>(random.bits(index));
        case VariableType::number:
            return f(0);
        case VariableType::vector2:
            return glm::vec2(f(0), f(1));
        case VariableType::rgb:
        case VariableType::vector3:
            return glm::vec3(f(0), f(1), f(2));
        case VariableType::rgba:
        case VariableType::vector4:
            return glm::vec4(f(0), f(1), f(2), f(3));
        default:
            return random_text(random, index);
    }
}

constexpr std::array all_types = {
    VariableType::boolean, VariableType::integer, VariableType::number, VariableType::string, VariableType::vector2,
    VariableType::vector3, VariableType::vector4, VariableType::rgb,    VariableType::rgba,   VariableType::texture};

TEST(Value, SurvivesBeingWrittenAndRead) {
    const Random random(1, "values");
    for (const VariableType type : all_types) {
        const Descriptors descriptors = descriptors_of(fmt::format("component c {{ {} v ; }} ;", name_of(type)));
        for (std::uint64_t i = 0; i < 2000; ++i) {
            const Value value = random_value(type, random, i);
            const std::string text = format_value(value);
            const TechniqueDefinition technique = technique_of(fmt::format("pass c {{ v {} ; }}", text), descriptors);
            ASSERT_EQ(technique.passes[0].values.at("v"), value) << text;
            if (number_count(type) > 0) {
                ASSERT_EQ(parse_value(type, text), value) << text;
            }
        }
    }
}

TEST(Value, TextIsShort) {
    EXPECT_EQ(format_value(0.1f), "0.1");
    EXPECT_EQ(format_value(1.0f), "1");
    EXPECT_EQ(format_value(glm::vec3(0.5f, 0.5f, 1)), "0.5 0.5 1");
    EXPECT_EQ(format_value(true), "true");
    EXPECT_EQ(format_value(-3), "-3");
    EXPECT_EQ(format_value(std::string("say \"a\\b\"")), R"("say \"a\\b\"")");
}

TEST(Value, NamesOfTypesAreUnique) {
    for (const VariableType type : all_types) EXPECT_EQ(type_named(name_of(type)), type);
    EXPECT_EQ(type_named("float"), std::nullopt);
}

TEST(Value, CommandLineFormsAreRead) {
    EXPECT_EQ(parse_value(VariableType::vector3, "1, 2,3"), Value(glm::vec3(1, 2, 3)));
    EXPECT_EQ(parse_value(VariableType::rgb, " 1 0.5\t.25 "), Value(glm::vec3(1, 0.5f, 0.25f)));
    EXPECT_EQ(parse_value(VariableType::string, "two words"), Value(std::string("two words")));
    EXPECT_EQ(parse_value(VariableType::string, ""), Value(std::string()));
    EXPECT_EQ(parse_value(VariableType::boolean, "true"), Value(true));
    EXPECT_EQ(parse_value(VariableType::boolean, "0"), Value(false));
    EXPECT_EQ(parse_value(VariableType::boolean, "-7"), Value(true));
    EXPECT_EQ(parse_value(VariableType::integer, "+5"), Value(5));
    EXPECT_EQ(parse_value(VariableType::integer, "-2147483648"), Value(std::numeric_limits<std::int32_t>::min()));
    EXPECT_EQ(parse_value(VariableType::number, "7"), Value(7.0f));
    EXPECT_EQ(parse_value(VariableType::number, "−1e−2"), Value(-0.01f));
    EXPECT_EQ(parse_value(VariableType::number, "1e-60"), Value(0.0f));
}

struct BadValue {
    VariableType type;
    std::string text;
    std::string message;
};

TEST(Value, WrongTextSaysWhatIsExpected) {
    const std::vector<BadValue> cases = {
        {VariableType::number, "abc", R"(expected a number, found "abc")"},
        {VariableType::number, "", "expected a number, found nothing"},
        {VariableType::number, "nan", R"(expected a number, found "nan")"},
        {VariableType::number, "-inf", R"(expected a number, found "-inf")"},
        {VariableType::number, "infinity", R"(expected a number, found "infinity")"},
        {VariableType::number, "1e39", R"(expected a number of at most 3.4e+38, found "1e39")"},
        {VariableType::number, "1e999999999999999999999",
         R"(expected a number of at most 3.4e+38, found "1e999999999999999999999")"},
        {VariableType::number, "+-1", R"(expected a number, found "+-1")"},
        {VariableType::number, "1 2", R"(expected a number, found "1 2")"},
        {VariableType::number, "0x10", R"(expected a number, found "0x10")"},
        {VariableType::integer, "0.5", R"(expected a whole number, found "0.5")"},
        {VariableType::integer, "2147483648",
         R"(expected a whole number from -2147483648 to 2147483647, found "2147483648")"},
        {VariableType::boolean, "yes", R"(expected true or false, found "yes")"},
        {VariableType::vector2, "1", R"(expected 2 numbers, found "1")"},
        {VariableType::vector3, "1 x 2", R"(expected 3 numbers, found "x")"},
        {VariableType::rgb, "1 1", R"(expected 3 numbers (red green blue), found "1 1")"},
        {VariableType::rgba, "1 1 1", R"(expected 4 numbers (red green blue alpha), found "1 1 1")"},
        {VariableType::texture, "a\nb", "expected a text of one line, found a control character"},
        {VariableType::number, std::string(59, 'x') + "éé",
         "expected a number, found \"" + std::string(59, 'x') + "…\""},
    };
    for (const BadValue& c : cases) {
        EXPECT_EQ(message_of([&] { (void)parse_value(c.type, c.text); }), c.message);
    }
}

TEST(Value, VectorFillsFromTheLeft) {
    EXPECT_EQ(as_vector(true), glm::vec4(1, 0, 0, 0));
    EXPECT_EQ(as_vector(-2), glm::vec4(-2, 0, 0, 0));
    EXPECT_EQ(as_vector(glm::vec3(1, 2, 3)), glm::vec4(1, 2, 3, 0));
    EXPECT_EQ(as_vector(std::string("x")), glm::vec4(0));
}

}  // namespace
}  // namespace croquis::framework
