#include "api/handles.h"
#include "base/error.h"

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
    const framework::VariableDescriptor& descriptor = opened_->technique.pass(name.pass).descriptor(name.variable);
    opened_->context.make_current();
    opened_->technique.set(name.pass, name.variable, framework::parse_value(descriptor.type, value));
}

std::string Technique::get(const std::string& variable) const {
    const VariableName name = split_name(variable);
    const framework::Pass& pass = opened_->technique.pass(name.pass);
    return framework::format_value(pass.value(pass.descriptor(name.variable).name));
}

}  // namespace croquis
