// From descriptor files to component descriptors: inheritance, layers, and checks of every property (seed C, 2.2).
#include "framework/descriptor.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "base/log.h"
#include "base/names.h"
#include "framework/grammar.h"
#include "framework/grammar_properties.h"

namespace croquis::framework {
namespace {

// Bounds of what a descriptor file can make of little text: every component holds a copy of what it inherits.
constexpr std::size_t most_variables = 256;
constexpr std::size_t most_memory = std::size_t{64} << 20;

/// A component as its file declares it.
struct Declaration {
    ComponentStatement statement;
    std::string file;
    std::size_t layer = 0;
    std::size_t newest_ancestor = 0;  // the latest layer among itself and its ancestors, once resolved

    [[nodiscard]] const std::string& name() const { return statement.name.text; }
    [[nodiscard]] TextPosition where() const { return position(file, statement.name.where); }
    /// The component it inherits from, written or implied; empty for `every_component` itself.
    [[nodiscard]] std::string_view parent() const {
        if (statement.parent) return statement.parent->text;
        return name() == every_component ? std::string_view{} : every_component;
    }
};
using Declarations = std::map<std::string, Declaration, std::less<>>;

std::size_t memory_of(const ComponentDescriptor& component) {
    std::size_t bytes = sizeof component + component.help.size();
    for (const VariableDescriptor& variable : component.variables) {
        bytes += sizeof variable + variable.name.size() + variable.help.size() + variable.unit.size();
        bytes += variable.where.file.size();
        if (variable.default_value) {
            if (const auto* text = std::get_if<std::string>(&*variable.default_value)) bytes += text->size();
        }
        for (const std::string& choice : variable.choices) bytes += sizeof choice + choice.size();
    }
    return bytes;
}

Declarations collect(std::span<const std::vector<Descriptors::Source>> layers) {
    Declarations all;
    for (std::size_t layer = 0; layer < layers.size(); ++layer) {
        for (const Descriptors::Source& source : layers[layer]) {
            for (ComponentStatement& statement : parse_components(source.name, source.text)) {
                Declaration declared{std::move(statement), source.name, layer, layer};
                const auto earlier = all.find(declared.name());
                if (earlier != all.end() && earlier->second.layer == layer) {
                    fail_at(declared.where(), "component \"{}\" is already declared at {}", declared.name(),
                            earlier->second.where().to_string());
                }
                std::string name = declared.name();
                all.insert_or_assign(std::move(name), std::move(declared));
            }
        }
    }
    return all;
}

/// Builds components in order of inheritance, whatever the order of the text.
class Resolver {
public:
    Resolver(Declarations& declarations, std::map<std::string, ComponentDescriptor, std::less<>>& components,
             std::map<std::string, std::string, std::less<>>& left_out)
        : declarations_(declarations), components_(components), left_out_(left_out) {}

    void resolve_all() {
        for (auto& [name, declaration] : declarations_) {
            // From the oldest ancestor on, so that each finds its parent built.
            const std::vector<Declaration*> chain = unresolved_chain(declaration);
            std::for_each(chain.rbegin(), chain.rend(), [&](Declaration* next) { resolve(*next); });
        }
    }

private:
    [[nodiscard]] bool is_resolved(std::string_view name) const {
        return components_.find(name) != components_.end() || left_out_.find(name) != left_out_.end();
    }

    /// The component and its ancestors that are not built yet, youngest first.
    std::vector<Declaration*> unresolved_chain(Declaration& start) {
        std::vector<Declaration*> chain;
        std::unordered_set<std::string_view> seen;
        for (Declaration* next = &start; next != nullptr && !is_resolved(next->name()); next = parent_of(*next)) {
            chain.push_back(next);
            if (!seen.insert(next->name()).second) fail_cycle(chain);
        }
        return chain;
    }

    Declaration* parent_of(const Declaration& child) {
        const auto found = declarations_.find(child.parent());
        if (found != declarations_.end()) return &found->second;
        if (!child.statement.parent) return nullptr;  // only implied: there need not be an `every_component`
        std::vector<std::string> names;
        for (const auto& [name, declaration] : declarations_) names.push_back(name);
        const Word& parent = *child.statement.parent;
        fail_at(position(child.file, parent.where), "component \"{}\" inherits from unknown component \"{}\"{}",
                child.name(), parent.text, suggestion(parent.text, names));
    }

    /// `chain` ends with a component that it holds already.
    [[noreturn]] static void fail_cycle(const std::vector<Declaration*>& chain) {
        constexpr std::size_t most_shown = 8;
        const Declaration& last = *chain.back();
        auto next = std::find(chain.begin(), chain.end(), chain.back());
        std::string names = last.name();
        for (++next; next != chain.end(); ++next) {
            const auto left = static_cast<std::size_t>(chain.end() - next);
            if (left > most_shown) continue;
            names += (left == most_shown ? " inherits … inherits " : " inherits ") + (*next)->name();
        }
        const Word& at = last.statement.parent ? *last.statement.parent : last.statement.name;
        fail_at(position(last.file, at.where), "component \"{}\" inherits from itself: {}", last.name(), names);
    }

