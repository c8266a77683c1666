#include <algorithm>
#include <array>

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

constexpr std::array types{
    std::pair(framework::VariableType::boolean, PassVariable::Type::boolean),
    std::pair(framework::VariableType::integer, PassVariable::Type::integer),
    std::pair(framework::VariableType::number, PassVariable::Type::number),
    std::pair(framework::VariableType::string, PassVariable::Type::text),
    std::pair(framework::VariableType::vector2, PassVariable::Type::vector),
    std::pair(framework::VariableType::vector3, PassVariable::Type::vector),
    std::pair(framework::VariableType::vector4, PassVariable::Type::vector),
    std::pair(framework::VariableType::rgb, PassVariable::Type::color),
    std::pair(framework::VariableType::rgba, PassVariable::Type::color),
    std::pair(framework::VariableType::texture, PassVariable::Type::texture),
};

PassVariable::Type type_of(framework::VariableType type) {
    return std::find_if(types.begin(), types.end(), [&](const auto& pair) { return pair.first == type; })->second;
}

// As Technique::set takes it: without the quotes of a file.
std::string plain_text(const framework::Value& value) {
    const auto* text = std::get_if<std::string>(&value);
    return text != nullptr ? *text : framework::format_value(value);
}

// One number for each that the type has; none where there is no value, or it is text.
std::vector<double> numbers(const std::optional<framework::Value>& value, framework::VariableType type) {
    if (!value) return {};
    const glm::vec4 all = framework::as_vector(*value);
    std::vector<double> result;
    for (int i = 0; i < framework::number_count(type); ++i) result.push_back(all[i]);
    return result;
}

PassVariable described(const framework::Pass& pass, const framework::VariableDescriptor& descriptor) {
    const framework::Value& value = pass.value(descriptor.name);
    return {
        .pass = pass.name(),
        .name = descriptor.name,
        .type = type_of(descriptor.type),
        .help = descriptor.help,
        .unit = descriptor.unit,
        .choices = descriptor.choices,
        .minimum = numbers(descriptor.minimum, descriptor.type),
        .maximum = numbers(descriptor.maximum, descriptor.type),
        .ui_minimum = numbers(descriptor.ui_minimum, descriptor.type),
        .ui_maximum = numbers(descriptor.ui_maximum, descriptor.type),
        .default_value = descriptor.default_value ? std::optional(plain_text(*descriptor.default_value)) : std::nullopt,
        .value = plain_text(value),
        .numbers = numbers(value, descriptor.type),
        .read_only = descriptor.read_only,
        .internal = descriptor.internal,
        .common = descriptor.common};
}

}  // namespace

Technique::Technique(std::unique_ptr<Opened> opened) : opened_(std::move(opened)) {}
Technique::Technique(Technique&&) noexcept = default;
Technique& Technique::operator=(Technique&&) noexcept = default;
Technique::~Technique() = default;

const std::string& Technique::name() const { return opened_->technique.name(); }
const std::string& Technique::help() const { return opened_->technique.help(); }
std::vector<std::string> Technique::pass_names() const { return opened_->technique.pass_names(); }

std::vector<PassVariable> Technique::variables() const {
    std::vector<PassVariable> variables;
    for (const std::string& name : pass_names()) {
        const framework::Pass& pass = opened_->technique.pass(name);
        for (const framework::VariableDescriptor& descriptor : pass.component().variables) {
            variables.push_back(described(pass, descriptor));
        }
    }
    return variables;
}

std::string Technique::text() const { return framework::format_technique(opened_->technique.definition()); }

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
