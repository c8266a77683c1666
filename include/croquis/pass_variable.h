// What a technique can be told while it runs, as component descriptors declare it: enough to build a panel from.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace croquis {

/// A variable of one pass. Limits hold component by component, and are empty where there is none.
struct PassVariable {
    enum class Type { boolean, integer, number, text, vector, color, texture };

    std::string pass;
    std::string name;
    Type type = Type::number;
    std::string help;
    std::string unit;                  ///< "pixels", "degrees", …; empty for a plain number
    std::vector<std::string> choices;  ///< the only values a text may take; any where empty
    std::vector<double> minimum, maximum;
    std::vector<double> ui_minimum, ui_maximum;  ///< for sliders: where to look for good values
    std::optional<std::string> default_value;    ///< of the component, as `Technique::set` takes it
    std::string value;                           ///< as `Technique::set` takes it
    std::vector<double> numbers;                 ///< the value's numbers; none for text and textures
    bool read_only = false;                      ///< to be shown, but not changed while the technique runs
    bool internal = false;                       ///< not to be shown
    bool common = false;                         ///< every pass of any technique has it: `render`, `objects`, …

    /// "pass.name", as `Technique::set` takes it.
    [[nodiscard]] std::string full_name() const { return pass + "." + name; }
};

}  // namespace croquis
