// The values that component variables hold, their types, and their text form (seed C, 2.2.2).
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
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

/// Reads a value as a user writes it on the command line: numbers apart by spaces or commas, `true`, `false`, text
/// without quotes. Throws Error saying what the type expects and what was found.
[[nodiscard]] Value parse_value(VariableType type, std::string_view text);

/// The text that technique files use for the value: `0.5 0.5 1`, `true`, `"toon:two_tone:0"`. Numbers are as short as
/// they can be without changing when they are read again.
[[nodiscard]] std::string format_value(const Value& value);

/// The values of the two ends of a range as vectors, for component-wise limits: bool, int and number fill x.
[[nodiscard]] glm::vec4 as_vector(const Value& value);

}  // namespace croquis::framework
