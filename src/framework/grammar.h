// The grammar of descriptor and technique files: from text to statements (seed C, 2.1-2.2.3). What the names in them
// mean is not known here.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "framework/value.h"

namespace croquis::framework {

/// Line and column in code points, both from 1.
struct Place {
    std::uint32_t line = 0;
    std::uint32_t column = 0;
};

/// A place in a named file.
[[nodiscard]] inline TextPosition position(const std::string& file, Place place) {
    return {file, place.line, place.column};
}

/// A name, a number or a quoted text, and where it stands.
struct Word {
    std::string text;
    Place where;
};

/// `NAME VALUE… ;`: a property of a variable, or a variable's value in a pass.
struct Setting {
    Word name;
    std::vector<Word> value;  ///< at least one; a quoted text is a single one
    bool is_text = false;     ///< the value stood in double quotes
};

/// `TYPE NAME { … } ;` or `modify NAME { … } ;`
struct VariableStatement {
    std::optional<VariableType> type;  ///< none for modify
    Word name;
    std::vector<Setting> properties;
};

/// `component NAME : PARENT { … } ;`
struct ComponentStatement {
    Word name;
    std::optional<Word> parent;
    std::string help;
    std::vector<VariableStatement> variables;
};

/// A statement of a technique.
struct TechniqueStatement {
    enum class Kind { help, include, pass, modify };
    Kind kind = Kind::help;
    Place where;               ///< of its first word
    Word subject;              ///< the help text, the included technique, the pass's component, the pass to modify
    std::optional<Word> name;  ///< of a pass
    std::vector<Setting> settings;
};

/// Read a file's text. Throw Error at the place of the first mistake; `file` is the text's name in messages.
[[nodiscard]] std::vector<ComponentStatement> parse_components(const std::string& file, std::string_view text);
[[nodiscard]] std::vector<TechniqueStatement> parse_technique(const std::string& file, std::string_view text);

/// The setting's value as a value of `type`. Throws Error at the value's place: `OWNER expects a number, found "abc"`.
[[nodiscard]] Value typed_value(const Setting& setting, VariableType type, const std::string& file,
                                const std::string& owner);

/// Throws Error at the second of two settings of one name: `OWNER sets "NAME" twice`.
void refuse_repeated(const std::vector<Setting>& settings, const std::string& file, const std::string& owner);

}  // namespace croquis::framework
