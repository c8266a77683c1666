// Values of component variables as text (seed C, 2.2.2): one reader for files and the command line.
#include "framework/value.h"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/names.h"

namespace croquis::framework {
namespace {

struct TypeTraits {
    VariableType type;
    std::string_view name;
    int numbers;
    std::string_view expected;
};

constexpr std::array<TypeTraits, 10> all_types{{
    {VariableType::boolean, "bool", 1, "true or false"},
    {VariableType::integer, "int", 1, "a whole number"},
    {VariableType::number, "number", 1, "a number"},
    {VariableType::string, "string", 0, "a text in double quotes"},
    {VariableType::vector2, "vector2", 2, "2 numbers"},
    {VariableType::vector3, "vector3", 3, "3 numbers"},
    {VariableType::vector4, "vector4", 4, "4 numbers"},
    {VariableType::rgb, "rgb", 3, "3 numbers (red green blue)"},
    {VariableType::rgba, "rgba", 4, "4 numbers (red green blue alpha)"},
    {VariableType::texture, "texture", 0, "a texture name in double quotes"},
}};

const TypeTraits& traits(VariableType type) {
    return *std::find_if(all_types.begin(), all_types.end(), [&](const TypeTraits& t) { return t.type == type; });
}

// A number as the standard parsers want it: the typographic minus sign (U+2212), which printed listings have, made
// plain, and no leading plus sign.
std::string plain_number(std::string_view word) {
    constexpr std::string_view typographic_minus = "\xE2\x88\x92";
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    std::string plain;
    while (!word.empty()) {
        const bool is_minus = word.substr(0, typographic_minus.size()) == typographic_minus;
        plain += is_minus ? '-' : word[0];
        word.remove_prefix(is_minus ? typographic_minus.size() : 1);
    }
    return plain;
}

template <typename Number>
struct ParsedNumber {
    std::optional<Number> number;
    bool out_of_range = false;
};

ParsedNumber<float> parse_float(std::string_view word) {
    const std::string plain = plain_number(word);
    // fast_float also reads "nan" and "infinity", which are no settings.
    if (plain.find_first_not_of("0123456789+-.eE") != std::string::npos) return {};
    float number = 0;
    const auto result = fast_float::from_chars(plain.data(), plain.data() + plain.size(), number);
    if (result.ptr != plain.data() + plain.size() || plain.empty()) return {};
    if (!std::isfinite(number)) return {std::nullopt, true};
    if (result.ec == std::errc::invalid_argument) return {};
    return {number, false};
}

ParsedNumber<std::int32_t> parse_int(std::string_view word) {
    const std::string plain = plain_number(word);
    std::int32_t number = 0;
    const auto result = std::from_chars(plain.data(), plain.data() + plain.size(), number);
    if (result.ptr != plain.data() + plain.size() || plain.empty()) return {};
    if (result.ec == std::errc::result_out_of_range) return {std::nullopt, true};
    if (result.ec != std::errc{}) return {};
    return {number, false};
}

std::string shown_word(const std::string& word) { return shown(std::span(&word, 1)); }

ReadValue refused(VariableType type, std::string found, std::size_t word) {
    return {std::nullopt, std::string(traits(type).expected), std::move(found), word};
}

ReadValue read_bool(const std::string& word) {
    if (word == "true") return {true, {}, {}, 0};
    if (word == "false") return {false, {}, {}, 0};
    const auto parsed = parse_int(word);
    if (!parsed.number) return refused(VariableType::boolean, shown_word(word), 0);
    return {*parsed.number != 0, {}, {}, 0};
}

ReadValue read_int(const std::string& word) {
    const auto parsed = parse_int(word);
    if (parsed.number) return {*parsed.number, {}, {}, 0};
    if (!parsed.out_of_range) return refused(VariableType::integer, shown_word(word), 0);
    return {std::nullopt, "a whole number from -2147483648 to 2147483647", shown_word(word), 0};
}

Value value_of(VariableType type, const std::array<float, 4>& n) {
    switch (number_count(type)) {
        case 1:
            return n[0];
        case 2:
            return glm::vec2(n[0], n[1]);
        case 3:
            return glm::vec3(n[0], n[1], n[2]);
        default:
            return glm::vec4(n[0], n[1], n[2], n[3]);
    }
}

ReadValue read_numbers(VariableType type, std::span<const std::string> words) {
    std::array<float, 4> numbers{};
    for (std::size_t i = 0; i < words.size(); ++i) {
        const auto parsed = parse_float(words[i]);
        if (parsed.out_of_range) return {std::nullopt, "a number of at most 3.4e+38", shown_word(words[i]), i};
        if (!parsed.number) return refused(type, shown_word(words[i]), i);
        numbers[i] = *parsed.number;
    }
    return {value_of(type, numbers), {}, {}, 0};
}

}  // namespace

std::string_view name_of(VariableType type) { return traits(type).name; }

std::optional<VariableType> type_named(std::string_view name) {
    for (const TypeTraits& t : all_types) {
        if (t.name == name) return t.type;
    }
    return std::nullopt;
}

int number_count(VariableType type) { return traits(type).numbers; }

std::string_view expectation(VariableType type) { return traits(type).expected; }

std::string shown(std::span<const std::string> words) {
    constexpr std::size_t most_bytes = 60;
    std::string text;
    for (const std::string& word : words) {
        if (text.size() > most_bytes) break;
        text += (text.empty() ? "" : " ") + word;
    }
    if (text.empty()) return "nothing";
    if (text.size() <= most_bytes) return fmt::format("\"{}\"", text);
    std::size_t end = most_bytes;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;  // not within a code point
    return fmt::format("\"{}…\"", std::string_view(text).substr(0, end));
}

ReadValue read_value(VariableType type, std::span<const std::string> words) {
    const auto expected_words = static_cast<std::size_t>(std::max(1, number_count(type)));
    if (words.size() != expected_words) return refused(type, shown(words), 0);
    switch (type) {
        case VariableType::string:
        case VariableType::texture:
            return {words[0], {}, {}, 0};
        case VariableType::boolean:
            return read_bool(words[0]);
        case VariableType::integer:
            return read_int(words[0]);
        default:
            return read_numbers(type, words);
    }
}

Value parse_value(VariableType type, std::string_view text) {
    const bool is_text = number_count(type) == 0;
    // A file could not hold such a text, and a file name must not.
    const auto is_control = [](char c) { return (c >= 0 && c < ' ' && c != '\t') || c == '\x7F'; };
    if (is_text && std::any_of(text.begin(), text.end(), is_control)) {
        fail("expected a text of one line, found a control character");
    }
    const std::vector<std::string> words = is_text ? std::vector{std::string(text)} : split(text, " ,\t\r\n");
    ReadValue read = read_value(type, words);
    if (!read.value) fail("expected {}, found {}", read.expected, read.found);
    return *std::move(read.value);
}

std::string quote(std::string_view text) {
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += c;
    }
    return quoted + '"';
}

