// Shader programs: GLSL 3.30 and ES 3.00 from one source, `#include`, errors at the user's file and line.
#pragma once

#include <functional>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/context.h"

namespace croquis::gpu {

/// A shader file as a user names it.
struct ShaderFile {
    std::string path;  ///< for messages
    std::string text;
};

/// Finds a shader file by its name without ending ("edges", "include/light"). Throws Error when there is none.
using FindShader = std::function<ShaderFile(const std::string& name)>;

enum class Stage { vertex, fragment };

/// How many colours the fragment function gives: the one it returns, or a second too, which it assigns to
/// `second_output`.
enum class Output { one, two };

/// One function of one file, with all that the file includes, ready to compile for either API.
///
/// A vertex function has the form `vec4 name()` and returns the clip-space position; a fragment function returns the
/// pixel's colour as `vec4 name()`. A file is compiled for both stages: what belongs to
/// one stands between `#ifdef VERTEX_STAGE` (or `FRAGMENT_STAGE`) and `#endif`, and a variable that goes from one to
/// the other is declared `between vec3 normal_world;`.
struct ShaderSource {
    /// Where a line of the text was read.
    struct Line {
        std::size_t file = 0;  ///< index into files
        std::size_t number = 0;
    };

    std::string text;                ///< without the header that names version and stage
    std::vector<Line> lines;         ///< one a line of the text
    std::vector<std::string> files;  ///< the one named first, then those it includes
    std::string function;

    /// Reads `file:function`. Throws Error for a form, file or function that is wrong, with the nearest function, and
    /// for includes that form a cycle.
    [[nodiscard]] static ShaderSource read(const std::string& name, const FindShader& find);
};

/// A linked program. Uniforms are set by name; those that the program does not use are passed over.
class Program {
public:
    /// Throws Error with the user's file and line when a shader does not compile or the two do not fit together.
    Program(Context& context, const ShaderSource& vertex, const ShaderSource& fragment, Output output);
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    void use() const;
    [[nodiscard]] bool uses(std::string_view uniform) const { return location(uniform) >= 0; }

    // Valid after use().
    void set(std::string_view uniform, int value) const;
    void set(std::string_view uniform, unsigned value) const;
    void set(std::string_view uniform, bool value) const { set(uniform, value ? 1 : 0); }
    void set(std::string_view uniform, float value) const;
    void set(std::string_view uniform, const glm::vec2& value) const;
    void set(std::string_view uniform, const glm::vec3& value) const;
    void set(std::string_view uniform, const glm::vec4& value) const;
    void set(std::string_view uniform, const glm::mat3& value) const;
    void set(std::string_view uniform, const glm::mat4& value) const;

private:
    [[nodiscard]] int location(std::string_view uniform) const;
    void find_uniforms();

    Context* context_;
    unsigned id_ = 0;
    std::map<std::string, int, std::less<>> locations_;
};

}  // namespace croquis::gpu
