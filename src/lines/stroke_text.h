// Settings as stroke styles and offset files write them: one a line, `name value value … # comment`.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "base/error.h"
#include "lines/stroke_style.h"

namespace croquis::lines {

/// Reads a text setting by setting, word by word. Every complaint is an Error at line and column.
class SettingReader {
public:
    /// Throws Error for a text of more than `most_bytes`.
    SettingReader(std::string_view text, std::string file_name);

    static constexpr std::size_t most_bytes = 1 << 20;

    /// Goes on to the next line that is not empty, and reads its name; false at the end of the text.
    [[nodiscard]] bool next();
    /// The name of the setting.
    [[nodiscard]] std::string_view name() const { return name_; }

    [[nodiscard]] bool has_more() const { return !rest_.empty(); }
    /// The next word. `expected` says in an error what it should have been.
    [[nodiscard]] std::string_view word(std::string_view expected);
    /// One of a few words.
    [[nodiscard]] std::size_t choice(std::span<const std::string> words);
    [[nodiscard]] double number(double low, double high);
    /// A number with px, mm, w or %; `low` and `high` are bounds of the number as it is written.
    [[nodiscard]] Length length(double low, double high);
    /// The name of another file: letters, digits, `_` and `-`.
    [[nodiscard]] std::string file_word(std::string_view expected);
    /// All words to the end of the line.
    [[nodiscard]] std::string text();
    /// Throws unless the line is read to its end.
    void expect_end();

    /// Where the last word, or the name, began.
    [[nodiscard]] TextPosition where() const { return {file_, line_number_, column_}; }
    [[nodiscard]] std::size_t line_number() const { return line_number_; }

private:
    std::string_view take();
    [[nodiscard]] std::string found() const;

    std::string file_;
    std::string_view text_;  // what follows the line
    std::string_view line_, rest_, name_, word_;
    std::size_t line_number_ = 0, column_ = 0;
};

/// A word in quotes for a message, cut when long; bytes that are no letters become '?'.
[[nodiscard]] std::string in_quotes(std::string_view word);

}  // namespace croquis::lines
