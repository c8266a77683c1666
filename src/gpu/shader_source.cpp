// Reading shader functions: `file:function`, `#include`, and the `#line` directives that keep errors at their place.
#include <algorithm>
#include <regex>
#include <sstream>

#include "base/error.h"
#include "base/names.h"
#include "gpu/program.h"

namespace croquis::gpu {
namespace {

constexpr std::size_t deepest_include = 16;

class Reader {
public:
    Reader(ShaderSource& source, const FindShader& find) : source_(source), find_(find) {}

    /// Appends a file and, in place, the files it includes. A file is included once.
    void append(const std::string& name) {
        if (std::find(open_.begin(), open_.end(), name) != open_.end()) {
            fail("shader includes form a cycle: {} -> {}", fmt::join(open_, " -> "), name);
        }
        if (open_.size() >= deepest_include) fail("shader includes are more than {} deep at \"{}\"", deepest_include, name);
        if (std::find(read_.begin(), read_.end(), name) != read_.end()) return;
        const ShaderFile file = find_(name);
        read_.push_back(name);
        open_.push_back(name);
        const std::size_t number = source_.files.size();
        source_.files.push_back(file.path);
        append_lines(file, number);
        open_.pop_back();
    }

private:
    void append_lines(const ShaderFile& file, std::size_t number) {
        static const std::regex include(R"re(^\s*#\s*include\s+"([^"]*?)(?:\.glsl)?"\s*$)re");
        std::istringstream lines(file.text);
        std::string line;
        std::size_t line_number = 0;
        source_.text += fmt::format("#line 1 {}\n", number);
        while (std::getline(lines, line)) {
            ++line_number;
            if (!line.empty() && line.back() == '\r') line.pop_back();
            std::smatch match;
            if (!std::regex_match(line, match, include)) {
                source_.text += line + '\n';
                continue;
            }
            try {
                append(match[1].str());
            } catch (const Error& error) {
                fail_at({file.path, line_number, 1}, "{}", error.what());
            }
            source_.text += fmt::format("#line {} {}\n", line_number + 1, number);
        }
    }

    ShaderSource& source_;
    const FindShader& find_;
    std::vector<std::string> open_;
    std::vector<std::string> read_;
};

// Names of functions without parameters that return a vec4: those that can be entry points.
std::vector<std::string> entry_functions(const std::string& text) {
    static const std::regex definition(R"re(\bvec4\s+([A-Za-z_]\w*)\s*\(\s*(?:void)?\s*\)\s*\{)re");
    std::vector<std::string> names;
    for (std::sregex_iterator i(text.begin(), text.end(), definition), end; i != end; ++i) names.push_back((*i)[1].str());
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
