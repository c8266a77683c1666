#include "api/handles.h"
#include "base/error.h"
#include "base/names.h"

namespace croquis {
namespace {

struct VariableName {
    std::string pass;
    std::string variable;
};

// "pass.variable" at its last dot: names of variables have none.
VariableName split_name(const std::string& name) {
    const std::size_t dot = name.rfind('.');
    if (dot == std::string::npos) fail("expected pass.variable, found \"{}\"", name);
    return {name.substr(0, dot), name.substr(dot + 1)};
}

}  // namespace

Technique::Technique(std::unique_ptr<Opened> opened) : opened_(std::move(opened)) {}
Technique::Technique(Technique&&) noexcept = default;
Technique& Technique::operator=(Technique&&) noexcept = default;
Technique::~Technique() = default;

const std::string& Technique::name() const { return opened_->technique.name(); }
const std::string& Technique::help() const { return opened_->technique.help(); }
std::vector<std::string> Technique::pass_names() const { return opened_->technique.pass_names(); }

void Technique::set(const std::string& variable, const std::string& value) {
    const VariableName name = split_name(variable);
    const framework::ComponentDescriptor& component = opened_->technique.pass(name.pass).component();
    const framework::VariableDescriptor* descriptor = component.find(name.variable);
    if (descriptor == nullptr) {
        fail("pass \"{}\" has no variable \"{}\"{}", name.pass, name.variable,
             suggestion(name.variable, component.variable_names()));
    }
    opened_->technique.set(name.pass, name.variable, framework::parse_value(descriptor->type, value));
}

std::string Technique::get(const std::string& variable) const {
    const VariableName name = split_name(variable);
    return framework::format_value(opened_->technique.pass(name.pass).value(name.variable));
}

}  // namespace croquis
