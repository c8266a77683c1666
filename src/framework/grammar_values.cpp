// Settings of a parsed file as typed values, and what to say where they are none (seed C, 2.2.2).
#include <fmt/format.h>

#include <string_view>
#include <unordered_set>

#include "framework/grammar.h"

namespace croquis::framework {
namespace {

// A value that goes on in the next line most likely lacks its ';': `threshold 0.5` above `color 1 0 0 ;`.
std::string missing_semicolon_hint(const Setting& setting) {
    const std::uint32_t first_line = setting.value.front().where.line;
    if (setting.value.back().where.line == first_line) return {};
    return fmt::format("; is a ';' missing at the end of line {}?", first_line);
}

}  // namespace

Value typed_value(const Setting& setting, VariableType type, const std::string& file, const std::string& owner) {
    std::vector<std::string> words;
    for (const Word& word : setting.value) words.push_back(word.text);
    const bool wants_text = number_count(type) == 0;
    if (wants_text != setting.is_text) {
        fail_at(position(file, setting.value.front().where), "{} expects {}, found {}{}{}", owner, expectation(type),
                setting.is_text ? "the quoted text " : "", shown(words), missing_semicolon_hint(setting));
    }
    ReadValue read = read_value(type, words);
    if (read.value) return *std::move(read.value);
    fail_at(position(file, setting.value[read.word].where), "{} expects {}, found {}{}", owner, read.expected,
            read.found, missing_semicolon_hint(setting));
}

void refuse_repeated(const std::vector<Setting>& settings, const std::string& file, const std::string& owner) {
    std::unordered_set<std::string_view> seen;
    for (const Setting& setting : settings) {
        if (!seen.insert(setting.name.text).second) {
            fail_at(position(file, setting.name.where), "{} sets \"{}\" twice", owner, setting.name.text);
        }
    }
}

}  // namespace croquis::framework
