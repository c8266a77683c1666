// Technique files: any bytes give complete passes whose values survive being written and read, or an Error.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "base/error.h"
#include "framework/descriptor.h"
#include "framework/technique_definition.h"

using namespace croquis;
using namespace croquis::framework;

namespace {

const Descriptors& descriptors() {
    static const std::vector<std::vector<Descriptors::Source>> layers{{{"components", R"(
component every_component { bool render { default true ; } ; } ;
component a {
  int i { default 1 ; minimum -5 ; maximum 5 ; } ; number n { default 0.5 ; maximum 1 ; } ; string s ;
  vector2 v2 { default 0 0 ; } ; vector3 v3 { default 0 0 0 ; minimum 0 0 0 ; } ; vector4 v4 { default 0 0 0 0 ; } ;
  rgb c { default 0 0 0 ; minimum 0 0 0 ; maximum 1 1 1 ; } ; rgba d { default 0 0 0 1 ; } ;
  texture t { default "images:*" ; } ; string m { default "x" ; choices "x y" ; } ;
} ;
component b : a { modify s { default "set" ; } ; } ;
)"}}};
    static const Descriptors all(layers);
    return all;
}

TechniqueDefinition read(const std::string& text, const std::string& included) {
    return read_technique("t", {"file", text}, descriptors(), [&](const std::string& name) -> Descriptors::Source {
        if (name == "other") return {"other", included};
        fail("unknown technique \"{}\"", name);
    });
}

std::string written(const TechniqueDefinition& technique) {
    std::string text;
    for (const PassDefinition& pass : technique.passes) {
        text += "pass " + pass.component->name + " " + pass.name + " {\n";
        for (const auto& [name, value] : pass.values) text += "  " + name + " " + format_value(value) + " ;\n";
        text += "} ;\n";
    }
    return text;
}

}  // namespace

// A line `---` separates the technique from the one that it can include as "other".
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    const std::size_t cut = text.find("\n---\n");
    TechniqueDefinition technique;
    try {
        technique = read(text.substr(0, cut), cut == std::string::npos ? "" : text.substr(cut + 5));
    } catch (const Error& error) {
        if (std::string(error.what()).empty()) std::abort();
        return 0;
    }
    const TechniqueDefinition again = read(written(technique), "");
    if (again.passes.size() != technique.passes.size()) std::abort();
    for (std::size_t i = 0; i < again.passes.size(); ++i) {
        if (again.passes[i].values != technique.passes[i].values) std::abort();
        if (again.passes[i].values.size() != again.passes[i].component->variables.size()) std::abort();
    }
    return 0;
}
