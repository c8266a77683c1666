// Checks and places of a text (seed C, 2.2.1). Positions count code points, so that carets stand right under them.
#include "framework/grammar_source.h"

#include <fmt/format.h>

namespace croquis::framework {
namespace {

constexpr std::size_t most_bytes = std::size_t{1} << 20;
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

// The bytes of the UTF-8 sequence that `text` begins with; 0 if it is none: too short, overlong, a surrogate or past
// U+10FFFF (Unicode standard, table 3-7).
std::size_t sequence_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
    const auto rest_continues = [&](std::size_t length) {
        for (std::size_t i = 1; i < length; ++i) {
            if ((byte(i) & 0xC0U) != 0x80U) return false;
        }
        return true;
    };
    const unsigned first = byte(0), second = byte(1);
    if (first < 0x80) return 1;
    if (first >= 0xC2 && first <= 0xDF) return rest_continues(2) ? 2 : 0;
    if (first >= 0xE0 && first <= 0xEF) {
        const bool fits = (first != 0xE0 || second >= 0xA0) && (first != 0xED || second < 0xA0);
        return fits && rest_continues(3) ? 3 : 0;
    }
    if (first >= 0xF0 && first <= 0xF4) {
        const bool fits = (first != 0xF0 || second >= 0x90) && (first != 0xF4 || second < 0x90);
        return fits && rest_continues(4) ? 4 : 0;
    }
    return 0;
}

bool is_control(char c) { return (c >= 0 && c < ' ' && c != '\t' && c != '\r' && c != '\n') || c == '\x7F'; }

}  // namespace

SourceText::SourceText(const std::string& file, std::string_view text) : file_(file), text_(text) {
    if (text.size() > most_bytes) fail("{}: larger than the 1 MiB allowed here", file);
    if (text.substr(0, byte_order_mark.size()) == byte_order_mark) begin_ = byte_order_mark.size();
    walked_ = begin_;
    check_characters();
}

void SourceText::check_characters() {
    for (std::size_t i = begin_; i < text_.size();) {
        const std::size_t length = sequence_length(text_.substr(i));
        if (length == 0)
            fail_at(position(file_, place(i)), "expected UTF-8 text, found the byte 0x{:02X}",
                    static_cast<unsigned char>(text_[i]));
        if (is_control(text_[i]))
            fail_at(position(file_, place(i)), "found the control character U+{:04X}",
                    static_cast<unsigned char>(text_[i]));
        i += length;
    }
}

Place SourceText::place(std::size_t offset) {
    if (offset < walked_) {
        walked_ = begin_;
        walked_to_ = {1, 1};
    }
    for (; walked_ < offset; ++walked_) {
        if (text_[walked_] == '\n') {
            walked_to_ = {walked_to_.line + 1, 1};
        } else if (walked_ + 1 >= text_.size() || !continues(text_[walked_ + 1])) {
            ++walked_to_.column;
        }
    }
    return walked_to_;
}

std::string_view SourceText::word(std::size_t offset) const {
    const std::string_view rest = text_.substr(offset);
    return rest.substr(0, rest.find_first_of(word_ends));
}

std::string SourceText::found(std::size_t offset) const {
    constexpr std::size_t longest_shown = 60;
    if (offset >= text_.size()) return "the end of the file";
    if (text_[offset] == '"') return "a quoted text";
    const std::string_view bare = word(offset);
    if (bare.empty() || bare == ":") return fmt::format("'{}'", text_[offset]);
    if (bare.size() <= longest_shown) return fmt::format("\"{}\"", bare);
    std::size_t end = longest_shown;
    while (end > 0 && continues(bare[end])) --end;
    return fmt::format("\"{}…\"", bare.substr(0, end));
}

}  // namespace croquis::framework
