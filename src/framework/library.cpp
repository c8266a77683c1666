#include "framework/library.h"

#include "base/error.h"
#include "base/files.h"
#include "base/log.h"
#include "base/names.h"

namespace croquis::framework {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t most_bytes = 1 << 20;
constexpr const char* technique_ending = ".technique";

Descriptors::Source read_source(const fs::path& path) { return {path.string(), read_file(path, most_bytes)}; }

// Layers from the shipped folder to the user's first one: a later layer replaces what an earlier one has.
Descriptors read_descriptors(const DataFolders& folders) {
    std::vector<std::vector<Descriptors::Source>> layers;
    for (auto folder = folders.folders().rbegin(); folder != folders.folders().rend(); ++folder) {
        const DataFolders only({*folder});
        std::vector<Descriptors::Source>& layer = layers.emplace_back();
        for (const std::string& name : only.names("components", ".component")) {
            layer.push_back(read_source(only.find("components", name, ".component")));
        }
    }
    return Descriptors(layers);
}

Descriptors::Source find_named(const Library& library, const std::string& name) {
    const fs::path path = library.folders().find("techniques", name, technique_ending);
    if (!path.empty()) return read_source(path);
    fail("unknown technique \"{}\"{}", name, suggestion(name, library.technique_names()));
}

}  // namespace

Library::Library(DataFolders folders) : folders_(std::move(folders)), descriptors_(read_descriptors(folders_)) {}

std::vector<std::string> Library::technique_names() const { return folders_.names("techniques", technique_ending); }

TechniqueDefinition Library::technique(const std::string& name_or_path) const {
    const fs::path path(name_or_path);
    if (path.extension() != technique_ending) {
        return read_technique(name_or_path, find_named(*this, name_or_path), descriptors_,
                              [this](const std::string& name) { return find_named(*this, name); });
    }
    const auto find_beside = [&](const std::string& name) {
        check_stays_inside(name);
        const fs::path beside = path.parent_path() / (name + technique_ending);
        std::error_code error;
        return fs::is_regular_file(beside, error) ? read_source(beside) : find_named(*this, name);
    };
    return read_technique(path.stem().string(), read_source(path), descriptors_, find_beside);
}

TechniqueDefinition Library::technique_from_text(const std::string& name, const std::string& text) const {
    return read_technique(name, {name + technique_ending, text}, descriptors_,
                          [this](const std::string& included) { return find_named(*this, included); });
}

void assign(TechniqueDefinition& technique, const std::string& assignment) {
    const std::size_t equals = assignment.find('=');
    const std::size_t dot = assignment.rfind('.', equals);
    if (equals == std::string::npos || dot == std::string::npos) {
        fail("expected pass.variable=value, found \"{}\"", assignment);
    }
    const std::string pass_name = assignment.substr(0, dot);
    const std::string variable_name = assignment.substr(dot + 1, equals - dot - 1);
    const PassDefinition* found = technique.find(pass_name);
    if (found == nullptr) {
        fail("technique {} has no pass \"{}\"{}", technique.name, pass_name,
             suggestion(pass_name, technique.pass_names()));
    }
    PassDefinition& pass = technique.passes[std::size_t(found - technique.passes.data())];
    const VariableDescriptor* variable = pass.component->find(variable_name);
    if (variable == nullptr) {
        fail("pass \"{}\" has no variable \"{}\"{}", pass_name, variable_name,
             suggestion(variable_name, pass.component->variable_names()));
    }
    const std::string where = fmt::format("{}.{}", pass_name, variable_name);
    try {
        FittedValue fitted = fit_to_range(*variable, parse_value(variable->type, assignment.substr(equals + 1)));
        if (!fitted.error.empty()) throw Error(fitted.error);
        if (!fitted.warning.empty()) warn("{}: {}", where, fitted.warning);
        pass.values.insert_or_assign(variable->name, std::move(fitted.value));
    } catch (const Error& error) {
        throw Error(fmt::format("{}: {}", where, error.what()));
    }
}

}  // namespace croquis::framework
