// croquis list and describe: what the descriptors say, for people and as JSON.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/names.h"
#include "commands.h"
#include "framework/library.h"

namespace croquis::app {
namespace {

using framework::ComponentDescriptor;
using framework::Library;
using framework::PassDefinition;
using framework::TechniqueDefinition;
using framework::Value;
using framework::VariableDescriptor;
using Json = nlohmann::ordered_json;

Library open_library(const Common& common) {
    return Library(framework::DataFolders::find({common.data_folders.begin(), common.data_folders.end()}));
}

Json as_json(const Value& value) {
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    if (const auto* truth = std::get_if<bool>(&value)) return *truth;
    if (const auto* whole = std::get_if<std::int32_t>(&value)) return *whole;
    // Numbers as technique files write them: 0.1 and not 0.10000000149.
    Json numbers = Json::array();
    for (const std::string& word : split(framework::format_value(value), " ")) numbers.push_back(Json::parse(word));
    return std::holds_alternative<float>(value) ? numbers.front() : numbers;
}

Json as_json(const VariableDescriptor& variable) {
    Json json{{"name", variable.name}, {"type", framework::name_of(variable.type)}, {"help", variable.help}};
    if (!variable.unit.empty()) json["unit"] = variable.unit;
    const std::pair<const char*, const std::optional<Value>&> values[] = {{"default", variable.default_value},
                                                                          {"minimum", variable.minimum},
                                                                          {"maximum", variable.maximum},
                                                                          {"ui_minimum", variable.ui_minimum},
                                                                          {"ui_maximum", variable.ui_maximum}};
    for (const auto& [name, value] : values) {
        if (value) json[name] = as_json(*value);
    }
    if (!variable.choices.empty()) json["choices"] = variable.choices;
    json["vertex_parameter"] = variable.vertex_parameter;
    json["fragment_parameter"] = variable.fragment_parameter;
    json["read_only"] = variable.read_only;
    json["internal"] = variable.internal;
    return json;
}

Json as_json(const ComponentDescriptor& component) {
    Json json{{"name", component.name}, {"help", component.help}, {"core", component.core}};
    if (!component.parent.empty()) json["inherits"] = component.parent;
    json["variables"] = Json::array();
    for (const VariableDescriptor& variable : component.variables) json["variables"].push_back(as_json(variable));
    return json;
}

Json as_json(const TechniqueDefinition& technique) {
    Json json{{"name", technique.name}, {"help", technique.help}, {"passes", Json::array()}};
    for (const PassDefinition& pass : technique.passes) {
        Json variables = Json::array();
        for (const VariableDescriptor& variable : pass.component->variables) {
            variables.push_back(as_json(variable));
            variables.back()["value"] = as_json(pass.values.at(variable.name));
        }
        json["passes"].push_back({{"name", pass.name}, {"component", pass.component->name}, {"variables", variables}});
    }
    return json;
}

std::string range_of(const VariableDescriptor& variable) {
    if (!variable.choices.empty()) return fmt::format("one of {}", fmt::join(variable.choices, ", "));
    std::string range;
    if (variable.minimum) range += fmt::format("from {}", framework::format_value(*variable.minimum));
    if (variable.maximum)
        range += fmt::format("{}to {}", range.empty() ? "" : " ", framework::format_value(*variable.maximum));
    if (!variable.unit.empty()) range += fmt::format("{}{}", range.empty() ? "" : " ", variable.unit);
    return range;
}

void print_variable(const VariableDescriptor& variable, const std::string& value) {
    const std::string range = range_of(variable);
    fmt::print("    {} {} = {}{}\n", framework::name_of(variable.type), variable.name, value,
               range.empty() ? "" : "  (" + range + ")");
    if (!variable.help.empty()) fmt::print("        {}\n", variable.help);
}

void print(const ComponentDescriptor& component) {
    fmt::print("component {}{}\n    {}\n\n", component.name, component.parent.empty() ? "" : " : " + component.parent,
               component.help);
    for (const VariableDescriptor& variable : component.variables) {
        if (variable.internal) continue;
        print_variable(variable, variable.default_value ? framework::format_value(*variable.default_value)
                                                        : "(each pass must set it)");
    }
}

void print(const TechniqueDefinition& technique) {
    fmt::print("technique {}\n    {}\n", technique.name, technique.help);
    for (const PassDefinition& pass : technique.passes) {
        fmt::print("\npass {} {}\n    {}\n", pass.component->name, pass.name, pass.component->help);
        for (const VariableDescriptor& variable : pass.component->variables) {
            if (variable.internal) continue;
            print_variable(variable, framework::format_value(pass.values.at(variable.name)));
        }
    }
}

// A broken technique of the user's own does not keep the others from being listed.
std::string help_of_technique(const Library& library, const std::string& name) {
    try {
        return library.technique(name).help;
    } catch (const Error& error) {
        return fmt::format("(broken: {})", error.what());
    }
}

int run_list(const Common& common, bool json) {
    const Library library = open_library(common);
    if (json) {
        Json listing{{"techniques", Json::array()}, {"components", Json::array()}};
        for (const std::string& name : library.technique_names()) {
            listing["techniques"].push_back({{"name", name}, {"help", help_of_technique(library, name)}});
        }
        for (const std::string& name : library.descriptors().names()) {
            listing["components"].push_back({{"name", name}, {"help", library.descriptors().at(name).help}});
        }
        fmt::print("{}\n", listing.dump(2));
        return 0;
    }
    fmt::print("Techniques (croquis render MODEL --technique NAME):\n");
    for (const std::string& name : library.technique_names()) {
        fmt::print("  {:34} {}\n", name, help_of_technique(library, name));
    }
    fmt::print("\nComponents (the kinds of pass that techniques are made of):\n");
    for (const std::string& name : library.descriptors().names()) {
        fmt::print("  {:34} {}\n", name, library.descriptors().at(name).help);
    }
    return 0;
}

template <typename Described>
int show(const Described& described, bool json) {
    if (json) {
        fmt::print("{}\n", as_json(described).dump(2));
    } else {
        print(described);
    }
    return 0;
}

struct CatalogueOptions {
    Common common;
    std::string name;
    bool component = false;
    bool json = false;
};

// A technique where one has the name, unless a component is asked for: wireframe is both.
int run_describe(const CatalogueOptions& options) {
    const Library library = open_library(options.common);
    const std::string& name = options.name;
    std::vector<std::string> names = library.technique_names();
    const bool is_technique =
        name.ends_with(".technique") || std::find(names.begin(), names.end(), name) != names.end();
    if (is_technique && !options.component) return show(library.technique(name), options.json);
    if (const ComponentDescriptor* component = library.descriptors().find(name)) return show(*component, options.json);
    if (options.component) names.clear();
    for (std::string& component : library.descriptors().names()) names.push_back(std::move(component));
    fail("no {}component \"{}\"{}", options.component ? "" : "technique or ", name, suggestion(name, names));
}

}  // namespace

void add_list_command(CLI::App& program, Commands& commands) {
    CLI::App* command = program.add_subcommand("list", "Lists techniques and components");
    const auto options = std::make_shared<CatalogueOptions>();
    command->add_flag("--json", options->json, "Print JSON");
    options->common.add_to(*command);
    commands[command] = [options] { return run_list(options->common, options->json); };
}

void add_describe_command(CLI::App& program, Commands& commands) {
    CLI::App* command =
        program.add_subcommand("describe", "Says what a technique or component is, its variables, ranges and defaults");
    const auto options = std::make_shared<CatalogueOptions>();
    command->add_option("name", options->name, "Name of a technique or component, or path of a .technique file")
        ->required();
    command->add_flag("--component", options->component, "Describe the component where a technique has the same name");
    command->add_flag("--json", options->json, "Print JSON");
    options->common.add_to(*command);
    commands[command] = [options] { return run_describe(*options); };
}

}  // namespace croquis::app
