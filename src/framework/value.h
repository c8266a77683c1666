// The values that component variables hold, their types, and their text form (seed C, 2.2.2).
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace croquis::framework {

enum class VariableType { boolean, integer, number, string, vector2, vector3, vector4, rgb, rgba, texture };

/// A variable's value. Which alternative it holds follows from the variable's type: rgb is a vec3, rgba a vec4, and
/// texture a string in the form `directory:image:filter`.
using Value = std::variant<bool, std::int32_t, float, std::string, glm::vec2, glm::vec3, glm::vec4>;

/// The type's name in files: "bool", "int", "number", "string", "vector2", …
[[nodiscard]] std::string_view name_of(VariableType type);
[[nodiscard]] std::optional<VariableType> type_named(std::string_view name);

/// How many numbers a value of the type has; 0 for string and texture.
[[nodiscard]] int number_count(VariableType type);

/// What a value of the type must be, for messages: "a number", "3 numbers (red green blue)", …
[[nodiscard]] std::string_view expectation(VariableType type);

/// What was found, for messages: in quotes, cut where it is too long to be read, or "nothing".
[[nodiscard]] std::string shown(std::span<const std::string> words);

/// What became of words read as a value: the value, or what was expected, what was found instead and at which word.
struct ReadValue {
    std::optional<Value> value;
    std::string expected, found;
    std::size_t word = 0;
};

/// Reads words as a value. A string or texture is the one word as it stands; a number may have the typographic minus
/// sign. Not-a-number, infinities, and numbers that the type cannot hold are refused.
[[nodiscard]] ReadValue read_value(VariableType type, std::span<const std::string> words);

/// Reads a value as a user writes it on the command line: numbers apart by spaces or commas, `true`, `false`, text
/// without quotes. Throws Error saying what the type expects and what was found.
[[nodiscard]] Value parse_value(VariableType type, std::string_view text);

/// The text that technique files use for the value: `0.5 0.5 1`, `true`, `"toon:two_tone:0"`. Numbers are as short as
/// they can be without changing when they are read again.
[[nodiscard]] std::string format_value(const Value& value);

/// Text in double quotes as files have it, with `\"` and `\\` for what needs it.
[[nodiscard]] std::string quote(std::string_view text);

/// The values of the two ends of a range as vectors, for component-wise limits: bool, int and number fill x.
[[nodiscard]] glm::vec4 as_vector(const Value& value);

}  // namespace croquis::framework
