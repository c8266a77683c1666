#include "gpu/program.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>
#include <memory>
#include <regex>
#include <sstream>

#include "base/error.h"

namespace croquis::gpu {
namespace {

std::string header_for(Api api, Stage stage, Output output) {
    std::string header = api == Api::gl ? "#version 330 core\n" : "#version 300 es\n";
    if (api == Api::gles) {
        header +=
            "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\nprecision highp usampler2D;\n"
            "precision highp sampler3D;\nprecision highp sampler2DArray;\n";
    }
    if (stage == Stage::vertex) return header + "#define VERTEX_STAGE\n#define between out\n";
    header += "#define FRAGMENT_STAGE\n#define between in\n";
    header += "layout(location = 0) out vec4 first_output;\n";
    // Where only one is asked for, the second is assigned and forgotten.
    return header +
           (output == Output::two ? "layout(location = 1) out vec4 second_output;\n" : "vec4 second_output;\n");
}

std::string main_for(const ShaderSource& source, Stage stage) {
    const char* result = stage == Stage::vertex ? "gl_Position" : "first_output";
    return fmt::format("\nvoid main() {{ {} = {}(); }}\n", result, source.function);
}

// The first error of a compiler's log, led by the user's file and line. Mesa writes "0:12(5): error: …", NVIDIA
// "0(12) : error …" and ANGLE "ERROR: 0:12: …"; lines count from the header's first.
std::string place_in_files(const std::string& log, const ShaderSource& source, std::size_t header_lines) {
    static const std::regex forms[] = {
        std::regex(R"re(^\s*\d+:(\d+)\((\d+)\):\s*(?:error:\s*)?(.*)$)re"),
        std::regex(R"re(^\s*\d+\((\d+)\)()\s*:\s*(?:error\s*\w*:\s*)?(.*)$)re"),
        std::regex(R"re(^\s*ERROR:\s*\d+:(\d+)():\s*(.*)$)re"),
    };
    constexpr std::size_t longest_line = 1000;  // std::regex recurses with each letter
    std::istringstream lines(log);
    std::string line;
    while (std::getline(lines, line)) {
        if (line.find("warning") != std::string::npos) continue;
        line.resize(std::min(line.size(), longest_line));
        for (const std::regex& form : forms) {
            std::smatch match;
            if (!std::regex_match(line, match, form)) continue;
            const std::size_t number = std::stoul(match[1].str());
            if (number <= header_lines || number - header_lines > source.lines.size()) continue;
            const ShaderSource::Line& where = source.lines[number - header_lines - 1];
            const std::size_t column = match[2].length() > 0 ? std::stoul(match[2].str()) : 0;
            return TextPosition{source.files[where.file], where.number, column}.to_string() + ": " + match[3].str();
        }
    }
    return source.files.front() + ": " + log.substr(0, log.find('\n'));
}

struct Shader {
    Shader(Context& context, const ShaderSource& source, Stage stage, Output output)
        : id(glCreateShader(stage == Stage::vertex ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER)) {
        const std::string header = header_for(context.api(), stage, output);
        const std::string main = main_for(source, stage);
        const char* texts[] = {header.c_str(), source.text.c_str(), main.c_str()};
        glShaderSource(id, 3, texts, nullptr);
        glCompileShader(id);
        GLint compiled = GL_FALSE;
        glGetShaderiv(id, GL_COMPILE_STATUS, &compiled);
        if (compiled == GL_TRUE) return;
        std::string log(4096, '\0');
        GLsizei length = 0;
        glGetShaderInfoLog(id, GLsizei(log.size()), &length, log.data());
        log.resize(std::size_t(length));
        glDeleteShader(id);
        const auto header_lines = std::count(header.begin(), header.end(), '\n');
        throw Error(place_in_files(log, source, std::size_t(header_lines)));
    }
    ~Shader() { glDeleteShader(id); }
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;

    GLuint id;
};

}  // namespace

Program::Program(Context& context, const ShaderSource& vertex, const ShaderSource& fragment, Output output)
    : context_(&context) {
    const Shader vertex_shader(context, vertex, Stage::vertex, output);
    const Shader fragment_shader(context, fragment, Stage::fragment, output);
    id_ = glCreateProgram();
    glAttachShader(id_, vertex_shader.id);
    glAttachShader(id_, fragment_shader.id);
    glLinkProgram(id_);
    GLint linked = GL_FALSE;
    glGetProgramiv(id_, GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE) {
        std::string log(4096, '\0');
        GLsizei length = 0;
        glGetProgramInfoLog(id_, GLsizei(log.size()), &length, log.data());
        glDeleteProgram(id_);
        log.resize(std::size_t(length));
        fail("{}:{} and {}:{} do not fit together: {}", vertex.files.front(), vertex.function, fragment.files.front(),
             fragment.function, log.substr(0, log.find('\n')));
    }
    ++context_->counters().live_programs;
    ++context_->counters().programs_linked;
    find_uniforms();
}

Program::~Program() {
    glDeleteProgram(id_);
    --context_->counters().live_programs;
}

void Program::find_uniforms() {
    GLint count = 0;
    glGetProgramiv(id_, GL_ACTIVE_UNIFORMS, &count);
    for (GLint i = 0; i < count; ++i) {
        char name[256];
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(id_, GLuint(i), sizeof name, nullptr, &size, &type, name);
        locations_[name] = glGetUniformLocation(id_, name);
    }
}

int Program::location(std::string_view uniform) const {
    const auto found = locations_.find(uniform);
    return found == locations_.end() ? -1 : found->second;
}

void Program::use() const { glUseProgram(id_); }

void Program::set(std::string_view uniform, int value) const { glUniform1i(location(uniform), value); }
void Program::set(std::string_view uniform, unsigned value) const { glUniform1ui(location(uniform), value); }
void Program::set(std::string_view uniform, float value) const { glUniform1f(location(uniform), value); }
void Program::set(std::string_view uniform, const glm::vec2& value) const {
    glUniform2fv(location(uniform), 1, glm::value_ptr(value));
}
void Program::set(std::string_view uniform, const glm::vec3& value) const {
    glUniform3fv(location(uniform), 1, glm::value_ptr(value));
}
void Program::set(std::string_view uniform, const glm::vec4& value) const {
    glUniform4fv(location(uniform), 1, glm::value_ptr(value));
}
void Program::set(std::string_view uniform, const glm::mat3& value) const {
    glUniformMatrix3fv(location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}
void Program::set(std::string_view uniform, const glm::mat4& value) const {
    glUniformMatrix4fv(location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}

}  // namespace croquis::gpu
