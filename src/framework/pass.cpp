#include "framework/pass.h"

#include <algorithm>

#include "base/names.h"

namespace croquis::framework {
namespace {

struct SetUniform {
    const gpu::Program& program;
    const std::string& name;
    void operator()(const std::string&) const {}
    template <typename T>
    void operator()(const T& value) const {
        program.set(name, value);
    }
};

}  // namespace

const Value& Pass::value(std::string_view name) const {
    const auto found = definition_.values.find(name);
    if (found != definition_.values.end()) return found->second;
    fail_at(where(), "component {} has no variable \"{}\", which it cannot work without", component().name, name);
}

void Pass::refuse_type(std::string_view name) const {
    fail_at(where(), "component {} declares \"{}\" with a type that it cannot work with", component().name, name);
}

const VariableDescriptor& Pass::descriptor(std::string_view name) const {
    const VariableDescriptor* variable = component().find(name);
    if (variable != nullptr) return *variable;
    fail("pass \"{}\" has no variable \"{}\"{}", this->name(), name, suggestion(name, component().variable_names()));
}

void Pass::set(std::string_view name, const Value& value) {
    const VariableDescriptor& variable = descriptor(name);
    if (variable.read_only || variable.internal) {
        fail("variable \"{}\" of pass \"{}\" cannot change while the technique runs", name, this->name());
    }
    Value clamped = clamp_to_range(variable, value, fmt::format("{}.{}", this->name(), name));
    if (variable.type == VariableType::texture) {
        textures_[variable.name] = find_texture(std::get<std::string>(clamped), variable.form);
    }
    definition_.values.find(name)->second = std::move(clamped);
    ++revision_;
}

std::shared_ptr<const gpu::Texture> Pass::find_texture(const std::string& name, TextureForm form) const {
    if (name.empty()) return nullptr;
    const TextureName parsed = TextureName::parse(name);
    if (!parsed.is_generated) return resources_->image(parsed, form);
    if (form != TextureForm::flat) fail("expected an image with several tones or slices, found \"{}\"", name);
    return generated_->at(parsed.image);
}

void Pass::find_textures() {
    for (const VariableDescriptor& variable : component().variables) {
        if (variable.type != VariableType::texture) continue;
        try {
            textures_[variable.name] = find_texture(std::get<std::string>(value(variable.name)), variable.form);
        } catch (const Error& error) {
            fail_at(where(), "pass \"{}\", variable \"{}\": {}", name(), variable.name, error.what());
        }
    }
}

int Pass::place_of_choice(const VariableDescriptor& variable) const {
    const std::vector<std::string>& choices = variable.choices;
    return int(std::find(choices.begin(), choices.end(), std::get<std::string>(value(variable.name))) -
               choices.begin());
}

const gpu::Texture* Pass::texture(std::string_view name) const {
    const auto found = textures_.find(name);
    return found == textures_.end() ? nullptr : found->second.get();
}

void Pass::apply_parameters(const gpu::Program& program, int first_unit) const {
    int unit = first_unit;
    for (const VariableDescriptor& variable : component().variables) {
        if (!variable.vertex_parameter && !variable.fragment_parameter) continue;
        if (!variable.choices.empty()) {
            program.set(variable.name, place_of_choice(variable));
            continue;
        }
        if (variable.type != VariableType::texture) {
            std::visit(SetUniform{program, variable.name}, value(variable.name));
            continue;
        }
        const std::string sampler = variable.name + "_sampler";
        if (!program.uses(sampler)) continue;
        const gpu::Texture* bound = texture(variable.name);
        (bound != nullptr ? *bound : resources_->white()).bind(unit);
        program.set(sampler, unit++);
    }
}

}  // namespace croquis::framework
