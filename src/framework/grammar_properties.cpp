// Properties of variables, and the ranges that come of them (seed C, 2.2.2). Ranges of vectors are component-wise.
#include "framework/grammar_properties.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "base/log.h"
#include "base/names.h"

namespace croquis::framework {
namespace {

// ---- Numbers of a value: in double precision, which holds every int and float exactly -------------------------------

using Numbers = std::array<double, 4>;

struct ToNumbers {
    Numbers operator()(bool b) const { return {b ? 1.0 : 0.0}; }
    Numbers operator()(std::int32_t i) const { return {static_cast<double>(i)}; }
    Numbers operator()(float f) const { return {static_cast<double>(f)}; }
    Numbers operator()(const std::string&) const { return {}; }
    Numbers operator()(const glm::vec2& v) const { return {v.x, v.y}; }
    Numbers operator()(const glm::vec3& v) const { return {v.x, v.y, v.z}; }
    Numbers operator()(const glm::vec4& v) const { return {v.x, v.y, v.z, v.w}; }
};

Numbers numbers_of(const Value& value) { return std::visit(ToNumbers{}, value); }

// `like` with other numbers.
Value with_numbers(Value like, const Numbers& n) {
    const auto f = [&](std::size_t i) { return static_cast<float>(n[i]); };
    if (auto* integer = std::get_if<std::int32_t>(&like)) *integer = static_cast<std::int32_t>(n[0]);
    if (auto* number = std::get_if<float>(&like)) *number = f(0);
    if (auto* vector = std::get_if<glm::vec2>(&like)) *vector = {f(0), f(1)};
    if (auto* vector = std::get_if<glm::vec3>(&like)) *vector = {f(0), f(1), f(2)};
    if (auto* vector = std::get_if<glm::vec4>(&like)) *vector = {f(0), f(1), f(2), f(3)};
    return like;
}

bool any_below(const Value& a, const Value& b) {
    const Numbers left = numbers_of(a), right = numbers_of(b);
    for (std::size_t i = 0; i < left.size(); ++i) {
        if (left[i] < right[i]) return true;
    }
    return false;
}

std::string range_remark(const VariableDescriptor& variable, const Value& asked, const Value& used) {
    const std::string what = format_value(asked), instead = format_value(used);
    if (variable.minimum && variable.maximum) {
        return fmt::format("{} is outside {} to {}; using {}", what, format_value(*variable.minimum),
                           format_value(*variable.maximum), instead);
    }
    if (variable.minimum)
        return fmt::format("{} is below {}; using {}", what, format_value(*variable.minimum), instead);
    if (variable.maximum)
        return fmt::format("{} is above {}; using {}", what, format_value(*variable.maximum), instead);
    return fmt::format("{} is not a finite number; using {}", what, instead);
}

std::string choice_error(const VariableDescriptor& variable, const std::string& text) {
    const auto& choices = variable.choices;
    if (choices.empty() || std::find(choices.begin(), choices.end(), text) != choices.end()) return {};
    std::string list;
    for (const std::string& choice : choices) list += (list.empty() ? "" : ", ") + quote(choice);
    return fmt::format("expects one of {}; found {}{}", list, quote(text), suggestion(text, choices));
}

// ---- Properties -----------------------------------------------------------------------------------------------------

const std::vector<std::string> all_properties = {
    "default",  "minimum", "maximum", "ui_minimum", "ui_maximum", "vertex_parameter", "fragment_parameter", "read_only",
    "internal", "help",    "unit",    "choices",    "form"};

using ValueMember = std::optional<Value> VariableDescriptor::*;
using FlagMember = bool VariableDescriptor::*;

ValueMember value_property(std::string_view name) {
    if (name == "default") return &VariableDescriptor::default_value;
    if (name == "minimum") return &VariableDescriptor::minimum;
    if (name == "maximum") return &VariableDescriptor::maximum;
    if (name == "ui_minimum") return &VariableDescriptor::ui_minimum;
    if (name == "ui_maximum") return &VariableDescriptor::ui_maximum;
    return nullptr;
}

FlagMember flag_property(std::string_view name) {
    if (name == "vertex_parameter") return &VariableDescriptor::vertex_parameter;
    if (name == "fragment_parameter") return &VariableDescriptor::fragment_parameter;
    if (name == "read_only") return &VariableDescriptor::read_only;
    if (name == "internal") return &VariableDescriptor::internal;
    return nullptr;
}

bool can_have_range(VariableType type) { return type != VariableType::boolean && number_count(type) > 0; }

/// Reads one property at a time, with the variable's name in every message.
class PropertyReader {
public:
    PropertyReader(VariableDescriptor& variable, const std::string& file) : variable_(variable), file_(file) {}

    void read(const Setting& setting) {
        const std::string& name = setting.name.text;
        if (const ValueMember value = value_property(name)) {
            if (name != "default" && !can_have_range(variable_.type)) refuse(setting, "range");
            variable_.*value = typed_value(setting, variable_.type, file_, owner(name));
        } else if (const FlagMember flag = flag_property(name)) {
            variable_.*flag = std::get<bool>(typed_value(setting, VariableType::boolean, file_, owner(name)));
        } else if (name == "help") {
            variable_.help = text(setting);
        } else if (name == "unit") {
            variable_.unit = text(setting);
        } else if (name == "choices") {
            if (variable_.type != VariableType::string) refuse(setting, "choices");
            variable_.choices = split(text(setting), " ");
        } else if (name == "form") {
            if (variable_.type != VariableType::texture) refuse(setting, "form");
            variable_.form = form(setting);
        } else {
            fail_at(position(file_, setting.name.where), "variable \"{}\" has no property \"{}\"{}", variable_.name,
                    name, suggestion(name, all_properties));
        }
    }

private:
    [[nodiscard]] std::string owner(std::string_view property) const {
        return fmt::format("{} of variable \"{}\"", property, variable_.name);
    }

