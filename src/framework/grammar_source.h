// A descriptor or technique file's text: checked before it is parsed, and its places as an editor counts them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "framework/grammar.h"

namespace croquis::framework {

class SourceText {
public:
    /// Checks that the text is UTF-8 without control characters and no longer than 1 MiB. Throws Error at the first
    /// byte that is not. Both arguments must outlive this.
    SourceText(const std::string& file, std::string_view text);

    [[nodiscard]] const std::string& file() const { return file_; }
    [[nodiscard]] std::string_view text() const { return text_; }
    /// Where the text begins, behind a byte-order mark.
    [[nodiscard]] std::size_t begin() const { return begin_; }

    /// The place of a byte. Asking in rising order costs one walk through the text in all.
    [[nodiscard]] Place place(std::size_t offset);

    /// What stands at a byte, for a message: `"word"`, `'}'`, "a quoted text" or "the end of the file".
    [[nodiscard]] std::string found(std::size_t offset) const;
    /// The bare word that begins at a byte; empty where something else does.
    [[nodiscard]] std::string_view word(std::size_t offset) const;

private:
    void check_characters();

    const std::string& file_;
    std::string_view text_;
    std::size_t begin_ = 0;
    std::size_t walked_ = 0;  // `walked_to_` is the place of this byte
    Place walked_to_{1, 1};
};

/// What no bare word contains: white space, comments, quotes and brackets.
constexpr std::string_view word_ends = " \t\r\n#{};\"";

}  // namespace croquis::framework
