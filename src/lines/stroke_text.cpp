#include "lines/stroke_text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>
#include <vector>

#include "base/names.h"
#include "model/text_lines.h"

namespace croquis::lines {
namespace {

struct UnitName {
    std::string_view name;
    Length::Unit unit;
    double factor;
};
constexpr UnitName unit_names[] = {{"px", Length::Unit::pixels, 1},
                                   {"mm", Length::Unit::millimetres, 1},
                                   {"w", Length::Unit::widths, 1},
                                   {"%", Length::Unit::share, 0.01}};

std::string_view without_comment(std::string_view line) {
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '#' && (i == 0 || model::is_blank(line[i - 1]))) return line.substr(0, i);
    }
    return line;
}

bool is_number(std::string_view word, double& number) {
    return !word.empty() && model::take_number(word, number) && std::isfinite(number);
}

}  // namespace

std::string in_quotes(std::string_view word) {
    constexpr std::size_t longest = 40;
    std::string text = "\"";
    for (const char letter : word.substr(0, longest)) {
        text += static_cast<unsigned char>(letter) < ' ' || letter == '\x7f' ? '?' : letter;
    }
    return text + (word.size() > longest ? "...\"" : "\"");
}

SettingReader::SettingReader(std::string_view text, std::string file_name) : file_(std::move(file_name)), text_(text) {
    if (text.size() > most_bytes) fail("{}: expected at most {} bytes, found {}", file_, most_bytes, text.size());
    if (text_.starts_with("\xef\xbb\xbf")) text_.remove_prefix(3);
}

bool SettingReader::next() {
    while (!text_.empty()) {
        const std::size_t end = text_.find('\n');
        line_ = text_.substr(0, end);
        text_.remove_prefix(end == std::string_view::npos ? text_.size() : end + 1);
        ++line_number_;
        column_ = 1;
        rest_ = model::trimmed(without_comment(line_));
        if (rest_.empty()) continue;
        name_ = take();
        return true;
    }
    return false;
}

// The next word of the line; empty at its end, with the column after the last letter.
std::string_view SettingReader::take() {
    const char* const end = rest_.empty() ? word_.data() + word_.size() : nullptr;
    word_ = end ? std::string_view(end, 0) : model::take_word(rest_);
    rest_ = model::trimmed(rest_);
    column_ = static_cast<std::size_t>(word_.data() - line_.data()) + 1;
    return word_;
}

std::string SettingReader::found() const { return word_.empty() ? "the end of the line" : in_quotes(word_); }

std::string_view SettingReader::word(std::string_view expected) {
    if (take().empty()) fail_at(where(), "expected {}, found the end of the line", expected);
    return word_;
}

std::size_t SettingReader::choice(std::span<const std::string> words) {
    take();
    const auto at = std::find(words.begin(), words.end(), word_);
    if (at != words.end()) return static_cast<std::size_t>(at - words.begin());
    std::string list;
    for (std::size_t i = 0; i < words.size(); ++i) {
        list += (i == 0 ? "" : i + 1 < words.size() ? ", " : " or ") + in_quotes(words[i]);
    }
    fail_at(where(), "expected {}, found {}{}", list, found(), word_.empty() ? "" : suggestion(word_, words));
}

double SettingReader::number(double low, double high) {
    take();
    double value = 0;
    if (!is_number(word_, value) || value < low || value > high) {
        fail_at(where(), "expected a number from {} to {}, found {}", low, high, found());
    }
    return value;
}

Length SettingReader::length(double low, double high) {
    take();
    for (const UnitName& unit : unit_names) {
        if (!word_.ends_with(unit.name)) continue;
        double value = 0;
        if (!is_number(word_.substr(0, word_.size() - unit.name.size()), value)) break;
        if (value < low || value > high) {
            fail_at(where(), "expected a length from {} to {}, found {}", low, high, found());
        }
        return {value * unit.factor, unit.unit};
    }
    fail_at(where(), "expected a length such as 3px, 0.5mm, 2w or 10%, found {}", found());
}

std::string SettingReader::file_word(std::string_view expected) {
    const std::string name(word(expected));
    const bool is_plain = std::all_of(name.begin(), name.end(), [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-';
    });
    if (!is_plain || name.size() > 100) {
        fail_at(where(), "expected {} of letters, digits, '_' and '-', found {}", expected, found());
    }
    return name;
}

std::string SettingReader::text() {
    const std::string text(rest_);
    rest_ = {};
    return text;
}

void SettingReader::expect_end() {
    if (!take().empty()) fail_at(where(), "expected the end of the line, found {}", found());
}

}  // namespace croquis::lines
