#include "model/text_lines.h"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "model/readers.h"

namespace croquis::model {

TextLines::TextLines(const std::filesystem::path& path) : name_(path.string()), buffer_(std::size_t{1} << 18) {
    std::error_code error;
    if (!std::filesystem::exists(path, error)) fail("{}: no such file", name_);
    if (std::filesystem::is_directory(path, error)) fail("{}: expected a file, found a folder", name_);
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (!error && size > largest_file) fail("{}: larger than the {} bytes allowed here", name_, largest_file);
    if (!error) bytes_ = std::max<std::uintmax_t>(size, 1);
    file_.reset(std::fopen(path.c_str(), "rb"));
    if (!file_) fail("{}: cannot open: {}", name_, std::strerror(errno));
    check_start();
}

void TextLines::check_start() {
    if (!fill()) return;
    const std::string_view start(buffer_.data(), end_);
    const bool utf16_mark = start.starts_with("\xfe\xff") || start.starts_with("\xff\xfe");
    const bool utf16_letters = start.size() >= 4 && (start[0] == '\0') == (start[2] == '\0') &&
                               (start[1] == '\0') == (start[3] == '\0') && (start[0] == '\0') != (start[1] == '\0');
    if (utf16_mark || utf16_letters) fail("{}: expected UTF-8 text, found UTF-16", name_);
    if (start.starts_with("\xef\xbb\xbf")) begin_ = 3;
    old_macintosh_ = start.find('\n') == std::string_view::npos && start.find('\r') != std::string_view::npos;
    if (old_macintosh_) std::replace(buffer_.data(), buffer_.data() + end_, '\r', '\n');
}

bool TextLines::fill() {
    if (at_end_) return false;
    if (begin_ > 0) {
        std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
        end_ -= begin_;
        begin_ = 0;
    }
    if (buffer_.size() - end_ < buffer_.size() / 2) buffer_.resize(buffer_.size() * 2);  // a line longer than a buffer
    const std::size_t got = std::fread(buffer_.data() + end_, 1, buffer_.size() - end_, file_.get());
    if (got == 0 && std::ferror(file_.get()) != 0) fail("{}: cannot read: {}", name_, std::strerror(errno));
    if (old_macintosh_) std::replace(buffer_.data() + end_, buffer_.data() + end_ + got, '\r', '\n');
    end_ += got;
    bytes_read_ += got;
    at_end_ = got == 0;
    return !at_end_;
}

/// The end of the line that begins at begin_ and holds none before `from`; the buffer's end when the file ends first.
char* TextLines::end_of_line(char* from) {
    std::size_t searched = static_cast<std::size_t>(from - buffer_.data()) - begin_;
    while (true) {
        char* const start = buffer_.data() + begin_ + searched;
        char* const limit = buffer_.data() + end_;
        if (void* const found = std::memchr(start, '\n', static_cast<std::size_t>(limit - start))) {
            return static_cast<char*>(found);
        }
        searched = end_ - begin_;
        if (!fill()) return buffer_.data() + end_;
    }
}

bool TextLines::next(std::string_view& line) {
    if (begin_ == end_ && !fill()) return false;
    line_number_ = next_line_number_;
    char* end = end_of_line(buffer_.data() + begin_);
    while (true) {
        ++next_line_number_;
        char* const limit = buffer_.data() + end_;
        char* last = end;
        if (last > buffer_.data() + begin_ && last[-1] == '\r') --last;
        if (end == limit || last == buffer_.data() + begin_ || last[-1] != '\\') {
            const std::size_t start = begin_;
            begin_ = static_cast<std::size_t>(end - buffer_.data()) + (end == limit ? 0 : 1);
            line = std::string_view(buffer_.data() + start, static_cast<std::size_t>(last - buffer_.data()) - start);
            return true;
        }
        std::fill(last - 1, end + 1, ' ');  // the line goes on: blanks for backslash and line end
        end = end_of_line(end + 1);
    }
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (is_blank(text.front()) || text.front() == '\r')) text.remove_prefix(1);
    while (!text.empty() && (is_blank(text.back()) || text.back() == '\r')) text.remove_suffix(1);
    return text;
}

std::string_view take_word(std::string_view& text) {
    std::size_t begin = 0;
    while (begin < text.size() && is_blank(text[begin])) ++begin;
    std::size_t end = begin;
    while (end < text.size() && !is_blank(text[end])) ++end;
    const std::string_view word = text.substr(begin, end - begin);
    text.remove_prefix(end);
    return word;
}

bool take_number(std::string_view& text, double& number) {
    const char* from = text.data();
    const char* const end = from + text.size();
    while (from < end && is_blank(*from)) ++from;
    if (from < end && *from == '+') ++from;
    const auto [stop, error] = fast_float::from_chars(from, end, number);
    if (error != std::errc() && error != std::errc::result_out_of_range) return false;
    if (stop < end && !is_blank(*stop)) return false;
    text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
    return true;
}

}  // namespace croquis::model