    void resolve(Declaration& declaration) {
        const auto parent_declaration = declarations_.find(declaration.parent());
        const bool has_parent = parent_declaration != declarations_.end();
        if (has_parent) {
            declaration.newest_ancestor = std::max(declaration.layer, parent_declaration->second.newest_ancestor);
            const auto gone = left_out_.find(declaration.parent());
            if (gone != left_out_.end()) {
                return leave_out(declaration, fmt::format("it inherits from {}: {}", gone->first, gone->second));
            }
        }
        try {
            const auto parent = components_.find(declaration.parent());
            ComponentDescriptor built = build(declaration, parent == components_.end() ? nullptr : &parent->second);
            memory_ += memory_of(built);
            if (memory_ > most_memory) fail_at(declaration.where(), "the components together are larger than 64 MiB");
            components_.emplace(declaration.name(), std::move(built));
        } catch (const Error& error) {
            // Its own fault, unless what it inherits from was replaced behind its back.
            if (declaration.newest_ancestor == declaration.layer) throw;
            leave_out(declaration, error.what());
        }
    }

    void leave_out(const Declaration& declaration, std::string reason) {
        constexpr std::size_t longest_reason = 500;  // reasons of parents would pile up along a chain
        if (reason.size() > longest_reason) reason = "it inherits from a component that was left out";
        warn("component \"{}\" does not fit what replaced a component that it inherits from, and is left out: {}",
             declaration.name(), reason);
        left_out_.emplace(declaration.name(), std::move(reason));
    }

    static ComponentDescriptor build(const Declaration& declaration, const ComponentDescriptor* parent) {
        ComponentDescriptor component;
        component.name = declaration.name();
        component.core = declaration.name();
        component.where = declaration.where();
        component.help = declaration.statement.help;
        if (parent != nullptr) {
            component.variables = parent->variables;
            if (parent->name != every_component) {
                component.parent = parent->name;
                component.core = parent->core;
            }
        }
        const std::size_t inherited = component.variables.size();
        for (const VariableStatement& statement : declaration.statement.variables) {
            if (statement.type) {
                declare_variable(component, inherited, statement, declaration.file);
            } else {
                modify_variable(component, statement, declaration.file);
            }
        }
        return component;
    }

    static void declare_variable(ComponentDescriptor& component, std::size_t inherited,
                                 const VariableStatement& statement, const std::string& file) {
        const TextPosition where = position(file, statement.name.where);
        const std::string& name = statement.name.text;
        if (const VariableDescriptor* known = component.find(name)) {
            const bool own = known - component.variables.data() >= static_cast<std::ptrdiff_t>(inherited);
            if (own) fail_at(where, "variable \"{}\" is already declared in line {}", name, known->where.line);
            fail_at(where, "component {} inherits a variable \"{}\"; to change it write: modify {} {{ … }}",
                    component.name, name, name);
        }
        if (component.variables.size() >= most_variables) {
            fail_at(where, "component {} has more than {} variables", component.name, most_variables);
        }
        VariableDescriptor variable;
        variable.name = name;
        variable.type = *statement.type;
        variable.where = where;
        variable.common = component.name == every_component;
        apply_properties(variable, statement, file);
        component.variables.push_back(std::move(variable));
    }

    static void modify_variable(ComponentDescriptor& component, const VariableStatement& statement,
                                const std::string& file) {
        const std::string& name = statement.name.text;
        const auto found = std::find_if(component.variables.begin(), component.variables.end(),
                                        [&](const VariableDescriptor& variable) { return variable.name == name; });
        if (found == component.variables.end()) {
            fail_at(position(file, statement.name.where), "component {} has no variable \"{}\" to modify{}",
                    component.name, name, suggestion(name, component.variable_names()));
        }
        apply_properties(*found, statement, file);
    }

    Declarations& declarations_;
    std::map<std::string, ComponentDescriptor, std::less<>>& components_;
    std::map<std::string, std::string, std::less<>>& left_out_;
    std::size_t memory_ = 0;
};

}  // namespace

const VariableDescriptor* ComponentDescriptor::find(std::string_view variable) const {
    const auto found = std::find_if(variables.begin(), variables.end(),
                                    [&](const VariableDescriptor& candidate) { return candidate.name == variable; });
    return found == variables.end() ? nullptr : &*found;
}

std::vector<std::string> ComponentDescriptor::variable_names() const {
    std::vector<std::string> names;
    for (const VariableDescriptor& variable : variables) names.push_back(variable.name);
    return names;
}

Descriptors::Descriptors(std::span<const std::vector<Source>> layers) {
    Declarations declarations = collect(layers);
    Resolver(declarations, components_, left_out_).resolve_all();
}

const ComponentDescriptor& Descriptors::at(std::string_view name) const {
    const ComponentDescriptor* found = find(name);
    if (found == nullptr) throw Error(why_missing(name));
    return *found;
}

const ComponentDescriptor* Descriptors::find(std::string_view name) const {
    const auto found = components_.find(name);
    return found == components_.end() ? nullptr : &found->second;
}

std::vector<std::string> Descriptors::names() const {
    std::vector<std::string> names;
    for (const auto& [name, component] : components_) {
        if (name != every_component) names.push_back(name);
    }
    return names;
}

std::string Descriptors::why_missing(std::string_view name) const {
    const auto left_out = left_out_.find(name);
    if (left_out != left_out_.end()) return fmt::format("component \"{}\" was left out: {}", name, left_out->second);
    return fmt::format("unknown component \"{}\"{}", name, suggestion(name, names()));
}

}  // namespace croquis::framework
