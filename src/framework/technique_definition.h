// Techniques as text: a sequence of passes, each a component with values for its variables (seed C, 2.1).
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "framework/descriptor.h"
#include "framework/value.h"

namespace croquis::framework {

/// One pass: which component it uses, and a value for every variable of that component.
struct PassDefinition {
    const ComponentDescriptor* component = nullptr;  ///< owned by the Descriptors it was read with
    std::string name;  ///< unique in its technique; the component's name if none was given
    std::map<std::string, Value, std::less<>> values;
    TextPosition where;
};

/// A technique as its file says it, includes and modifications carried out.
struct TechniqueDefinition {
    std::string name;
    std::string help;
    std::vector<PassDefinition> passes;

    /// The pass of that name, or null.
    [[nodiscard]] const PassDefinition* find(std::string_view pass) const;
    [[nodiscard]] std::vector<std::string> pass_names() const;
};

/// Finds the text of an included technique by the name in the `include` statement. Throws Error (without a place) for
/// a name that it does not have.
using FindTechnique = std::function<Descriptors::Source(const std::string& name)>;

/// Reads a technique:
///
///     help "What it draws." ;
///     include "edges" ;                         # the passes of another technique, here
///     pass COMPONENT NAME { variable value ; … } ;
///     modify NAME { variable value ; … } ;      # changes values of an earlier pass, an included one for instance
///
/// The pass's name may be left out, and so may the braces (`pass COMPONENT ;`). `#` starts a comment. Throws Error at
/// the place of the first mistake: unknown component or variable (with the nearest name), wrong type, a variable
/// without default that got no value, a cycle of includes, two passes of one name. Out-of-range values warn and clamp.
[[nodiscard]] TechniqueDefinition read_technique(const std::string& name, const Descriptors::Source& source,
                                                 const Descriptors& descriptors, const FindTechnique& find);

/// The technique as a file that draws the same: every pass with the values that are not its component's defaults.
[[nodiscard]] std::string format_technique(const TechniqueDefinition& technique);

}  // namespace croquis::framework
