// Reading shader functions: `file:function` and `#include`, with the place of every line kept for errors.
#include <algorithm>

#include "base/error.h"
#include "base/names.h"
#include "gpu/program.h"

namespace croquis::gpu {
namespace {

constexpr std::size_t deepest_include = 16;

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_word(char c) { return is_letter(c) || (c >= '0' && c <= '9'); }

// A text read from left to right.
class Cursor {
public:
    explicit Cursor(std::string_view text) : text_(text) {}

    void skip_spaces() {
        while (!text_.empty() && is_space(text_.front())) text_.remove_prefix(1);
    }
    bool take(std::string_view expected) {
        if (text_.substr(0, expected.size()) != expected) return false;
        text_.remove_prefix(expected.size());
        return true;
    }
    std::string_view take_word() {
        const auto end = std::find_if_not(text_.begin(), text_.end(), is_word);
        const std::string_view word = text_.substr(0, std::size_t(end - text_.begin()));
        text_.remove_prefix(word.size());
        return word;
    }
    [[nodiscard]] std::string_view rest() const { return text_; }

private:
    std::string_view text_;
};

// The name in `#include "name"`, without ".glsl"; nothing for any other line.
std::string included_name(std::string_view line) {
    Cursor cursor(line);
    cursor.skip_spaces();
    if (!cursor.take("#")) return {};
    cursor.skip_spaces();
    if (!cursor.take("include")) return {};
    cursor.skip_spaces();
    if (!cursor.take("\"")) return {};
    std::string_view name = cursor.rest().substr(0, cursor.rest().find('"'));
    constexpr std::string_view ending = ".glsl";
    if (name.size() > ending.size() && name.ends_with(ending)) name.remove_suffix(ending.size());
    return std::string(name);
}

class Reader {
public:
    Reader(ShaderSource& source, const FindShader& find) : source_(source), find_(find) {}

    /// Appends a file and, in place, the files it includes. A file is included once.
    void append(const std::string& name) {
        if (std::find(open_.begin(), open_.end(), name) != open_.end()) {
            fail("shader includes form a cycle: {} -> {}", fmt::join(open_, " -> "), name);
        }
        if (open_.size() >= deepest_include)
            fail("shader includes are more than {} deep at \"{}\"", deepest_include, name);
        if (std::find(read_.begin(), read_.end(), name) != read_.end()) return;
        const ShaderFile file = find_(name);
        read_.push_back(name);
        open_.push_back(name);
        source_.files.push_back(file.path);
        append_lines(file, source_.files.size() - 1);
        open_.pop_back();
    }

private:
    void append_lines(const ShaderFile& file, std::size_t number) {
        std::string_view rest = file.text;
        for (std::size_t line_number = 1; !rest.empty(); ++line_number) {
            const std::size_t end = std::min(rest.find('\n'), rest.size());
            std::string_view line = rest.substr(0, end);
            rest.remove_prefix(std::min(end + 1, rest.size()));
            if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
            const std::string name = included_name(line);
            if (name.empty()) {
                source_.text.append(line).push_back('\n');
                source_.lines.push_back({number, line_number});
                continue;
            }
            try {
                append(name);
            } catch (const Error& error) {
                fail_at({file.path, line_number, 1}, "{}", error.what());
            }
        }
    }

    ShaderSource& source_;
    const FindShader& find_;
    std::vector<std::string> open_;
    std::vector<std::string> read_;
};

// Names of functions without parameters that return a vec4: those that can be entry points.
std::vector<std::string> entry_functions(std::string_view text) {
    constexpr std::string_view type = "vec4";
    std::vector<std::string> names;
    for (std::size_t at = text.find(type); at != std::string_view::npos; at = text.find(type, at + type.size())) {
        if (at > 0 && is_word(text[at - 1])) continue;
        Cursor cursor(text.substr(at + type.size()));
        if (cursor.rest().empty() || !is_space(cursor.rest().front())) continue;
        cursor.skip_spaces();
        const std::string_view name = cursor.take_word();
        cursor.skip_spaces();
        if (name.empty() || !cursor.take("(")) continue;
        cursor.skip_spaces();
        cursor.take("void");
        cursor.skip_spaces();
        if (!cursor.take(")")) continue;
        cursor.skip_spaces();
        if (cursor.take("{")) names.emplace_back(name);
    }
    return names;
}

}  // namespace

ShaderSource ShaderSource::read(const std::string& name, const FindShader& find) {
    const std::size_t colon = name.find(':');
    if (colon == std::string::npos || colon == 0 || colon + 1 == name.size()) {
        fail("expected a shader function as file:function, found \"{}\"", name);
    }
    ShaderSource source;
    source.function = name.substr(colon + 1);
    Reader(source, find).append(name.substr(0, colon));
    const std::vector<std::string> functions = entry_functions(source.text);
    if (std::find(functions.begin(), functions.end(), source.function) == functions.end()) {
        fail("{}: no shader function \"{}\"{}", source.files.front(), source.function,
             suggestion(source.function, functions));
    }
    return source;
}

}  // namespace croquis::gpu
