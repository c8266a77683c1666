// The vertex and fragment function of a pass, as one program that follows its variables.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "framework/pass.h"
#include "gpu/program.h"

namespace croquis::components {

/// Linked when the component is made, and again when one of the two names changes.
class ShaderPair {
public:
    /// For passes that draw the scene: both names are variables.
    explicit ShaderPair(const framework::Pass& pass, gpu::Output output = gpu::Output::one)
        : pass_(pass), output_(output) {
        link();
    }

    /// For full-screen passes: only `fragment_program` is a variable.
    [[nodiscard]] static ShaderPair full_screen(const framework::Pass& pass) {
        return ShaderPair(pass, full_screen_vertex);
    }

    [[nodiscard]] const gpu::Program& program() const { return *program_; }

    /// To be called from Component::variable_changed.
    void variable_changed(std::string_view name) {
        if (name == "vertex_program" || name == "fragment_program") link();
    }

private:
    static constexpr const char* full_screen_vertex = "image:full_screen";

    ShaderPair(const framework::Pass& pass, const char* vertex)
        : pass_(pass), output_(gpu::Output::one), fixed_vertex_(vertex) {
        link();
    }

    void link() {
        const std::string vertex =
            fixed_vertex_ ? fixed_vertex_ : pass_.variable<std::string>("vertex_program").value();
        program_ = pass_.resources().program(vertex, pass_.variable<std::string>("fragment_program").value(), output_);
    }

    const framework::Pass& pass_;
    gpu::Output output_;
    const char* fixed_vertex_ = nullptr;
    std::shared_ptr<const gpu::Program> program_;
};

}  // namespace croquis::components
