// From a technique file to its passes: values by their descriptors, includes and modifications (seed C, 2.1).
#include "framework/technique_definition.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/log.h"
#include "base/names.h"
#include "framework/grammar.h"

namespace croquis::framework {
namespace {

constexpr std::size_t most_passes = 256;
constexpr std::size_t most_nested = 16;
constexpr std::size_t most_includes = 256;  // in all: a few files that include each other twice would never end

/// Reads one technique and what it includes.
class Reader {
public:
    Reader(const Descriptors& descriptors, const FindTechnique& find) : descriptors_(descriptors), find_(find) {}

    TechniqueDefinition read(const std::string& name, const Descriptors::Source& source) {
        technique_.name = name;
        read_file(name, source);
        for (const PassDefinition& pass : technique_.passes) check_complete(pass);
        return std::move(technique_);
    }

private:
    void read_file(const std::string& name, const Descriptors::Source& source) {
        open_.push_back(name);
        for (const TechniqueStatement& statement : parse_technique(source.name, source.text)) {
            switch (statement.kind) {
                case TechniqueStatement::Kind::help:
                    read_help(statement);
                    break;
                case TechniqueStatement::Kind::include:
                    include(statement, source.name);
                    break;
                case TechniqueStatement::Kind::pass:
                    add_pass(statement, source.name);
                    break;
                case TechniqueStatement::Kind::modify:
                    modify_pass(statement, source.name);
                    break;
            }
        }
        open_.pop_back();
    }

    // A technique is described by its own text, not by what it includes.
    void read_help(const TechniqueStatement& statement) {
        if (open_.size() == 1) technique_.help = statement.subject.text;
    }

    void include(const TechniqueStatement& statement, const std::string& file) {
        const std::string& name = statement.subject.text;
        const TextPosition where = position(file, statement.subject.where);
        const auto again = std::find(open_.begin(), open_.end(), name);
        if (again != open_.end()) {
            std::string chain;
            for (auto link = again; link != open_.end(); ++link) chain += *link + " includes ";
            fail_at(where, "the includes never end: {}{}", chain, name);
        }
        if (open_.size() >= most_nested) fail_at(where, "includes are nested more than {} deep", most_nested);
        if (++includes_ > most_includes) fail_at(where, "more than {} includes", most_includes);
        read_file(name, source_of(name, where));
    }

    [[nodiscard]] Descriptors::Source source_of(const std::string& name, const TextPosition& where) const {
        try {
            return find_(name);
        } catch (const Error& error) {
            fail_at(where, "{}", error.what());
        }
    }

    void add_pass(const TechniqueStatement& statement, const std::string& file) {
        const Word& component = statement.subject;
        const TextPosition component_where = position(file, component.where);
        PassDefinition pass;
        pass.component = descriptors_.find(component.text);
        if (pass.component == nullptr) fail_at(component_where, "{}", descriptors_.why_missing(component.text));
        if (component.text == every_component) {
            fail_at(component_where, "component {} only lends its variables to the others; no pass can use it",
                    every_component);
        }
        pass.where = position(file, statement.where);
        pass.name = statement.name ? unused_name(*statement.name, file) : numbered_name(component.text);
        if (technique_.passes.size() >= most_passes) fail_at(pass.where, "more than {} passes", most_passes);
        for (const VariableDescriptor& variable : pass.component->variables) {
            if (variable.default_value) pass.values.emplace(variable.name, *variable.default_value);
        }
        set_values(pass, statement.settings, file);
        technique_.passes.push_back(std::move(pass));
    }

    [[nodiscard]] std::string unused_name(const Word& name, const std::string& file) const {
        if (const PassDefinition* other = technique_.find(name.text)) {
            fail_at(position(file, name.where), "there is a pass \"{}\" already, at {}", name.text,
                    other->where.to_string());
        }
        return name.text;
    }

