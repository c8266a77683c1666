// Component descriptors: the one declaration of a component's variables, from text (seed C, 2.2.1-2.2.3).
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "framework/texture_form.h"
#include "framework/value.h"

namespace croquis::framework {

/// One variable: its type, range and meaning. Ranges of vectors and colours are component-wise.
struct VariableDescriptor {
    std::string name;
    VariableType type = VariableType::number;
    std::optional<Value> default_value;  ///< none: each pass must set the variable
    std::optional<Value> minimum, maximum;
    std::optional<Value> ui_minimum, ui_maximum;  ///< limits of sliders only
    bool vertex_parameter = false;                ///< reaches the vertex program's uniform of the same name
    bool fragment_parameter = false;              ///< reaches the fragment program's uniform of the same name
    bool read_only = false;                       ///< shown, but not changed at run time
    bool internal = false;                        ///< not shown
    bool common = false;                          ///< declared by `every_component`
    std::string help;
    std::string unit;                      ///< "pixels", "degrees", …; empty for a plain number
    std::vector<std::string> choices;      ///< the only values a string may take; any where empty
    TextureForm form = TextureForm::flat;  ///< of the image that a texture variable names
    TextPosition where;                    ///< of its declaration
};

/// A component's interface. The implementation is that of `core`, the oldest ancestor.
struct ComponentDescriptor {
    std::string name;
    std::string parent;  ///< the component it inherits from; empty for a core component
    std::string core;    ///< name of the C++ implementation
    std::string help;
    std::vector<VariableDescriptor> variables;  ///< inherited ones first, in order of declaration
    TextPosition where;

    /// The variable, or null.
    [[nodiscard]] const VariableDescriptor* find(std::string_view variable) const;
    [[nodiscard]] std::vector<std::string> variable_names() const;
};

/// The component whose variables every component has (`render`, `objects`, …). It stands in a descriptor file as any
/// other, and is inherited by each component that names no parent; it has no implementation.
constexpr std::string_view every_component = "every_component";

/// All component descriptors, by name.
class Descriptors {
public:
    /// A text to read: its name for messages, and what it says.
    struct Source {
        std::string name;
        std::string text;
    };

    /// Reads descriptor files. A component in a later folder of `layers` replaces the one of the same name in an
    /// earlier folder, so that a user's own folder can change what is shipped; two of one name within a folder are an
    /// error. The order of files in a folder does not matter. Throws Error at the place of the first mistake.
    ///
    /// A component that inherits from a replaced one inherits from the replacement. Where it does not fit that any
    /// more (it modifies a variable that is gone, say), it is left out with a warning, and asking for it says why.
    explicit Descriptors(std::span<const std::vector<Source>> layers);

    /// Throws Error with the nearest name.
    [[nodiscard]] const ComponentDescriptor& at(std::string_view name) const;
    [[nodiscard]] const ComponentDescriptor* find(std::string_view name) const;
    /// All names but `every_component`, sorted.
    [[nodiscard]] std::vector<std::string> names() const;
    /// What to tell a user who asks for a component that is not here: the nearest name, or why it was left out.
    [[nodiscard]] std::string why_missing(std::string_view name) const;

private:
    std::map<std::string, ComponentDescriptor, std::less<>> components_;
    std::map<std::string, std::string, std::less<>> left_out_;  // and the reason
};

/// What a variable makes of a value: the value it takes, and what to tell the user, both without a place or name.
struct FittedValue {
    Value value;
    std::string warning;  ///< "7 is outside -1 to 1; using 1", or empty
    std::string error;    ///< "expects one of …, found …" for a string that is not among the choices, or empty
};
[[nodiscard]] FittedValue fit_to_range(const VariableDescriptor& variable, Value value);

/// Clamps a value to the variable's range, component-wise, with one warning that leads with `where` (a place in a
/// file, or what was typed). NaN becomes the default or the minimum. Throws Error for a string that is not among the
/// choices.
[[nodiscard]] Value clamp_to_range(const VariableDescriptor& variable, Value value, const std::string& where);

}  // namespace croquis::framework
