// How errors are thrown: croquis::Error with a format, and with a place in a text file. A programmer's mistake is an
// assert instead.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <utility>

#include "croquis/error.h"

namespace croquis {

/// A place in a text file, as an editor counts: lines and columns from 1; 0 where unknown.
struct TextPosition {
    std::string file;
    std::size_t line = 0;
    std::size_t column = 0;

    /// "file:line:column", shortened where parts are unknown.
    [[nodiscard]] std::string to_string() const;
};

/// Throws an Error from a format string.
template <typename... Args>
[[noreturn]] void fail(fmt::format_string<Args...> format, Args&&... args) {
    throw Error(fmt::format(format, std::forward<Args>(args)...));
}

/// Throws an Error at a place in a text file.
template <typename... Args>
[[noreturn]] void fail_at(const TextPosition& where, fmt::format_string<Args...> format, Args&&... args) {
    throw Error(where.to_string() + ": " + fmt::format(format, std::forward<Args>(args)...));
}

}  // namespace croquis
