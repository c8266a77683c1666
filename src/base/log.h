// Warnings and notes for people. They go to standard error, never to standard output.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>

namespace croquis {

/// `text` on one line: control characters, from a hostile file for one, shown as \xNN. What is printed goes through it.
[[nodiscard]] std::string printable(std::string_view text);

/// Prints `croquis: warning: …` once for each distinct message, made printable: a warning in a frame does not flood the
/// terminal.
void warn(const std::string& message);

template <typename... Args>
void warn(fmt::format_string<Args...> format, Args&&... args) {
    warn(fmt::format(format, std::forward<Args>(args)...));
}

/// Prints a note, made printable, for those who asked for more (`--verbose`).
void note(const std::string& message);

/// Shows notes as well as warnings.
void set_verbose();

}  // namespace croquis
