// Errors a user can make, and how they are told: what was expected, what was found, and where.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

namespace croquis {

/// A place in a text file, as an editor counts: lines and columns from 1; 0 where unknown.
struct TextPosition {
    std::string file;
    std::size_t line = 0;
    std::size_t column = 0;

    /// "file:line:column", shortened where parts are unknown.
    [[nodiscard]] std::string to_string() const;
};

/// A mistake in what the user gave: a file, a name, a value. One line, complete in itself, without a final stop.
///
/// A programmer's mistake is an assert instead.
class Error : public std::runtime_error {
public:
    explicit Error(const std::string& message) : std::runtime_error(message) {}

    /// The message led by its place: `my.technique:7:3: …`.
    Error(const TextPosition& where, const std::string& message)
        : std::runtime_error(where.to_string() + ": " + message) {}
};

/// Throws an Error from a format string.
template <typename... Args>
[[noreturn]] void fail(fmt::format_string<Args...> format, Args&&... args) {
    throw Error(fmt::format(format, std::forward<Args>(args)...));
}

/// Throws an Error at a place in a text file.
template <typename... Args>
[[noreturn]] void fail_at(const TextPosition& where, fmt::format_string<Args...> format, Args&&... args) {
    throw Error(where, fmt::format(format, std::forward<Args>(args)...));
}

}  // namespace croquis
