// A pass of an opened technique: the values of its component's variables, which may change while it runs.
#pragma once

#include <cassert>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "framework/descriptor.h"
#include "framework/generated_textures.h"
#include "framework/resources.h"
#include "framework/technique_definition.h"
#include "framework/value.h"

namespace croquis::framework {

/// A component's hold on one of its variables: always the value of now.
template <typename T>
class Variable {
public:
    explicit Variable(const Value& value) : value_(&value) { assert(std::holds_alternative<T>(value)); }
    [[nodiscard]] const T& value() const { return std::get<T>(*value_); }

private:
    const Value* value_;
};

class Pass {
public:
    Pass(const PassDefinition& definition, Resources& resources, GeneratedTextures& generated)
        : definition_(definition), resources_(&resources), generated_(&generated) {}
    Pass(const Pass&) = delete;
    Pass& operator=(const Pass&) = delete;

    [[nodiscard]] const std::string& name() const { return definition_.name; }
    [[nodiscard]] const ComponentDescriptor& component() const { return *definition_.component; }
    /// What it was made of, with the values of now.
    [[nodiscard]] const PassDefinition& definition() const { return definition_; }
    [[nodiscard]] const TextPosition& where() const { return definition_.where; }
    [[nodiscard]] Resources& resources() const { return *resources_; }
    [[nodiscard]] GeneratedTextures& generated() const { return *generated_; }

    /// Binds a variable. Throws Error when the descriptor does not declare it, or declares it with another type: the
    /// component cannot do its work without it.
    template <typename T>
    [[nodiscard]] Variable<T> variable(std::string_view name) const {
        const Value& found = value(name);
        if (!std::holds_alternative<T>(found)) refuse_type(name);
        return Variable<T>(found);
    }

    /// True when the descriptor declares the variable: for what a component can do without.
    [[nodiscard]] bool has(std::string_view name) const { return definition_.values.count(name) > 0; }

    /// A variable as the component declares it. Throws Error with the nearest name.
    [[nodiscard]] const VariableDescriptor& descriptor(std::string_view name) const;

    /// The value of a variable. Throws Error when the descriptor does not declare it.
    [[nodiscard]] const Value& value(std::string_view name) const;

    /// Changes a value. The texture that it names is found now, not in the next frame. Throws Error, changing nothing,
    /// for an unknown variable, one that cannot change while the technique runs, or a texture that does not exist.
    void set(std::string_view name, const Value& value);

    /// Finds the images and generated textures that all texture variables name. Called when all passes exist.
    void find_textures();

    /// The texture that a texture variable names; null when it names none.
    [[nodiscard]] const gpu::Texture* texture(std::string_view name) const;

    /// Gives a program all variables that the descriptor marks as its parameters: numbers to the uniform of the
    /// variable's name, one of several choices as its place among them, from 0, a texture `x` to the sampler
    /// `x_sampler` (for `texture` itself is a function of GLSL), bound from texture unit `first_unit` on. The program
    /// must be in use.
    void apply_parameters(const gpu::Program& program, int first_unit) const;

    /// Grows by one with each change: what a component has derived from values is stale when it differs.
    [[nodiscard]] int revision() const { return revision_; }

private:
    [[noreturn]] void refuse_type(std::string_view name) const;
    [[nodiscard]] std::shared_ptr<const gpu::Texture> find_texture(const std::string& name, TextureForm form) const;
    [[nodiscard]] int place_of_choice(const VariableDescriptor& variable) const;

    PassDefinition definition_;
    Resources* resources_;
    GeneratedTextures* generated_;
    std::map<std::string, std::shared_ptr<const gpu::Texture>, std::less<>> textures_;
    int revision_ = 0;
};

}  // namespace croquis::framework
