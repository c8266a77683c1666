#include "output/vector_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace croquis::output {
namespace {

bool is_name_character(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
           c == '.';
}

}  // namespace

bool VectorGroup::empty() const {
    return paths.empty() && texts.empty() &&
           std::all_of(groups.begin(), groups.end(), [](const VectorGroup& group) { return group.empty(); });
}

std::string NameGiver::name(const std::string& start, const std::string& rest) {
    constexpr std::size_t longest = 80;
    std::string wanted = rest.empty() ? start : start + "-" + rest.substr(0, longest);
    std::replace_if(
        wanted.begin(), wanted.end(), [](char c) { return !is_name_character(c); }, '_');
    std::string name = wanted;
    for (int count = 2;; ++count) {
        const auto place = std::lower_bound(given_.begin(), given_.end(), name);
        if (place == given_.end() || *place != name) {
            given_.insert(place, name);
            return name;
        }
        name = fmt::format("{}-{}", wanted, count);
    }
}

std::int64_t thousandths(double number) { return std::llround(number * 1000.0); }

void append_thousandths(std::string& text, std::uint64_t number) {
    const std::uint64_t part = number % 1000;
    if (part == 0 || number >= 1000) {
        const fmt::format_int whole(number / 1000);
        text.append(whole.data(), whole.size());
    }
    if (part == 0) return;
    const char digits[4] = {'.', char('0' + part / 100), char('0' + part / 10 % 10), char('0' + part % 10)};
    std::size_t count = 4;
    while (digits[count - 1] == '0') --count;
    text.append(digits, count);
}

void append_number(std::string& text, double number) {
    const std::int64_t rounded = thousandths(number);
    const auto size = static_cast<std::uint64_t>(rounded < 0 ? -rounded : rounded);
    if (rounded < 0) text += '-';
    if (size > 0 && size < 1000) text += '0';
    append_thousandths(text, size);
}

std::string number_text(double number) {
    std::string text;
    append_number(text, number);
    return text;
}

}  // namespace croquis::output