namespace {

struct Formatting {
    std::string operator()(bool b) const { return b ? "true" : "false"; }
    std::string operator()(std::int32_t i) const { return fmt::format("{}", i); }
    std::string operator()(float f) const { return fmt::format("{}", f); }
    std::string operator()(const std::string& s) const { return quote(s); }
    std::string operator()(const glm::vec2& v) const { return fmt::format("{} {}", v.x, v.y); }
    std::string operator()(const glm::vec3& v) const { return fmt::format("{} {} {}", v.x, v.y, v.z); }
    std::string operator()(const glm::vec4& v) const { return fmt::format("{} {} {} {}", v.x, v.y, v.z, v.w); }
};

struct Vectorising {
    glm::vec4 operator()(bool b) const { return {b ? 1.0f : 0.0f, 0, 0, 0}; }
    glm::vec4 operator()(std::int32_t i) const { return {static_cast<float>(i), 0, 0, 0}; }
    glm::vec4 operator()(float f) const { return {f, 0, 0, 0}; }
    glm::vec4 operator()(const std::string&) const { return {0, 0, 0, 0}; }
    glm::vec4 operator()(const glm::vec2& v) const { return {v, 0, 0}; }
    glm::vec4 operator()(const glm::vec3& v) const { return {v, 0}; }
    glm::vec4 operator()(const glm::vec4& v) const { return v; }
};

}  // namespace

std::string format_value(const Value& value) { return std::visit(Formatting{}, value); }

glm::vec4 as_vector(const Value& value) { return std::visit(Vectorising{}, value); }

}  // namespace croquis::framework
