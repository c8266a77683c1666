// An open technique: its passes with their components, ready to draw.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "framework/component.h"
#include "framework/library.h"
#include "framework/pass.h"
#include "framework/render_context.h"
#include "gpu/timer.h"

namespace croquis::framework {

class Technique {
public:
    /// Makes all passes, with their programs and textures. `library` is that which `definition` was read with. Throws
    /// Error at the pass's place in its file when something that it names is missing or wrong.
    Technique(std::shared_ptr<const Library> library, const TechniqueDefinition& definition, Resources& resources,
              const ComponentTable& components);
    Technique(const Technique&) = delete;  // passes point into it
    Technique& operator=(const Technique&) = delete;

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] const std::string& help() const { return help_; }

    [[nodiscard]] std::vector<std::string> pass_names() const;
    /// Throws Error with the nearest name.
    [[nodiscard]] const Pass& pass(std::string_view name) const;
    /// How many lines found on the model the pass drew in the last frame. Throws Error as `pass`.
    [[nodiscard]] std::size_t line_count(std::string_view pass) const;

    /// The technique as a file would have it, with the values of now.
    [[nodiscard]] TechniqueDefinition definition() const;

    /// Changes a variable; the next frame shows it. Throws Error, changing nothing, when it cannot be.
    void set(std::string_view pass, std::string_view variable, const Value& value);

    /// Draws one frame into the context's frame. With a timer, each pass is one stretch.
    void draw(RenderContext& context, gpu::StretchTimer* timer = nullptr);

private:
    struct Step {
        std::unique_ptr<Pass> pass;
        std::unique_ptr<Component> component;
    };
    [[nodiscard]] const Step& step(std::string_view name) const;

    std::shared_ptr<const Library> library_;
    std::string name_;
    std::string help_;
    GeneratedTextures generated_;
    std::vector<Step> steps_;
};

}  // namespace croquis::framework
