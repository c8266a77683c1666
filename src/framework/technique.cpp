#include "framework/technique.h"

#include "base/error.h"
#include "base/names.h"

namespace croquis::framework {
namespace {

std::unique_ptr<Component> create(const Pass& pass, const ComponentTable& components) {
    const auto found = components.find(pass.component().core);
    if (found == components.end()) {
        fail_at(pass.where(), "component {} has no implementation: {} is none of the core components",
                pass.component().name, pass.component().core);
    }
    try {
        return found->second(pass);
    } catch (const Error& error) {
        fail_at(pass.where(), "pass \"{}\": {}", pass.name(), error.what());
    }
}

}  // namespace

Technique::Technique(std::shared_ptr<const Library> library, const TechniqueDefinition& definition,
                     Resources& resources, const ComponentTable& components)
    : library_(std::move(library)), name_(definition.name), help_(definition.help), generated_(resources.gpu()) {
    for (const PassDefinition& pass_definition : definition.passes) {
        Step& step = steps_.emplace_back();
        step.pass = std::make_unique<Pass>(pass_definition, resources, generated_);
        step.component = create(*step.pass, components);
    }
    for (Step& step : steps_) step.pass->find_textures();
}

std::vector<std::string> Technique::pass_names() const {
    std::vector<std::string> names;
    for (const Step& step : steps_) names.push_back(step.pass->name());
    return names;
}

const Technique::Step& Technique::step(std::string_view name) const {
    for (const Step& step : steps_) {
        if (step.pass->name() == name) return step;
    }
    fail("technique {} has no pass \"{}\"{}", name_, name, suggestion(name, pass_names()));
}

const Pass& Technique::pass(std::string_view name) const { return *step(name).pass; }

TechniqueDefinition Technique::definition() const {
    TechniqueDefinition definition{.name = name_, .help = help_, .passes = {}};
    for (const Step& step : steps_) definition.passes.push_back(step.pass->definition());
    return definition;
}

std::size_t Technique::line_count(std::string_view pass) const { return step(pass).component->line_count(); }

void Technique::set(std::string_view pass, std::string_view variable, const Value& value) {
    const Step& changed = step(pass);
    const bool exists = changed.pass->has(variable);
    const Value before = exists ? changed.pass->value(variable) : Value{};
    changed.pass->set(variable, value);
    try {
        changed.component->variable_changed(variable);
    } catch (const Error&) {
        changed.pass->set(variable, before);
        throw;
    }
}

void Technique::draw(RenderContext& context, gpu::StretchTimer* timer) {
    for (const Step& step : steps_) step.component->start(context);
    for (const Step& step : steps_) {
        if (timer) timer->begin();
        step.component->draw(context);
        if (timer) timer->end();
    }
}

}  // namespace croquis::framework