    // NAME, NAME_2, NAME_3, …: the first that no pass has yet.
    [[nodiscard]] std::string numbered_name(const std::string& component) const {
        std::string name = component;
        for (int number = 2; technique_.find(name) != nullptr; ++number) name = fmt::format("{}_{}", component, number);
        return name;
    }

    void modify_pass(const TechniqueStatement& statement, const std::string& file) {
        const Word& name = statement.subject;
        auto& passes = technique_.passes;
        const auto pass = std::find_if(passes.begin(), passes.end(),
                                       [&](const PassDefinition& candidate) { return candidate.name == name.text; });
        if (pass == passes.end()) {
            fail_at(position(file, name.where), "there is no pass \"{}\" above to modify{}", name.text,
                    suggestion(name.text, technique_.pass_names()));
        }
        set_values(*pass, statement.settings, file);
    }

    static void set_values(PassDefinition& pass, const std::vector<Setting>& settings, const std::string& file) {
        refuse_repeated(settings, file, fmt::format("pass \"{}\"", pass.name));
        for (const Setting& setting : settings) {
            const std::string& name = setting.name.text;
            const VariableDescriptor* variable = pass.component->find(name);
            if (variable == nullptr) {
                fail_at(position(file, setting.name.where),
                        "pass \"{}\" sets \"{}\", which component {} does not have{}", pass.name, name,
                        pass.component->name, suggestion(name, pass.component->variable_names()));
            }
            pass.values.insert_or_assign(name, value_for(*variable, setting, file, pass.component->name));
        }
    }

    static Value value_for(const VariableDescriptor& variable, const Setting& setting, const std::string& file,
                           const std::string& component) {
        const std::string owner = fmt::format("variable \"{}\" of component {}", variable.name, component);
        FittedValue fitted = fit_to_range(variable, typed_value(setting, variable.type, file, owner));
        const TextPosition where = position(file, setting.value.front().where);
        if (!fitted.error.empty()) fail_at(where, "{} {}", owner, fitted.error);
        if (!fitted.warning.empty()) warn("{}: {}: {}", where.to_string(), owner, fitted.warning);
        return std::move(fitted.value);
    }

    static void check_complete(const PassDefinition& pass) {
        for (const VariableDescriptor& variable : pass.component->variables) {
            if (pass.values.find(variable.name) != pass.values.end()) continue;
            fail_at(pass.where, "pass \"{}\" must set \"{}\": component {} gives it no default", pass.name,
                    variable.name, pass.component->name);
        }
    }

    const Descriptors& descriptors_;
    const FindTechnique& find_;
    TechniqueDefinition technique_;
    std::vector<std::string> open_;  // the technique and the includes being read, outermost first
    std::size_t includes_ = 0;
};

}  // namespace

const PassDefinition* TechniqueDefinition::find(std::string_view pass) const {
    const auto found = std::find_if(passes.begin(), passes.end(),
                                    [&](const PassDefinition& candidate) { return candidate.name == pass; });
    return found == passes.end() ? nullptr : &*found;
}

std::vector<std::string> TechniqueDefinition::pass_names() const {
    std::vector<std::string> names;
    for (const PassDefinition& pass : passes) names.push_back(pass.name);
    return names;
}

TechniqueDefinition read_technique(const std::string& name, const Descriptors::Source& source,
                                   const Descriptors& descriptors, const FindTechnique& find) {
    return Reader(descriptors, find).read(name, source);
}

std::string format_technique(const TechniqueDefinition& technique) {
    std::string text;
    if (!technique.help.empty()) text += fmt::format("help {} ;\n\n", quote(technique.help));
    for (const PassDefinition& pass : technique.passes) {
        text += fmt::format("pass {} {} {{\n", pass.component->name, pass.name);
        for (const VariableDescriptor& variable : pass.component->variables) {
            const Value& value = pass.values.at(variable.name);
            if (variable.default_value == value) continue;
            text += fmt::format("    {} {} ;\n", variable.name, format_value(value));
        }
        text += "} ;\n";
    }
    return text;
}

}  // namespace croquis::framework
