// Reading a large text file line by line without holding all of it, and the words of a line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace croquis::model {

/// The lines of a text file, without their ends. Lines that end in a backslash go on in the next one. Ends may be
/// those of Unix, DOS or the old Macintosh; a byte order mark of UTF-8 is skipped.
class TextLines {
public:
    /// Throws Error when the file cannot be read, is too large or is UTF-16.
    explicit TextLines(const std::filesystem::path& path);

    /// The next line, valid until the next call; false at the end.
    [[nodiscard]] bool next(std::string_view& line);

    /// How much of the file was handed out.
    [[nodiscard]] double share() const { return double(bytes_read_ - (end_ - begin_)) / double(bytes_); }

    /// Where the line last read began.
    [[nodiscard]] TextPosition where() const { return {name_, line_number_, 0}; }

private:
    void check_start();
    [[nodiscard]] bool fill();
    [[nodiscard]] char* end_of_line(char* from);

    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    std::string name_;
    std::unique_ptr<std::FILE, Close> file_;
    std::vector<char> buffer_;
    std::size_t begin_ = 0, end_ = 0;            // what of the buffer is read and not yet handed out
    std::uintmax_t bytes_ = 1, bytes_read_ = 0;  // of the file
    std::size_t line_number_ = 0, next_line_number_ = 1;
    bool old_macintosh_ = false;
    bool at_end_ = false;
};

inline bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// Removes blanks at both ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// The first word of `text`, which loses it.
[[nodiscard]] std::string_view take_word(std::string_view& text);

/// Reads a number from the start of `text`, which loses it; false when there is none or it goes on with other letters.
[[nodiscard]] bool take_number(std::string_view& text, double& number);

}  // namespace croquis::model