    [[nodiscard]] std::string text(const Setting& setting) const {
        return std::get<std::string>(typed_value(setting, VariableType::string, file_, owner(setting.name.text)));
    }

    [[nodiscard]] TextureForm form(const Setting& setting) const {
        const std::string name = text(setting);
        const auto found = std::find(texture_forms.begin(), texture_forms.end(), name);
        if (found != texture_forms.end()) return TextureForm(found - texture_forms.begin());
        const std::vector<std::string> names(texture_forms.begin(), texture_forms.end());
        fail_at(position(file_, setting.value.front().where),
                "form of variable \"{}\" expects one of \"{}\"; found \"{}\"{}", variable_.name,
                fmt::join(names, "\", \""), name, suggestion(name, names));
    }

    [[noreturn]] void refuse(const Setting& setting, std::string_view what) const {
        fail_at(position(file_, setting.name.where),
                "variable \"{}\" is of type {}, which has no {}: {} is not allowed", variable_.name,
                name_of(variable_.type), what, setting.name.text);
    }

    VariableDescriptor& variable_;
    const std::string& file_;
};

// Which of the properties is to blame stands first in `suspects`: the error is at the first that the statement gives.
TextPosition blame(const VariableStatement& statement, const std::string& file,
                   std::initializer_list<std::string_view> suspects) {
    for (const std::string_view suspect : suspects) {
        for (const Setting& setting : statement.properties) {
            if (setting.name.text == suspect) return position(file, setting.value.front().where);
        }
    }
    return position(file, statement.name.where);
}

void check_order(const VariableDescriptor& variable, const VariableStatement& statement, const std::string& file,
                 std::string_view low_name, std::string_view high_name) {
    const std::optional<Value>& low = variable.*value_property(low_name);
    const std::optional<Value>& high = variable.*value_property(high_name);
    if (!low || !high || !any_below(*high, *low)) return;
    fail_at(blame(statement, file, {low_name, high_name}), "variable \"{}\": its {} {} is above its {} {}",
            variable.name, low_name, format_value(*low), high_name, format_value(*high));
}

void check_default(const VariableDescriptor& variable, const VariableStatement& statement, const std::string& file) {
    if (!variable.default_value) return;
    const FittedValue fitted = fit_to_range(variable, *variable.default_value);
    const TextPosition where = blame(statement, file, {"default", "minimum", "maximum", "choices"});
    if (!fitted.error.empty()) fail_at(where, "default of variable \"{}\" {}", variable.name, fitted.error);
    if (fitted.warning.empty()) return;
    const std::string remark = fitted.warning.substr(0, fitted.warning.find(';'));
    fail_at(where, "default of variable \"{}\": {}", variable.name, remark);
}

}  // namespace

void apply_properties(VariableDescriptor& variable, const VariableStatement& statement, const std::string& file) {
    refuse_repeated(statement.properties, file, fmt::format("variable \"{}\"", variable.name));
    PropertyReader reader(variable, file);
    const auto given = [&](std::string_view name) {
        return std::any_of(statement.properties.begin(), statement.properties.end(),
                           [&](const Setting& setting) { return setting.name.text == name; });
    };
    for (const Setting& setting : statement.properties) reader.read(setting);
    if (given("minimum") && !given("ui_minimum")) variable.ui_minimum = variable.minimum;
    if (given("maximum") && !given("ui_maximum")) variable.ui_maximum = variable.maximum;
    check_order(variable, statement, file, "minimum", "maximum");
    check_order(variable, statement, file, "ui_minimum", "ui_maximum");
    check_order(variable, statement, file, "minimum", "ui_minimum");
    check_order(variable, statement, file, "ui_maximum", "maximum");
    check_default(variable, statement, file);
}

FittedValue fit_to_range(const VariableDescriptor& variable, Value value) {
    if (const auto* text = std::get_if<std::string>(&value)) return {value, {}, choice_error(variable, *text)};
    const auto numbers_or = [](const std::optional<Value>& limit, double otherwise) {
        return limit ? numbers_of(*limit) : Numbers{otherwise, otherwise, otherwise, otherwise};
    };
    const Numbers low = numbers_or(variable.minimum, -HUGE_VAL), high = numbers_or(variable.maximum, HUGE_VAL);
    const Numbers fallback = numbers_or(variable.default_value ? variable.default_value : variable.minimum, 0);
    const Numbers asked = numbers_of(value);
    Numbers used{};
    for (std::size_t i = 0; i < used.size(); ++i) {
        used[i] = std::isnan(asked[i]) ? fallback[i] : asked[i];
        used[i] = std::clamp(used[i], low[i], std::max(low[i], high[i]));
        if (!std::isfinite(used[i])) used[i] = fallback[i];
    }
    if (used == asked) return {std::move(value), {}, {}};
    Value fitted = with_numbers(value, used);
    std::string warning = range_remark(variable, value, fitted);
    return {std::move(fitted), std::move(warning), {}};
}

Value clamp_to_range(const VariableDescriptor& variable, Value value, const std::string& where) {
    FittedValue fitted = fit_to_range(variable, std::move(value));
    if (!fitted.error.empty()) fail("{}: variable \"{}\" {}", where, variable.name, fitted.error);
    if (!fitted.warning.empty()) warn("{}: variable \"{}\": {}", where, variable.name, fitted.warning);
    return std::move(fitted.value);
}

}  // namespace croquis::framework
